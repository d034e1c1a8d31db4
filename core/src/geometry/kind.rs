//! Kinds of shapes, and sets of them.

use crate::set::{all_kinds, bit_set};

/// The kind of a shape: a variant of [`Shape`](super::Shape) without its data. A moving shape has the kind
/// of the shape that moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ShapeKind {
    /// A sphere.
    Sphere,
    /// A flat triangle.
    Triangle,
    /// A triangle with interpolated shading normals.
    SmoothTriangle,
    /// An infinite plane.
    Plane,
    /// A disc.
    Disc,
    /// A flat or smooth polygon.
    Polygon,
    /// An axis-aligned box.
    Cuboid,
    /// An oriented box.
    OrientedCuboid,
    /// A cone or cylinder.
    Cone,
    /// A torus.
    Torus,
}

all_kinds! {
    ShapeKind {
        Sphere,
        Triangle,
        SmoothTriangle,
        Plane,
        Disc,
        Polygon,
        Cuboid,
        OrientedCuboid,
        Cone,
        Torus,
    }
}

impl ShapeKind {
    /// Lowercase name, with spaces: `sphere`, for example.
    pub const fn name(self) -> &'static str {
        match self {
            ShapeKind::Sphere => "sphere",
            ShapeKind::Triangle => "triangle",
            ShapeKind::SmoothTriangle => "smooth triangle",
            ShapeKind::Plane => "plane",
            ShapeKind::Disc => "disc",
            ShapeKind::Polygon => "polygon",
            ShapeKind::Cuboid => "box",
            ShapeKind::OrientedCuboid => "oriented box",
            ShapeKind::Cone => "cone",
            ShapeKind::Torus => "torus",
        }
    }
}

bit_set! {
    /// A set of kinds of shapes.
    ShapeKindSet of ShapeKind
}
