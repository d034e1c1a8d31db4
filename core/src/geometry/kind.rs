//! Kinds of shapes, and sets of them.

use crate::set::bit_set;

/// The kind of a shape, without its data.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)] // the variants of `Shape` have docs
pub enum ShapeKind {
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

impl ShapeKind {
    /// All kinds, in the order of their declaration.
    pub const ALL: [ShapeKind; 10] = [
        ShapeKind::Sphere,
        ShapeKind::Triangle,
        ShapeKind::SmoothTriangle,
        ShapeKind::Plane,
        ShapeKind::Disc,
        ShapeKind::Polygon,
        ShapeKind::Cuboid,
        ShapeKind::OrientedCuboid,
        ShapeKind::Cone,
        ShapeKind::Torus,
    ];

    /// The name in reports, in lower case.
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
    ShapeSet of ShapeKind
}
