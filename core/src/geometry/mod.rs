//! Shapes: what a ray can meet, where, and what the surface is like there.
//!
//! All items lie in one slice of [`Shape`]s. Small shapes stand there themselves; a larger one
//! is the index of its place in a table of its own, and triangles are indices into shared
//! tables of points. So an item takes 20 bytes, and a mesh no more than its triangles.

mod bounds;
mod cone;
mod cuboid;
mod disc;
mod hit;
mod plane;
mod polygon;
mod ray;
mod sphere;
mod torus;
mod triangle;

pub use bounds::{Aabb, Span};
pub use cone::Cone;
pub use cuboid::{Cuboid, TurnedCuboid};
pub use disc::Disc;
pub use hit::{Hit, ItemId, Surface};
pub use plane::Plane;
pub use polygon::Polygon;
pub use ray::{Ray, leave};
pub use sphere::Sphere;
pub use torus::Torus;

use crate::math::{FARTHEST, Real, Vec3, is_in_range, is_unit};
use crate::set::set_of;

/// One item of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A sphere.
    Sphere(Sphere),
    /// A triangle: the places of its corners in the table of points.
    Triangle([u32; 3]),
    /// A triangle whose shading normal is interpolated: the places of its corners in the table
    /// of points, and of their normals in that of the normals.
    SmoothTriangle([u32; 3]),
    /// The place in the table of planes.
    Plane(u32),
    /// The place in the table of discs.
    Disc(u32),
    /// The place in the table of polygons.
    Polygon(u32),
    /// The place in the table of upright boxes.
    Cuboid(u32),
    /// The place in the table of turned boxes.
    TurnedCuboid(u32),
    /// The place in the table of cones and cylinders.
    Cone(u32),
    /// The place in the table of tori.
    Torus(u32),
}

// Larger shapes belong into tables, or every item of every scene would pay for them.
#[cfg(not(feature = "double"))]
const _: () = assert!(size_of::<Shape>() <= 20);

/// What kind of shape an item is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)] // they name what `Shape` describes
pub enum ShapeKind {
    Sphere,
    Triangle,
    SmoothTriangle,
    Plane,
    Disc,
    Polygon,
    Cuboid,
    TurnedCuboid,
    Cone,
    Torus,
}

impl ShapeKind {
    /// Every kind.
    pub const ALL: [ShapeKind; 10] = [
        ShapeKind::Sphere,
        ShapeKind::Triangle,
        ShapeKind::SmoothTriangle,
        ShapeKind::Plane,
        ShapeKind::Disc,
        ShapeKind::Polygon,
        ShapeKind::Cuboid,
        ShapeKind::TurnedCuboid,
        ShapeKind::Cone,
        ShapeKind::Torus,
    ];

    /// The name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            ShapeKind::Sphere => "sphere",
            ShapeKind::Triangle => "triangle",
            ShapeKind::SmoothTriangle => "smooth triangle",
            ShapeKind::Plane => "plane",
            ShapeKind::Disc => "disc",
            ShapeKind::Polygon => "polygon",
            ShapeKind::Cuboid => "box",
            ShapeKind::TurnedCuboid => "turned box",
            ShapeKind::Cone => "cone",
            ShapeKind::Torus => "torus",
        }
    }
}

set_of! {
    /// Kinds of shapes.
    ShapeSet of ShapeKind
}

/// What a tracer's geometry can do. Every arm outside is compiled away.
pub trait Shapes {
    /// The shapes that can be met.
    const SHAPES: ShapeSet;
    /// Whether shading normals are interpolated over smooth triangles and polygons.
    const SMOOTH: bool;
}

impl Shape {
    /// What kind it is.
    pub const fn kind(self) -> ShapeKind {
        match self {
            Shape::Sphere(_) => ShapeKind::Sphere,
            Shape::Triangle(_) => ShapeKind::Triangle,
            Shape::SmoothTriangle(_) => ShapeKind::SmoothTriangle,
            Shape::Plane(_) => ShapeKind::Plane,
            Shape::Disc(_) => ShapeKind::Disc,
            Shape::Polygon(_) => ShapeKind::Polygon,
            Shape::Cuboid(_) => ShapeKind::Cuboid,
            Shape::TurnedCuboid(_) => ShapeKind::TurnedCuboid,
            Shape::Cone(_) => ShapeKind::Cone,
            Shape::Torus(_) => ShapeKind::Torus,
        }
    }
}

/// Why a shape cannot be part of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShapeFault {
    /// A coordinate is no number, or farther from zero than [`FARTHEST`].
    Place,
    /// A radius is no number, out of range, or leaves no shape.
    Radius,
    /// A length is no number, out of range, or leaves no shape.
    Size,
    /// A direction does not have length one.
    NotUnit,
    /// The axes of a turned box are not upright on each other.
    Axes,
    /// It refers to a place outside its table, or a polygon has fewer than three corners.
    Missing,
    /// A plane does not stand in the table of planes under its own item.
    Plane,
}

impl core::fmt::Display for ShapeFault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            ShapeFault::Place => "a coordinate is not within 1e15 of zero",
            ShapeFault::Radius => "its radius leaves no shape, or is over 1e15",
            ShapeFault::Size => "its size leaves no shape, or is over 1e15",
            ShapeFault::NotUnit => "a direction does not have length one",
            ShapeFault::Axes => "its axes are not upright on each other",
            ShapeFault::Missing => "it refers to a place outside its table",
            ShapeFault::Plane => "its place in the table of planes names another item",
        })
    }
}

impl core::error::Error for ShapeFault {}

fn check_point(p: Vec3) -> Result<(), ShapeFault> {
    if is_in_range(p) { Ok(()) } else { Err(ShapeFault::Place) }
}

fn check_unit(n: Vec3) -> Result<(), ShapeFault> {
    if is_unit(n) { Ok(()) } else { Err(ShapeFault::NotUnit) }
}

fn check_radius(center: Vec3, radius: Real) -> Result<(), ShapeFault> {
    check_point(center)?;
    if radius > 0.0 && radius <= FARTHEST { Ok(()) } else { Err(ShapeFault::Radius) }
}

/// All shapes of a scene, and the tables that they refer to.
///
/// Plain borrowed slices, which may lie in flash. [`Geometry::check`] says whether they fit
/// together; a reference that does not would be a miss, never a fault.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<'s> {
    /// The items, by their number.
    pub shapes: &'s [Shape],
    /// Corners of triangles and polygons.
    pub points: &'s [Vec3],
    /// Normals of length one of those of the corners that smooth shapes refer to: the normal of
    /// a corner has the corner's place.
    pub normals: &'s [Vec3],
    /// All planes.
    pub planes: &'s [Plane],
    /// All discs.
    pub discs: &'s [Disc],
    /// All polygons.
    pub polygons: &'s [Polygon],
    /// All upright boxes.
    pub cuboids: &'s [Cuboid],
    /// All turned boxes.
    pub turned_cuboids: &'s [TurnedCuboid],
    /// All cones and cylinders.
    pub cones: &'s [Cone],
    /// All tori.
    pub tori: &'s [Torus],
}

/// An entry of a table.
fn of<T>(table: &[T], place: u32) -> Option<&T> {
    table.get(place as usize)
}

impl<'s> Geometry<'s> {
    /// Nothing at all; a scene names what it has and takes the rest from here.
    pub const EMPTY: Geometry<'static> = Geometry {
        shapes: &[],
        points: &[],
        normals: &[],
        planes: &[],
        discs: &[],
        polygons: &[],
        cuboids: &[],
        turned_cuboids: &[],
        cones: &[],
        tori: &[],
    };

    /// Whether every shape is one and finds what it refers to; else the first that does not.
    pub fn check(&self) -> Result<(), (ItemId, ShapeFault)> {
        if self.points.iter().any(|p| !is_in_range(*p)) {
            return Err((ItemId(0), ShapeFault::Place));
        }
        if self.normals.iter().any(|n| !is_unit(*n)) {
            return Err((ItemId(0), ShapeFault::NotUnit));
        }
        for (shape, number) in self.shapes.iter().zip(0..) {
            self.check_shape(*shape, ItemId(number)).map_err(|fault| (ItemId(number), fault))?;
        }
        // Planes are met through their table, so each must be an item.
        for (plane, place) in self.planes.iter().zip(0..) {
            if of(self.shapes, plane.item.0) != Some(&Shape::Plane(place)) {
                return Err((plane.item, ShapeFault::Plane));
            }
        }
        Ok(())
    }

    fn check_shape(&self, shape: Shape, item: ItemId) -> Result<(), ShapeFault> {
        let missing = ShapeFault::Missing;
        match shape {
            Shape::Sphere(sphere) => sphere.check(),
            Shape::Triangle(corners) => match self.corners(corners) {
                Some(_) => Ok(()),
                None => Err(missing),
            },
            Shape::SmoothTriangle(corners) => match (self.corners(corners), self.corner_normals(corners)) {
                (Some(_), Some(_)) => Ok(()),
                _ => Err(missing),
            },
            Shape::Plane(place) => {
                let plane = of(self.planes, place).ok_or(missing)?;
                plane.check()?;
                if plane.item == item { Ok(()) } else { Err(ShapeFault::Plane) }
            }
            Shape::Disc(place) => of(self.discs, place).ok_or(missing)?.check(),
            Shape::Polygon(place) => {
                of(self.polygons, place).ok_or(missing)?.check(self.points, self.normals)
            }
            Shape::Cuboid(place) => of(self.cuboids, place).ok_or(missing)?.check(),
            Shape::TurnedCuboid(place) => of(self.turned_cuboids, place).ok_or(missing)?.check(),
            Shape::Cone(place) => of(self.cones, place).ok_or(missing)?.check(),
            Shape::Torus(place) => of(self.tori, place).ok_or(missing)?.check(),
        }
    }

    /// The shape of an item.
    pub fn shape(&self, item: ItemId) -> Option<Shape> {
        of(self.shapes, item.0).copied()
    }

    fn corners(&self, [a, b, c]: [u32; 3]) -> Option<[Vec3; 3]> {
        Some([*of(self.points, a)?, *of(self.points, b)?, *of(self.points, c)?])
    }

    fn corner_normals(&self, [a, b, c]: [u32; 3]) -> Option<[Vec3; 3]> {
        Some([*of(self.normals, a)?, *of(self.normals, b)?, *of(self.normals, c)?])
    }

    /// The box round an item, rounded outward; none for a plane, which has no end.
    pub fn bounds(&self, item: ItemId) -> Option<Aabb> {
        self.shape_bounds::<AllShapes>(self.shape(item)?)
    }

    /// The boxes round all items, in their order; planes have [`Aabb::EMPTY`].
    pub fn all_bounds(&self) -> impl Iterator<Item = Aabb> + '_ {
        let geometry = *self;
        self.shapes.iter().map(move |shape| geometry.shape_bounds::<AllShapes>(*shape).unwrap_or(Aabb::EMPTY))
    }

    fn shape_bounds<S: Shapes>(&self, shape: Shape) -> Option<Aabb> {
        if !S::SHAPES.has(shape.kind()) {
            return None;
        }
        match shape {
            Shape::Sphere(sphere) => Some(sphere.bounds()),
            Shape::Triangle(corners) | Shape::SmoothTriangle(corners) => {
                self.corners(corners).map(triangle::bounds)
            }
            Shape::Plane(_) => None,
            Shape::Disc(place) => of(self.discs, place).map(Disc::bounds),
            Shape::Polygon(place) => of(self.polygons, place).map(|p| p.bounds(self.points)),
            Shape::Cuboid(place) => of(self.cuboids, place).map(Cuboid::bounds),
            Shape::TurnedCuboid(place) => of(self.turned_cuboids, place).map(TurnedCuboid::bounds),
            Shape::Cone(place) => of(self.cones, place).map(Cone::bounds),
            Shape::Torus(place) => of(self.tori, place).map(Torus::bounds),
        }
    }

    /// How far along the ray a shape is first met, from either side: more than zero and
    /// finite.
    ///
    /// The distance is moved into the interval in which the ray is inside the shape's own box,
    /// and where there is no such interval there is no hit. Rounding may have put it a little
    /// outside, and an accelerator that leaves out the box would then give another picture
    /// than one that does not.
    #[inline]
    pub fn distance<S: Shapes>(&self, shape: Shape, ray: &Ray) -> Option<Real> {
        let is_distance = |t: &Real| *t > 0.0 && *t <= Real::MAX;
        let t = self.raw_distance::<S>(shape, ray).filter(is_distance)?;
        if let Shape::Plane(_) = shape {
            return Some(t);
        }
        let span = self.shape_bounds::<S>(shape)?.span(ray)?;
        let t = if t < span.entry { span.entry } else { t };
        let t = if t > span.exit { span.exit } else { t };
        Some(t).filter(is_distance)
    }

    #[inline]
    fn raw_distance<S: Shapes>(&self, shape: Shape, ray: &Ray) -> Option<Real> {
        if !S::SHAPES.has(shape.kind()) {
            return None;
        }
        match shape {
            Shape::Sphere(sphere) => sphere.hit(ray),
            Shape::Triangle(corners) | Shape::SmoothTriangle(corners) => {
                triangle::hit(self.corners(corners)?, ray).map(|contact| contact.t)
            }
            Shape::Plane(place) => of(self.planes, place)?.hit(ray),
            Shape::Disc(place) => of(self.discs, place)?.hit(ray),
            Shape::Polygon(place) => of(self.polygons, place)?.hit(self.points, ray),
            Shape::Cuboid(place) => of(self.cuboids, place)?.hit(ray),
            Shape::TurnedCuboid(place) => of(self.turned_cuboids, place)?.hit(ray),
            Shape::Cone(place) => of(self.cones, place)?.hit(ray),
            Shape::Torus(place) => of(self.tori, place)?.hit(ray),
        }
    }

    /// What a shape is like where the ray meets it, `t` away as [`Geometry::distance`] said.
    pub fn surface<S: Shapes>(&self, shape: Shape, ray: &Ray, t: Real) -> Option<Surface> {
        if !S::SHAPES.has(shape.kind()) {
            return None;
        }
        match shape {
            Shape::Sphere(sphere) => Some(sphere.surface(ray, t)),
            Shape::Triangle(corners) => triangle::surface(self.corners(corners)?, None, ray),
            Shape::SmoothTriangle(corners) => {
                let normals = if S::SMOOTH { self.corner_normals(corners) } else { None };
                triangle::surface(self.corners(corners)?, normals, ray)
            }
            Shape::Plane(place) => Some(of(self.planes, place)?.surface(ray, t)),
            Shape::Disc(place) => Some(of(self.discs, place)?.surface(ray, t)),
            Shape::Polygon(place) => {
                let normals = if S::SMOOTH { Some(self.normals) } else { None };
                Some(of(self.polygons, place)?.surface(self.points, normals, ray, t))
            }
            Shape::Cuboid(place) => of(self.cuboids, place)?.surface(ray, t),
            Shape::TurnedCuboid(place) => of(self.turned_cuboids, place)?.surface(ray, t),
            Shape::Cone(place) => of(self.cones, place)?.surface(ray, t),
            Shape::Torus(place) => Some(of(self.tori, place)?.surface(ray, t)),
        }
    }
}

/// Every shape there is.
struct AllShapes;

impl Shapes for AllShapes {
    const SHAPES: ShapeSet = ShapeSet::ALL;
    const SMOOTH: bool = true;
}
