//! Types of values, and their reading.

mod colors;
mod hints;
mod names;
mod numbers;
mod reader;
mod schema_like;
mod suggest;
mod vectors;

pub use colors::{AttenuationLength, ColorValue, UnitColor, is_color_name};
#[cfg(test)]
pub use hints::HINTS;
pub use names::MaterialNames;
pub use numbers::{
    BrightAngle, ConeAngle, Intensity, NonNegativeLength, NumberRange, PositiveLength, Priority,
    RefractiveIndex, Roughness, Shininess, ViewAngle, integer_in, number_in,
};
pub use reader::{DiagnosticList, FromToml, Spanned, TableReader, TomlValue};
pub(super) use schema_like::schema_like;
pub use suggest::{key_suggestion, suggestion};
pub use vectors::{
    BoxSize, DirectionList, DirectionValue, EulerAngles, FalloffValue, PointList, PointValue, RectangleSize,
    ScaleFactors, ShutterInterval,
};
