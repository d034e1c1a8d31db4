//! Indices into the tables of a scene.

/// Index of a material in the table of materials of its scene, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(transparent)]
pub struct MaterialId(pub u16);

/// Index of a texture in the table of textures of its scene, from 0; or [`TextureId::NONE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(transparent)]
pub struct TextureId(pub u16);

impl TextureId {
    /// No texture, as in [`Material::MATTE`](super::Material::MATTE).
    pub const NONE: TextureId = TextureId(u16::MAX);
}
