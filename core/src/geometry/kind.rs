//! What kind of shape an item is.

use crate::set::set_of;

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
