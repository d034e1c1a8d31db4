//! Indices into the tables of a scene.

/// Index into the scene's table of materials.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(transparent)]
pub struct MaterialId(pub u16);

/// Index into the scene's table of textures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(transparent)]
pub struct TextureId(pub u16);

impl TextureId {
    /// No texture.
    pub const NONE: TextureId = TextureId(u16::MAX);
}
