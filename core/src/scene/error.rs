//! Why there is no scene, or no view of it.

use core::fmt;

use super::{FieldError, MaterialId};
use crate::geometry::{ItemId, ShapeError};
use crate::math::Decimal;

/// Why the tables of a scene are not valid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// There are more items than numbers for them.
    TooManyItems,
    /// There are more materials than a [`MaterialId`] can tell apart: 65,536.
    TooManyMaterials,
    /// The shape of this item is invalid.
    Shape(ItemId, ShapeError),
    /// A field of this material is out of range.
    Material(MaterialId, FieldError),
    /// `material_ids` has no entry for this item, or one that is not in the table of materials.
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
            SceneError::Shape(item, error) => write!(f, "object {}: {error}", item.0),
            SceneError::Material(material, error) => write!(f, "material {}: {error}", material.0),
            SceneError::MissingMaterial(item) => {
                write!(f, "object {}: `material_ids` names no entry of `materials`", item.0)
            }
            SceneError::Light(light, error) => write!(f, "light {light}: {error}"),
            SceneError::Texture(texture, error) => write!(f, "texture {texture}: {error}"),
            SceneError::Ambient(error) => write!(f, "scene: {error}"),
            SceneError::Background(error) => write!(f, "background: {error}"),
        }
    }
}

impl core::error::Error for SceneError {}

/// Why there is no camera for a view.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CameraError {
    /// A coordinate of `from` or `at` is NaN or not within 1e15 of zero, or `up` is not finite.
    Coordinate,
    /// `from` and `at` are the same point.
    PositionIsTarget,
    /// `up` is zero or parallel to the line of sight.
    UpParallelToView,
    /// The angle of the projection, in radians, is not more than 0 and less than pi.
    FieldOfView(f32),
    /// The height of the projection is not more than 0 and at most 1e15.
    Height(f32),
    /// The radius of the lens is not more than 0 and at most 1e15.
    LensRadius(f32),
    /// The focal distance of the lens is not more than 0 and at most 1e15.
    FocusDistance(f32),
}

impl fmt::Display for CameraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let length = |f: &mut fmt::Formatter<'_>, field: &str, value: &f32| {
            write!(f, "`{field}` is {}, must be more than 0 and at most 1e15", Decimal(*value))
        };
        match self {
            CameraError::Coordinate => {
                f.write_str("the view has a coordinate that is not within 1e15 of zero")
            }
            CameraError::PositionIsTarget => f.write_str("the eye is at the point it looks at"),
            CameraError::UpParallelToView => f.write_str("up is parallel to the line of sight"),
            CameraError::FieldOfView(angle) => {
                write!(f, "`angle` is {}, must be more than 0 and less than pi (radians)", Decimal(*angle))
            }
            CameraError::Height(height) => length(f, "height", height),
            CameraError::LensRadius(radius) => length(f, "radius", radius),
            CameraError::FocusDistance(focus) => length(f, "focus", focus),
        }
    }
}

impl core::error::Error for CameraError {}
