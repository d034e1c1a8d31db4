//! What an item can be, and why a shape can be refused.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::Sphere;
use crate::math::{FARTHEST, Real, Vec3, is_in_range, is_unit};
use crate::set::set_of;

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
    /// The box of a polygon is not the one round its corners.
    Bounds,
    /// A plane does not stand in the table of planes under its own item.
    Plane,
    /// What moves is itself something that moves.
    Moving,
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
            ShapeFault::Bounds => "its box is not the one round its corners",
            ShapeFault::Plane => "its place in the table of planes names another item",
            ShapeFault::Moving => "what moves is itself something that moves",
        })
    }
}

impl core::error::Error for ShapeFault {}

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
