//! Kinds of shapes, and sets of them.

use crate::set::bit_set;

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

    /// Lowercase name, with spaces: `sphere`, `smooth triangle`, `box` and so on.
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
