//! Fields of a scene whose values are out of range.

use core::fmt;

use crate::math::Decimal;

/// A field whose value is out of range.
///
/// Shown with the value and the range: "`cos_inner` is 1.5, must be at most 1 and at least `cos_outer`".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldError {
    /// The field.
    pub field: Field,
    /// Its value, rounded to single precision: of a color the channel, of a point the coordinate that is out of
    /// range, of a direction the length.
    pub value: f32,
}

/// A field that [`Scene::new`](super::Scene::new) checks. Named like the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[allow(missing_docs)] // named like the fields
pub enum Field {
    Above,
    Axis,
    Ambient,
    Below,
    CellFrequency,
    AttenuationLength,
    Color,
    Constant,
    CosInner,
    CosOuter,
    Diffuse,
    Direction,
    Even,
    HighlightExponent,
    Falloff,
    StartColor,
    HalfEdges,
    HalfEdgesArea,
    Highlight,
    RefractiveIndex,
    Linear,
    Reflection,
    Odd,
    Origin,
    Position,
    Quadratic,
    Radius,
    RingFrequency,
    Roughness,
    Texture,
    EndColor,
    ToLight,
    Transmission,
    Up,
}

impl Field {
    /// What is said before the value and after it.
    fn text(self) -> [&'static str; 2] {
        const CHANNEL: &str = "must be in 0..=1e6";
        const SHARE: &str = "must be in 0..=1";
        const COORDINATE: &str = "must be in -1e15..=1e15";
        const POSITIVE: &str = "must be in 0..=1e15";
        const UNIT: &str = "must be 1";
        match self {
            Field::Above => ["`above` has a channel of", CHANNEL],
            Field::Axis => ["`axis` has the squared length", "must be more than 0 and finite"],
            Field::Ambient => ["`ambient` has a channel of", CHANNEL],
            Field::Below => ["`below` has a channel of", CHANNEL],
            Field::CellFrequency => ["`frequency` has a component of", COORDINATE],
            Field::AttenuationLength => ["`attenuation_length` has a channel of", "must be more than 0"],
            Field::Color => ["`color` has a channel of", CHANNEL],
            Field::Constant => ["`falloff.constant` is", POSITIVE],
            Field::CosInner => ["`cos_inner` is", "must be at most 1 and at least `cos_outer`"],
            Field::CosOuter => ["`cos_outer` is", "must be in -1..=1"],
            Field::Diffuse => ["`diffuse` has a channel of", CHANNEL],
            Field::Direction => ["`direction` has the length", UNIT],
            Field::Even => ["`even` has a channel of", CHANNEL],
            Field::HighlightExponent => ["`highlight_exponent` is", "must be in 0..=1e6"],
            Field::Falloff => ["`falloff` has the sum", "must be more than 0"],
            Field::StartColor => ["`start_color` has a channel of", CHANNEL],
            Field::HalfEdges => ["`half_edges` has a coordinate of", COORDINATE],
            Field::HalfEdgesArea => ["`half_edges` spans the area", "must be more than 0"],
            Field::Highlight => ["`highlight` has a channel of", CHANNEL],
            Field::RefractiveIndex => ["`refractive_index` is", "must be in 0.01..=100"],
            Field::Linear => ["`falloff.linear` is", POSITIVE],
            Field::Reflection => ["`reflection` has a channel of", SHARE],
            Field::Odd => ["`odd` has a channel of", CHANNEL],
            Field::Origin => ["`origin` has a coordinate of", COORDINATE],
            Field::Position => ["`position` has a coordinate of", COORDINATE],
            Field::Quadratic => ["`falloff.quadratic` is", POSITIVE],
            Field::Radius => ["`radius` is", POSITIVE],
            Field::RingFrequency => ["`frequency` is", POSITIVE],
            Field::Roughness => ["`roughness` is", SHARE],
            Field::Texture => {
                ["`texture` is", "must be an index of the table of textures, or `TextureId::NONE`"]
            }
            Field::EndColor => ["`end_color` has a channel of", CHANNEL],
            Field::ToLight => ["`to_light` has the length", UNIT],
            Field::Transmission => ["`transmission` has a channel of", SHARE],
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
