//! What kinds of lights and textures there are.

use crate::set::bit_set;

/// What kind of light it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // they name what `Source` describes
pub enum LightKind {
    Point,
    Directional,
    Spot,
    Sphere,
    Rectangle,
}

impl LightKind {
    /// Every kind.
    pub const ALL: [LightKind; 5] =
        [LightKind::Point, LightKind::Directional, LightKind::Spot, LightKind::Sphere, LightKind::Rectangle];

    /// The name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            LightKind::Point => "point",
            LightKind::Directional => "directional",
            LightKind::Spot => "spot",
            LightKind::Sphere => "sphere",
            LightKind::Rectangle => "rectangle",
        }
    }
}

bit_set! {
    /// Kinds of lights.
    LightSet of LightKind
}

/// What kind of texture it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // they name what `Texture` describes
pub enum TextureKind {
    Checker,
    Gradient,
    ZonePlate,
}

impl TextureKind {
    /// Every kind.
    pub const ALL: [TextureKind; 3] = [TextureKind::Checker, TextureKind::Gradient, TextureKind::ZonePlate];

    /// The name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            TextureKind::Checker => "checker",
            TextureKind::Gradient => "gradient",
            TextureKind::ZonePlate => "zone plate",
        }
    }
}

bit_set! {
    /// Kinds of textures.
    TextureSet of TextureKind
}
