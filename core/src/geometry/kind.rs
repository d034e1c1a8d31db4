//! Kinds of shapes, and sets of them.

use crate::set::{bit_set, kind_names};

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

kind_names! {
    ShapeKind {
        Sphere => "sphere",
        Triangle => "triangle",
        SmoothTriangle => "smooth triangle",
        Plane => "plane",
        Disc => "disc",
        Polygon => "polygon",
        Cuboid => "box",
        OrientedCuboid => "oriented box",
        Cone => "cone",
        Torus => "torus",
    }
}

bit_set! {
    /// A set of kinds of shapes.
    ShapeKindSet of ShapeKind
}
