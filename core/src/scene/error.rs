//! Why a scene or a camera is not valid.

use core::fmt;

use super::{FieldError, MaterialId};
use crate::geometry::{ItemId, ShapeError};

/// Why the tables of a scene are not valid.
///
/// Displayed with the entry, the field, its value and its range: "light 0: `color` has a channel of -1,
/// must be in 0..=1e6".
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// There are more than `u32::MAX` items, more than an [`ItemId`] can number.
    TooManyItems,
    /// There are more than 65,536 materials, more than a [`MaterialId`] can number.
    TooManyMaterials,
    /// The shape of this item is not valid.
    Shape(ItemId, ShapeError),
    /// A field of this material is out of range.
    Material(MaterialId, FieldError),
    /// `material_ids` has no entry for this item, or its entry is not an index of `materials`.
    MissingMaterial(ItemId),
    /// A field of the light with this index is out of range.
    Light(usize, FieldError),
    /// A field of the texture with this index is out of range.
    Texture(usize, FieldError),
    /// The ambient light is out of range.
    Ambient(FieldError),
    /// A field of the background is out of range.
    Background(FieldError),
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneError::TooManyItems => write!(f, "more items than a scene can number"),
            SceneError::TooManyMaterials => write!(f, "more than 65536 materials"),
            SceneError::Shape(item, error) => write!(f, "item {}: {error}", item.0),
            SceneError::Material(material, error) => write!(f, "material {}: {error}", material.0),
            SceneError::MissingMaterial(item) => {
                write!(f, "item {}: `material_ids` names no entry of `materials`", item.0)
            }
            SceneError::Light(light, error) => write!(f, "light {light}: {error}"),
            SceneError::Texture(texture, error) => write!(f, "texture {texture}: {error}"),
            SceneError::Ambient(error) => write!(f, "scene: {error}"),
            SceneError::Background(error) => write!(f, "background: {error}"),
        }
    }
}

impl core::error::Error for SceneError {}

/// Why a [`CameraDescriptor`](super::CameraDescriptor) is not valid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CameraError {
    /// A field is out of range.
    Field(FieldError),
    /// `position` and `target` are equal, so there is no view direction.
    PositionIsTarget,
    /// `up` is zero, not finite, or parallel to the view direction.
    UpParallelToView,
}

impl From<FieldError> for CameraError {
    fn from(error: FieldError) -> Self {
        CameraError::Field(error)
    }
}

impl fmt::Display for CameraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CameraError::Field(error) => write!(f, "{error}"),
            CameraError::PositionIsTarget => {
                f.write_str("the position of the camera and its target are equal")
            }
            CameraError::UpParallelToView => f.write_str("up is parallel to the view direction"),
        }
    }
}

impl core::error::Error for CameraError {}
