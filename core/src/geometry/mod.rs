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
#[cfg(not(feature = "double"))]
mod fault;
mod four;
mod hit;
#[cfg(not(feature = "double"))]
mod item;
#[cfg(not(feature = "double"))]
mod kind;
mod meet;
mod moving;
mod plane;
mod polygon;
mod ray;
mod shape;
mod sphere;
mod terminator;
mod torus;
mod triangle;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::{self as fault, self as item, self as kind};

pub use ball::Ball;
pub(crate) use ball::Line;
pub(crate) use bounds::WIDEN;
pub use bounds::{Aabb, Span};
pub use cone::Cone;
pub use cuboid::{Cuboid, TurnedCuboid};
pub use disc::Disc;
pub use fault::ShapeFault;
pub(crate) use four::FourTriangles;
pub use hit::{Hit, Surface};
pub use item::ItemId;
pub use kind::{ShapeKind, ShapeSet};
pub(crate) use meet::triangle_distance;
pub use moving::Moving;
pub use plane::Plane;
pub use polygon::Polygon;
pub use ray::{Ray, leave};
pub use shape::{Shape, Shapes};
pub use sphere::Sphere;
pub use torus::Torus;
pub use triangle::has_area;

use crate::math::Vec3;
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
}
