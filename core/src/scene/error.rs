//! Why there is no scene, or no view of it.

use core::fmt;

use super::MaterialId;
use crate::geometry::{ItemId, ShapeError};

/// Why parts do not make a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneError {
    /// There are more items than numbers for them.
    TooManyItems,
    /// This shape is none.
    Shape(ItemId, ShapeError),
    /// This material, a place in its table, is out of range.
    Material(MaterialId, MaterialFault),
    /// The material of this item is not told or does not exist.
    NoMaterial(ItemId),
    /// The light at this place in the table is out of range.
    Light(usize),
    /// The texture at this place in the table is out of range.
    Texture(usize),
    /// The ambient light or the background is out of range.
    Surroundings,
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneError::TooManyItems => write!(f, "more items than a scene can number"),
            SceneError::Shape(item, fault) => write!(f, "object {}: {fault}", item.0),
            SceneError::Material(material, fault) => write!(f, "material {}: {fault}", material.0),
            SceneError::NoMaterial(item) => write!(f, "object {}: it has no material", item.0),
            SceneError::Light(light) => write!(f, "light {light}: a number is out of range"),
            SceneError::Texture(texture) => write!(f, "texture {texture}: a number is out of range"),
            SceneError::Surroundings => write!(f, "ambient light or background: a number is out of range"),
        }
    }
}

impl core::error::Error for SceneError {}

/// Why a material cannot be part of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MaterialFault {
    /// A colour has a channel outside `0..=1e6`.
    Color,
    /// A mirrored or transmitted share has a channel outside `0..=1`.
    Share,
    /// The exponent of the highlight is outside `0..=1e6`.
    Exponent,
    /// The index of refraction is outside `0.01..=100`.
    Index,
    /// The roughness is outside `0..=1`.
    Roughness,
    /// The clarity is zero, below zero or no number.
    Clarity,
    /// The texture is outside its table.
    Texture,
}

impl fmt::Display for MaterialFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            MaterialFault::Color => "a colour is not in 0..=1e6",
            MaterialFault::Share => "a mirrored or transmitted share is not in 0..=1",
            MaterialFault::Exponent => "the highlight's exponent is not in 0..=1e6",
            MaterialFault::Index => "the index of refraction is not in 0.01..=100",
            MaterialFault::Roughness => "the roughness is not in 0..=1",
            MaterialFault::Clarity => "the clarity is not more than zero",
            MaterialFault::Texture => "the texture does not exist",
        })
    }
}

impl core::error::Error for MaterialFault {}

/// Why a view shows nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ViewFault {
    /// A coordinate is no number or too far away.
    Place,
    /// The eye is at the point it looks at.
    NoDirection,
    /// Up is zero or parallel to the line of sight.
    NoUp,
    /// The angle is not between zero and half a turn, or the height not more than zero.
    Angle,
    /// The radius of the lens or its focus is out of range.
    Lens,
}

impl fmt::Display for ViewFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ViewFault::Place => "the view has a coordinate that is not within 1e15 of zero",
            ViewFault::NoDirection => "the eye is at the point it looks at",
            ViewFault::NoUp => "up is parallel to the line of sight",
            ViewFault::Angle => "the angle of view leaves no picture",
            ViewFault::Lens => "the radius or the focus of the lens is out of range",
        })
    }
}

impl core::error::Error for ViewFault {}
