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
///
/// Named like the field of [`Material`](super::Material), [`Light`](super::Light),
/// [`LightSource`](super::LightSource), [`Falloff`](super::Falloff), [`Texture`](super::Texture),
/// [`Background`](super::Background), [`SceneDescriptor`](super::SceneDescriptor),
/// [`CameraDescriptor`](super::CameraDescriptor) or [`Projection`](super::Projection). `CellFrequency` and
/// `RingFrequency` are the `frequency` of a checker and of a zone plate; `HalfEdgesArea` is the area that the
/// `half_edges` span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[allow(missing_docs)] // named like the fields
pub enum Field {
    Above,
    Ambient,
    AttenuationLength,
    Axis,
    Below,
    CellFrequency,
    Color,
    Constant,
    CosInner,
    CosOuter,
    Diffuse,
    Direction,
    EndColor,
    Even,
    Falloff,
    FieldOfView,
    FocusDistance,
    HalfEdges,
    HalfEdgesArea,
    Height,
    Highlight,
    HighlightExponent,
    LensRadius,
    Linear,
    Odd,
    Origin,
    Position,
    Quadratic,
    Radius,
    Reflection,
    RefractiveIndex,
    RingFrequency,
    Roughness,
    StartColor,
    Target,
    Texture,
    ToLight,
    Transmission,
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
