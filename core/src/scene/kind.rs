//! Kinds of lights and textures, and sets of them.

use crate::set::{bit_set, kind_names};

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

kind_names! {
    LightKind {
        Point => "point",
        Directional => "directional",
        Spot => "spot",
        Sphere => "sphere",
        Rectangle => "rectangle",
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

kind_names! {
    TextureKind {
        Checker => "checker",
        Gradient => "gradient",
        ZonePlate => "zone plate",
    }
}

bit_set! {
    /// A set of kinds of textures.
    TextureKindSet of TextureKind
}
