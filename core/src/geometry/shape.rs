//! What an item can be.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::{ShapeFault, ShapeKind, ShapeSet, Sphere};
use crate::math::{FARTHEST, Real, Vec3, is_in_range, is_unit};

/// One item of the scene.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(u32)]
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
    /// The place in the table of what moves, which has its shape.
    Moving(u32),
}

// Larger shapes belong into tables, or every item of every scene would pay for them.
#[cfg(not(feature = "double"))]
const _: () = assert!(size_of::<Shape>() <= 20);

/// What a tracer's geometry can do. Every arm outside is compiled away.
pub trait Shapes {
    /// The shapes that can be met.
    const SHAPES: ShapeSet;
    /// Whether shading normals are interpolated over smooth triangles and polygons.
    const SMOOTH: bool;
    /// Whether what moves can be met.
    const MOTION: bool = false;
}

impl Shape {
    /// Whether it is a triangle, smooth or flat.
    pub(crate) const fn is_triangle(self) -> bool {
        matches!(self, Shape::Triangle(_) | Shape::SmoothTriangle(_))
    }

    /// What kind it is; none for what moves: [`Geometry::kind`](super::Geometry::kind) knows of its shape.
    #[inline(always)]
    pub const fn kind(self) -> Option<ShapeKind> {
        Some(match self {
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
            Shape::Moving(_) => return None,
        })
    }
}

pub(super) fn check_point(p: Vec3) -> Result<(), ShapeFault> {
    if is_in_range(p) { Ok(()) } else { Err(ShapeFault::Place) }
}

pub(super) fn check_unit(n: Vec3) -> Result<(), ShapeFault> {
    if is_unit(n) { Ok(()) } else { Err(ShapeFault::NotUnit) }
}

pub(super) fn check_radius(center: Vec3, radius: Real) -> Result<(), ShapeFault> {
    check_point(center)?;
    if radius > 0.0 && radius <= FARTHEST { Ok(()) } else { Err(ShapeFault::Radius) }
}

/// Every shape there is.
pub(super) struct AllShapes;

impl Shapes for AllShapes {
    const SHAPES: ShapeSet = ShapeSet::ALL;
    const SMOOTH: bool = true;
    const MOTION: bool = true;
}
