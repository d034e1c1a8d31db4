//! Shapes: what a ray can meet, where, and what the surface is like there.
//!
//! All items lie in one slice of [`Shape`]s. Small shapes stand there themselves; a larger one
//! is the index of its place in a table of its own, and triangles are indices into shared
//! tables of points. So an item takes 20 bytes, and a mesh no more than its triangles.

mod ball;
mod bounds;
mod check;
mod cone;
mod cuboid;
mod disc;
mod four;
mod hit;
mod moving;
mod plane;
mod polygon;
mod ray;
mod shape;
mod sphere;
mod terminator;
mod torus;
mod triangle;

pub use ball::Ball;
pub(crate) use ball::Line;
pub(crate) use bounds::WIDEN;
pub use bounds::{Aabb, Span};
pub use cone::Cone;
pub use cuboid::{Cuboid, TurnedCuboid};
pub use disc::Disc;
pub(crate) use four::FourTriangles;
pub use hit::{Hit, ItemId, Surface};
pub use moving::Moving;
pub use plane::Plane;
pub use polygon::Polygon;
pub use ray::{Ray, leave};
pub use shape::{Shape, ShapeFault, ShapeKind, ShapeSet, Shapes};
pub use sphere::Sphere;
pub use torus::Torus;
pub use triangle::has_area;

use crate::math::{Real, Vec3, vec3};
use shape::{AllShapes, check_point, check_radius, check_unit};

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
    /// All that moves while the shutter is open.
    pub moving: &'s [Moving],
}

/// Whether it may be how far something is: more than zero, and finite.
fn is_distance(t: &Real) -> bool {
    *t > 0.0 && *t <= Real::MAX
}

/// An entry of a table.
fn of<T>(table: &[T], place: u32) -> Option<&T> {
    table.get(place as usize)
}

/// How far along the ray a triangle is met, as [`Geometry::distance`] says.
#[inline]
pub(crate) fn triangle_distance(corners: [&Vec3; 3], ray: &Ray) -> Option<Real> {
    let t = triangle::hit(corners, ray).map(|contact| contact.t).filter(is_distance)?;
    moved_into(triangle::bounds(corners), t, ray.origin, ray.inverse)
}

/// The distance nearest to `t` at which the ray is inside a box.
#[inline(always)]
fn moved_into(aabb: Aabb, t: Real, origin: Vec3, inverse: Vec3) -> Option<Real> {
    let span = aabb.span_along(origin, inverse)?;
    let t = if t < span.entry { span.entry } else { t };
    let t = if t > span.exit { span.exit } else { t };
    Some(t).filter(is_distance)
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
        moving: &[],
    };

    /// The memory that all tables take, in bytes.
    pub const fn bytes(&self) -> usize {
        size_of_val(self.shapes)
            + size_of_val(self.points)
            + size_of_val(self.normals)
            + size_of_val(self.planes)
            + size_of_val(self.discs)
            + size_of_val(self.polygons)
            + size_of_val(self.cuboids)
            + size_of_val(self.turned_cuboids)
            + size_of_val(self.cones)
            + size_of_val(self.tori)
            + size_of_val(self.moving)
    }

    /// The shape of an item.
    pub fn shape(&self, item: ItemId) -> Option<&'s Shape> {
        of(self.shapes, item.0)
    }

    /// The shape itself, or the one that moves.
    pub(crate) fn at_rest(&self, shape: &'s Shape) -> Option<&'s Shape> {
        match shape {
            Shape::Moving(place) => Some(&self.moving(*place)?.shape),
            _ => Some(shape),
        }
    }

    pub(crate) fn corners(&self, [a, b, c]: [u32; 3]) -> Option<[&'s Vec3; 3]> {
        Some([of(self.points, a)?, of(self.points, b)?, of(self.points, c)?])
    }

    fn corner_normals(&self, [a, b, c]: [u32; 3]) -> Option<[Vec3; 3]> {
        Some([*of(self.normals, a)?, *of(self.normals, b)?, *of(self.normals, c)?])
    }

    /// The box round an item, rounded outward; none for a plane, which has no end.
    pub fn bounds(&self, item: ItemId) -> Option<Aabb> {
        self.shape_bounds::<AllShapes>(*self.shape(item)?)
    }

    /// The boxes round all items, in their order; planes have [`Aabb::EMPTY`].
    pub fn all_bounds(&self) -> impl Iterator<Item = Aabb> + '_ {
        let geometry = *self;
        self.shapes.iter().map(move |shape| geometry.shape_bounds::<AllShapes>(*shape).unwrap_or(Aabb::EMPTY))
    }

    fn shape_bounds<S: Shapes>(&self, shape: Shape) -> Option<Aabb> {
        if S::MOTION
            && let Shape::Moving(place) = shape
        {
            return self.moving_bounds::<S>(place);
        }
        self.rest_bounds::<S>(shape)
    }

    fn rest_bounds<S: Shapes>(&self, shape: Shape) -> Option<Aabb> {
        if !shape.kind().is_some_and(|kind| S::SHAPES.has(kind)) {
            return None;
        }
        match shape {
            Shape::Sphere(sphere) => Some(sphere.bounds()),
            Shape::Triangle(corners) | Shape::SmoothTriangle(corners) => {
                self.corners(corners).map(triangle::bounds)
            }
            Shape::Plane(_) => None,
            Shape::Disc(place) => of(self.discs, place).map(Disc::bounds),
            Shape::Polygon(place) => of(self.polygons, place).map(|polygon| polygon.bounds),
            Shape::Cuboid(place) => of(self.cuboids, place).map(Cuboid::bounds),
            Shape::TurnedCuboid(place) => of(self.turned_cuboids, place).map(TurnedCuboid::bounds),
            Shape::Cone(place) => of(self.cones, place).map(Cone::bounds),
            Shape::Torus(place) => of(self.tori, place).map(Torus::bounds),
            Shape::Moving(_) => None,
        }
    }

    /// How far along the ray a shape is first met, from either side: more than zero and
    /// finite.
    ///
    /// The distance is moved into the interval in which the ray is inside the shape's own box,
    /// and where there is no such interval there is no hit. Rounding may have put it a little
    /// outside, and an accelerator that leaves out the box would then give another picture
    /// than one that does not.
    #[inline(always)]
    pub fn distance<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        if S::MOTION
            && let Shape::Moving(place) = shape
        {
            return self.moving_distance::<S>(*place, ray);
        }
        self.rest_distance::<S>(shape, ray)
    }

    /// As [`Geometry::distance`], of what does not move.
    #[inline(always)]
    fn rest_distance<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        // Few kinds are worth a copy at each of the places that ask.
        if S::SHAPES.len() <= 2 {
            return self.distance_here::<S>(shape, ray);
        }
        // Spheres are so cheap that the way there would cost more.
        if S::SHAPES.has(ShapeKind::Sphere)
            && let Shape::Sphere(sphere) = shape
        {
            return self.sphere_distance::<S>(sphere, shape, ray);
        }
        self.distance_there::<S>(shape, ray)
    }

    #[inline(never)]
    fn distance_there<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        self.distance_here::<S>(shape, ray)
    }

    #[inline(always)]
    fn distance_here<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        // Guards for each arm, and not one test before all of them, are known when compiling.
        // The first two are not arms of the match, where they would become a table of the kinds.
        let can = |kind| S::SHAPES.has(kind);
        if can(ShapeKind::Sphere)
            && let Shape::Sphere(sphere) = shape
        {
            return self.sphere_distance::<S>(sphere, shape, ray);
        }
        if can(ShapeKind::Polygon)
            && let Shape::Polygon(place) = shape
        {
            return of(self.polygons, *place)?.hit(self.points, ray);
        }
        let t = self.raw_distance::<S>(shape, ray).filter(is_distance)?;
        match shape {
            Shape::Plane(_) => Some(t),
            _ => self.within_bounds::<S>(shape, t, ray),
        }
    }

    #[inline(always)]
    fn sphere_distance<S: Shapes>(&self, sphere: &Sphere, shape: &Shape, ray: &Ray) -> Option<Real> {
        let t = sphere.hit(ray).filter(is_distance)?;
        if sphere.is_surely_in_its_box(ray, t) { Some(t) } else { self.within_bounds::<S>(shape, t, ray) }
    }

    /// The distance moved into the shape's own box.
    fn within_bounds<S: Shapes>(&self, shape: &Shape, t: Real, ray: &Ray) -> Option<Real> {
        /// Not inlined, because most rays miss most items, and a miss should be short.
        #[inline(never)]
        #[allow(clippy::too_many_arguments)] // in registers: what lies in memory, all of it must be made for
        fn apart<S: Shapes>(
            geometry: &Geometry<'_>,
            shape: &Shape,
            t: Real,
            ox: Real,
            oy: Real,
            oz: Real,
            dx: Real,
            dy: Real,
            dz: Real,
        ) -> Option<Real> {
            // Rays that meet no box then need no reciprocal.
            let inverse = 1.0 / vec3(dx, dy, dz);
            moved_into(geometry.rest_bounds::<S>(*shape)?, t, vec3(ox, oy, oz), inverse)
        }
        let (o, d) = (ray.origin, ray.direction);
        apart::<S>(self, shape, t, o.x, o.y, o.z, d.x, d.y, d.z)
    }

    /// Of the shapes that [`Geometry::distance`] has not answered for itself, before the distance
    /// is moved.
    #[inline(always)]
    fn raw_distance<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        let can = |kind| S::SHAPES.has(kind);
        match *shape {
            Shape::Triangle(corners) if can(ShapeKind::Triangle) => self.triangle_distance(corners, ray),
            Shape::SmoothTriangle(corners) if can(ShapeKind::SmoothTriangle) => {
                self.triangle_distance(corners, ray)
            }
            Shape::Plane(place) if can(ShapeKind::Plane) => of(self.planes, place)?.hit(ray),
            Shape::Disc(place) if can(ShapeKind::Disc) => of(self.discs, place)?.hit(ray),
            Shape::Cuboid(place) if can(ShapeKind::Cuboid) => of(self.cuboids, place)?.hit(ray),
            Shape::TurnedCuboid(place) if can(ShapeKind::TurnedCuboid) => {
                of(self.turned_cuboids, place)?.hit(ray)
            }
            Shape::Cone(place) if can(ShapeKind::Cone) => of(self.cones, place)?.hit(ray),
            Shape::Torus(place) if can(ShapeKind::Torus) => of(self.tori, place)?.hit(ray),
            _ => None,
        }
    }

    #[inline(always)]
    fn triangle_distance(&self, corners: [u32; 3], ray: &Ray) -> Option<Real> {
        triangle::hit(self.corners(corners)?, ray).map(|contact| contact.t)
    }

    /// What a shape is like where the ray meets it, `t` away as [`Geometry::distance`] said.
    pub fn surface<S: Shapes>(&self, shape: &Shape, ray: &Ray, t: Real) -> Option<Surface> {
        if S::MOTION
            && let Shape::Moving(place) = shape
        {
            return self.moving_surface::<S>(*place, ray, t);
        }
        self.rest_surface::<S>(shape, ray, t)
    }

    fn rest_surface<S: Shapes>(&self, shape: &Shape, ray: &Ray, t: Real) -> Option<Surface> {
        let can = |kind| S::SHAPES.has(kind);
        match *shape {
            Shape::Sphere(sphere) if can(ShapeKind::Sphere) => Some(sphere.surface(ray, t)),
            Shape::Triangle(corners) if can(ShapeKind::Triangle) => {
                triangle::surface(self.corners(corners)?, None, ray)
            }
            Shape::SmoothTriangle(corners) if can(ShapeKind::SmoothTriangle) => {
                let normals = if S::SMOOTH { self.corner_normals(corners) } else { None };
                triangle::surface(self.corners(corners)?, normals, ray)
            }
            Shape::Plane(place) if can(ShapeKind::Plane) => Some(of(self.planes, place)?.surface(ray, t)),
            Shape::Disc(place) if can(ShapeKind::Disc) => Some(of(self.discs, place)?.surface(ray, t)),
            Shape::Polygon(place) if can(ShapeKind::Polygon) => {
                let normals = if S::SMOOTH { Some(self.normals) } else { None };
                Some(of(self.polygons, place)?.surface(self.points, normals, ray, t))
            }
            Shape::Cuboid(place) if can(ShapeKind::Cuboid) => of(self.cuboids, place)?.surface(ray, t),
            Shape::TurnedCuboid(place) if can(ShapeKind::TurnedCuboid) => {
                of(self.turned_cuboids, place)?.surface(ray, t)
            }
            Shape::Cone(place) if can(ShapeKind::Cone) => of(self.cones, place)?.surface(ray, t),
            Shape::Torus(place) if can(ShapeKind::Torus) => Some(of(self.tori, place)?.surface(ray, t)),
            _ => None,
        }
    }
}
