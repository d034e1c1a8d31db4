//! Numbers in ranges, and their JSON Schema.
//!
//! Every number is rounded to single precision before its range is checked, so that the checked number is the one that
//! the core gets.

use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use strahl_core::Rgb;
use strahl_core::math::MAX_COORDINATE;
use toml::de::DeValue;

use super::reader::{FromToml, TableReader, TomlValue};
use crate::diagnostics::Diagnostic;

/// A range of numbers.
#[derive(Clone, Copy, Debug)]
pub struct NumberRange {
    low: f32,
    high: f32,
    /// Whether `low` and `high` are included.
    ends: (bool, bool),
}

impl NumberRange {
    /// Coordinates and directions.
    pub const COORDINATE: NumberRange = NumberRange::within(-MAX_COORDINATE, MAX_COORDINATE);
    /// Sizes that may be zero.
    pub const SIZE: NumberRange = NumberRange::within(0.0, MAX_COORDINATE);
    /// Channels of colors, and their factors.
    pub const BRIGHTNESS: NumberRange = NumberRange::within(0.0, Rgb::MAX_CHANNEL);
    /// Fractions from 0 to 1.
    pub const FRACTION: NumberRange = NumberRange::within(0.0, 1.0);
    /// Attenuation lengths: more than 0, infinity included.
    pub const ATTENUATION_LENGTH: NumberRange =
        NumberRange { low: 0.0, high: f32::INFINITY, ends: (false, true) };
    /// Angles of rotation, in degrees: up to 100 full turns, exact to a thousandth.
    pub const ROTATION: NumberRange = NumberRange::within(-36_000.0, 36_000.0);

    const fn within(low: f32, high: f32) -> Self {
        NumberRange { low, high, ends: (true, true) }
    }

    const fn above(low: f32, high: f32) -> Self {
        NumberRange { low, high, ends: (false, true) }
    }

    fn contains(&self, x: f32) -> bool {
        let low = x > self.low || self.ends.0 && x == self.low;
        low && (x < self.high || self.ends.1 && x == self.high)
    }

    /// Advice for a number outside the range, if any.
    fn suggestion(&self, x: f32) -> Option<String> {
        let limit = |name: &str, end: f32, is_included: bool| match is_included {
            true => format!("the {name} is {}", RangeEnd(end)),
            false => format!("the limit is {} (exclusive)", RangeEnd(end)),
        };
        if self.contains(-x) {
            Some(format!("did you mean {}?", -x))
        } else if self.high == 1.0 && x > 1.0 && x <= 100.0 {
            Some(format!("for {x} %, write {}", x / 100.0))
        } else if x > self.high {
            Some(limit("maximum", self.high, self.ends.1))
        } else if x < self.low {
            Some(limit("minimum", self.low, self.ends.0))
        } else if x == self.low {
            Some(format!("any value above {}", RangeEnd(self.low)))
        } else {
            None
        }
    }

    /// The JSON Schema of a number in this range.
    pub fn schema(&self) -> Schema {
        let mut schema = json_schema!({ "type": "number" });
        let low = if self.ends.0 { "minimum" } else { "exclusiveMinimum" };
        let high = if self.ends.1 { "maximum" } else { "exclusiveMaximum" };
        schema.insert(low.into(), shortest(self.low));
        if self.high.is_finite() {
            schema.insert(high.into(), shortest(self.high));
        }
        schema
    }
}

/// The double with the same shortest decimal form, as an integer if it has no fraction.
fn shortest(x: f32) -> serde_json::Value {
    let double: f64 = x.to_string().parse().unwrap_or(f64::from(x));
    if double.fract() == 0.0 { (double as i64).into() } else { double.into() }
}

/// Displays the end of a range.
struct RangeEnd(f32);

impl fmt::Display for RangeEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.abs() == MAX_COORDINATE { write!(f, "{:e}", self.0) } else { write!(f, "{}", self.0) }
    }
}

impl fmt::Display for NumberRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (low, high) = (RangeEnd(self.low), RangeEnd(self.high));
        match self.ends {
            (true, true) => write!(f, "{low} to {high}"),
            (false, true) if self.high.is_infinite() => write!(f, "more than {low}"),
            (false, true) => write!(f, "more than {low} and at most {high}"),
            (true, false) => write!(f, "at least {low} and less than {high}"),
            (false, false) => write!(f, "more than {low} and less than {high}"),
        }
    }
}

/// The number and its spelling; `None` if the value is not a number.
fn number(value: &DeValue<'_>) -> Option<(f32, String)> {
    match value {
        DeValue::Float(float) => Some((float.as_str().parse().ok()?, float.to_string())),
        DeValue::Integer(whole) if whole.radix() == 10 => {
            Some((whole.as_str().parse().ok()?, whole.to_string()))
        }
        DeValue::Integer(whole) => {
            // A number of more than 128 bits is outside every range.
            let number = u128::from_str_radix(whole.as_str(), whole.radix()).unwrap_or(u128::MAX);
            Some((number as f32, whole.to_string()))
        }
        _ => None,
    }
}

/// Whether the value is a number, in any range.
pub fn is_number(value: &TomlValue<'_>) -> bool {
    matches!(value.get_ref(), DeValue::Float(_) | DeValue::Integer(_))
}

/// Reads a number in a range.
pub fn number_in(
    range: NumberRange,
    value: &TomlValue<'_>,
    key: &str,
    reader: &mut TableReader<'_>,
) -> Option<f32> {
    let Some((number, spelling)) = number(value.get_ref()) else {
        return reader.report_type(value, key, "a number");
    };
    if range.contains(number) {
        return Some(number);
    }
    let spelling: String = spelling.chars().take(40).collect();
    // `nan` and `inf`.
    let needs = match spelling.contains('n') && range.high.is_finite() {
        true => "a finite number".into(),
        false => range.to_string(),
    };
    let diagnostic = Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {spelling}"));
    reader.report(match range.suggestion(number) {
        Some(advice) => diagnostic.with_help(advice),
        None => diagnostic,
    })
}

/// Reads an integer in a range.
pub fn integer_in(
    low: u32,
    high: u32,
    value: &TomlValue<'_>,
    key: &str,
    reader: &mut TableReader<'_>,
) -> Option<u32> {
    let needs = format!("an integer from {low} to {high}");
    match value.get_ref() {
        DeValue::Integer(whole) => match u32::from_str_radix(whole.as_str(), whole.radix()) {
            Ok(number) if number >= low && number <= high => Some(number),
            _ => {
                let spelling: String = whole.to_string().chars().take(40).collect();
                reader
                    .report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {spelling}")))
            }
        },
        DeValue::Float(float) => {
            let spelling: String = float.to_string().chars().take(40).collect();
            reader.report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {spelling}")))
        }
        _ => reader.report_type(value, key, &needs),
    }
}

/// Declares types of numbers in ranges.
macro_rules! numbers {
    ($($(#[$doc:meta])* $Name:ident: $range:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $Name(pub f32);

        impl FromToml for $Name {
            fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
                number_in($range, value, key, reader).map($Name)
            }
        }

        impl JsonSchema for $Name {
            fn inline_schema() -> bool {
                true
            }
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($Name).into()
            }
            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                $range.schema()
            }
        }
    )*};
}

numbers! {
    /// A positive length, in scene lengths.
    PositiveLength: NumberRange::above(0.0, MAX_COORDINATE);
    /// A length that may be zero, in scene lengths.
    NonNegativeLength: NumberRange::SIZE;
    /// A field of view, full angle in degrees.
    ViewAngle: NumberRange { low: 0.0, high: 180.0, ends: (false, false) };
    /// The cone of a spot light, full angle in degrees.
    ConeAngle: NumberRange::above(0.0, 360.0);
    /// The inner cone of a spot light, full angle in degrees.
    BrightAngle: NumberRange::within(0.0, 360.0);
    /// A factor of a color.
    Intensity: NumberRange::BRIGHTNESS;
    /// A Phong exponent.
    Shininess: NumberRange::within(0.0, 1e6);
    /// An index of refraction.
    RefractiveIndex: NumberRange::within(0.01, 100.0);
    /// The roughness of a surface.
    Roughness: NumberRange::FRACTION;
}

/// Declares types of integers in ranges.
macro_rules! integers {
    ($($(#[$doc:meta])* $Name:ident: $low:expr, $high:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $Name(pub u8);

        impl FromToml for $Name {
            fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
                integer_in($low, $high, value, key, reader).and_then(|n| u8::try_from(n).ok()).map($Name)
            }
        }

        impl JsonSchema for $Name {
            fn inline_schema() -> bool {
                true
            }
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($Name).into()
            }
            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({ "type": "integer", "minimum": $low, "maximum": $high })
            }
        }
    )*};
}

integers! {
    /// The priority of overlapping bodies.
    Priority: 0, 255;
}
