//! Kinds of lights and textures, and sets of them.

use crate::set::{all_kinds, bit_set};

/// Kind of a light: a variant of [`LightSource`](super::LightSource) without its fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightKind {
    /// A point that emits in all directions: [`LightSource::Point`](super::LightSource::Point).
    Point,
    /// A light at infinite distance: [`LightSource::Directional`](super::LightSource::Directional).
    Directional,
    /// A point that emits into a cone: [`LightSource::Spot`](super::LightSource::Spot).
    Spot,
    /// A sphere, an area light: [`LightSource::Sphere`](super::LightSource::Sphere).
    Sphere,
    /// A rectangle that emits from its front, an area light:
    /// [`LightSource::Rectangle`](super::LightSource::Rectangle).
    Rectangle,
}

all_kinds! {
    LightKind {
        Point,
        Directional,
        Spot,
        Sphere,
        Rectangle,
    }
}

impl LightKind {
    /// Lowercase name, with spaces: `point`, for example.
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
    /// A set of kinds of lights.
    LightKindSet of LightKind
}

/// Kind of a texture: a variant of [`Texture`](super::Texture) without its fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextureKind {
    /// Cells of two alternating colors: [`Texture::Checker`](super::Texture::Checker).
    Checker,
    /// A linear gradient between two points: [`Texture::Gradient`](super::Texture::Gradient).
    Gradient,
    /// Concentric rings: [`Texture::ZonePlate`](super::Texture::ZonePlate).
    ZonePlate,
}

all_kinds! {
    TextureKind {
        Checker,
        Gradient,
        ZonePlate,
    }
}

impl TextureKind {
    /// Lowercase name, with spaces: `checker`, for example.
    pub const fn name(self) -> &'static str {
        match self {
            TextureKind::Checker => "checker",
            TextureKind::Gradient => "gradient",
            TextureKind::ZonePlate => "zone plate",
        }
    }
}

bit_set! {
    /// A set of kinds of textures.
    TextureKindSet of TextureKind
}
