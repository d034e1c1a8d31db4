//! The shape of an item, and the kinds of shapes that a tracer supports.

use super::{ShapeKind, ShapeKindSet, Sphere};

/// The shape of one item: its data, or, for larger shapes, an index into a table of
/// [`Geometry`](super::Geometry).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum Shape {
    /// A sphere.
    Sphere(Sphere),
    /// A flat triangle: indices of its vertices.
    Triangle([u32; 3]),
    /// A triangle with interpolated shading normals: indices of its vertices, which are also the indices of
    /// their normals.
    SmoothTriangle([u32; 3]),
    /// An infinite plane: index in the table of planes.
    Plane(u32),
    /// A disc: index in the table of discs.
    Disc(u32),
    /// A polygon: index in the table of polygons.
    Polygon(u32),
    /// An axis-aligned box: index in the table of cuboids.
    Cuboid(u32),
    /// An oriented box: index in the table of oriented cuboids.
    OrientedCuboid(u32),
    /// A cone or cylinder: index in the table of cones.
    Cone(u32),
    /// A torus: index in the table of tori.
    Torus(u32),
    /// A moving shape of any kind: index in the table of moving shapes.
    Moving(u32),
}

// A larger shape would increase the size of all items.
#[cfg(not(feature = "double"))]
const _: () = assert!(size_of::<Shape>() <= 20);

/// The shapes that a tracer supports, as constants. Code for all others is not compiled, and rays never hit
/// them.
///
/// Implemented for every [`Effects`](crate::scene::Effects): programs implement that trait, not this one.
pub trait ShapeFeatures {
    /// Supported kinds of shapes.
    const SHAPES: ShapeKindSet;
    /// Whether shading normals of smooth triangles and polygons are interpolated. If not, these are shaded
    /// flat.
    const SMOOTH_SHADING: bool;
    /// Whether moving shapes are supported. If not, rays never hit them.
    const MOTION_BLUR: bool = false;
}

impl Shape {
    /// Whether the shape is a flat or smooth triangle.
    pub(crate) const fn is_triangle(self) -> bool {
        matches!(self, Shape::Triangle(_) | Shape::SmoothTriangle(_))
    }

    /// The kind of the shape; `None` for a moving shape, whose kind is
    /// [`Geometry::kind`](super::Geometry::kind).
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
            Shape::OrientedCuboid(_) => ShapeKind::OrientedCuboid,
            Shape::Cone(_) => ShapeKind::Cone,
            Shape::Torus(_) => ShapeKind::Torus,
            Shape::Moving(_) => return None,
        })
    }
}

/// Supports all shapes.
pub(super) struct AllShapes;

impl ShapeFeatures for AllShapes {
    const SHAPES: ShapeKindSet = ShapeKindSet::ALL;
    const SMOOTH_SHADING: bool = true;
    const MOTION_BLUR: bool = true;
}
