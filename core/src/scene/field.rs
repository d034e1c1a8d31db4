//! Fields of a scene or camera whose values are out of range.

use core::fmt;

use crate::math::Decimal;

/// A field whose value is out of range.
///
/// Displayed with the value and the range:
///
/// ```
/// use strahl_core::scene::{Field, FieldError};
///
/// let error = FieldError { field: Field::RefractiveIndex, value: 0.0 };
/// assert_eq!(error.to_string(), "`refractive_index` is 0, must be in 0.01..=100");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldError {
    /// Field that is out of range.
    pub field: Field,
    /// Its value, rounded to single precision.
    ///
    /// * Of a color: the channel that is out of range.
    /// * Of a point: the coordinate that is out of range.
    /// * Of a unit vector: its length.
    pub value: f32,
}

/// A field that [`Scene::new`](super::Scene::new) or [`Camera::new`](super::Camera::new) checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Field {
    /// `above` of a background gradient.
    Above,
    /// `ambient` of a material or of the scene.
    Ambient,
    /// `attenuation_length` of a material.
    AttenuationLength,
    /// `axis` of a gradient texture.
    Axis,
    /// `below` of a background gradient.
    Below,
    /// `frequency` of a checker texture.
    CellFrequency,
    /// `color` of a light or of the background.
    Color,
    /// `constant` of a falloff.
    Constant,
    /// `cos_inner` of a spot light.
    CosInner,
    /// `cos_outer` of a spot light.
    CosOuter,
    /// `diffuse` of a material.
    Diffuse,
    /// `direction` of a spot light.
    Direction,
    /// `end_color` of a texture.
    EndColor,
    /// `even` of a checker texture.
    Even,
    /// Sum of the three terms of a falloff.
    Falloff,
    /// `field_of_view` of a projection.
    FieldOfView,
    /// `focus_distance` of a thin lens.
    FocusDistance,
    /// `half_edges` of a rectangle light.
    HalfEdges,
    /// Area that the `half_edges` of a rectangle light span.
    HalfEdgesArea,
    /// `height` of an orthographic projection.
    Height,
    /// `highlight` of a material.
    Highlight,
    /// `highlight_exponent` of a material.
    HighlightExponent,
    /// `lens_radius` of a thin lens.
    LensRadius,
    /// `linear` of a falloff.
    Linear,
    /// `odd` of a checker texture.
    Odd,
    /// `origin` of a texture.
    Origin,
    /// `position` of a light or of the camera.
    Position,
    /// `quadratic` of a falloff.
    Quadratic,
    /// `radius` of a sphere light.
    Radius,
    /// `reflection` of a material.
    Reflection,
    /// `refractive_index` of a material.
    RefractiveIndex,
    /// `frequency` of a zone plate.
    RingFrequency,
    /// `roughness` of a material.
    Roughness,
    /// `start_color` of a texture.
    StartColor,
    /// `target` of the camera.
    Target,
    /// `texture` of a material.
    Texture,
    /// `to_light` of a directional light.
    ToLight,
    /// `transmission` of a material.
    Transmission,
    /// `up` of a background gradient.
    Up,
}

impl Field {
    /// The text before the value and the text after it.
    fn text(self) -> [&'static str; 2] {
        const CHANNEL: &str = "must be in 0..=1e6";
        const FRACTION: &str = "must be in 0..=1";
        const COORDINATE: &str = "must be in -1e15..=1e15";
        const NOT_NEGATIVE: &str = "must be in 0..=1e15";
        const LENGTH: &str = "must be more than 0 and at most 1e15";
        const UNIT: &str = "must be 1";
        match self {
            Field::Above => ["`above` has a channel of", CHANNEL],
            Field::Ambient => ["`ambient` has a channel of", CHANNEL],
            Field::AttenuationLength => ["`attenuation_length` has a channel of", "must be more than 0"],
            Field::Axis => ["`axis` has the squared length", "must be more than 0 and finite"],
            Field::Below => ["`below` has a channel of", CHANNEL],
            Field::CellFrequency => ["`frequency` has a component of", COORDINATE],
            Field::Color => ["`color` has a channel of", CHANNEL],
            Field::Constant => ["`falloff.constant` is", NOT_NEGATIVE],
            Field::CosInner => ["`cos_inner` is", "must be at most 1 and at least `cos_outer`"],
            Field::CosOuter => ["`cos_outer` is", "must be in -1..=1"],
            Field::Diffuse => ["`diffuse` has a channel of", CHANNEL],
            Field::Direction => ["`direction` has the length", UNIT],
            Field::EndColor => ["`end_color` has a channel of", CHANNEL],
            Field::Even => ["`even` has a channel of", CHANNEL],
            Field::Falloff => ["`falloff` has the sum", "must be more than 0"],
            Field::FieldOfView => ["`field_of_view` is", "must be more than 0 and less than pi (radians)"],
            Field::FocusDistance => ["`focus_distance` is", LENGTH],
            Field::HalfEdges => ["`half_edges` has a coordinate of", COORDINATE],
            Field::HalfEdgesArea => ["`half_edges` spans the area", "must be more than 0"],
            Field::Height => ["`height` is", LENGTH],
            Field::Highlight => ["`highlight` has a channel of", CHANNEL],
            Field::HighlightExponent => ["`highlight_exponent` is", "must be in 0..=1e6"],
            Field::LensRadius => ["`lens_radius` is", LENGTH],
            Field::Linear => ["`falloff.linear` is", NOT_NEGATIVE],
            Field::Odd => ["`odd` has a channel of", CHANNEL],
            Field::Origin => ["`origin` has a coordinate of", COORDINATE],
            Field::Position => ["`position` has a coordinate of", COORDINATE],
            Field::Quadratic => ["`falloff.quadratic` is", NOT_NEGATIVE],
            Field::Radius => ["`radius` is", NOT_NEGATIVE],
            Field::Reflection => ["`reflection` has a channel of", FRACTION],
            Field::RefractiveIndex => ["`refractive_index` is", "must be in 0.01..=100"],
            Field::RingFrequency => ["`frequency` is", NOT_NEGATIVE],
            Field::Roughness => ["`roughness` is", FRACTION],
            Field::StartColor => ["`start_color` has a channel of", CHANNEL],
            Field::Target => ["`target` has a coordinate of", COORDINATE],
            Field::Texture => {
                ["`texture` is", "must be an index of the table of textures, or `TextureId::NONE`"]
            }
            Field::ToLight => ["`to_light` has the length", UNIT],
            Field::Transmission => ["`transmission` has a channel of", FRACTION],
            Field::Up => ["`up` has the length", UNIT],
        }
    }
}

impl fmt::Display for FieldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [before, after] = self.field.text();
        write!(f, "{before} {}, {after}", Decimal(self.value))
    }
}

impl core::error::Error for FieldError {}
