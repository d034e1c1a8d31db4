//! Numbers of the file: which of them a key can hold, and how the schema says so.
//!
//! Every number is rounded to single precision first and then in range or not, so that what is
//! checked is what the core gets.

use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use strahl_core::Rgb;
use strahl_core::math::MAX_COORDINATE;
use toml::de::DeValue;

use super::reader::{FromToml, TableReader, TomlValue};
use crate::diagnostics::Diagnostic;

/// The numbers that are allowed.
#[derive(Clone, Copy, Debug)]
pub struct NumberRange {
    low: f32,
    high: f32,
    /// Whether `low` and `high` are allowed themselves.
    ends: (bool, bool),
}

impl NumberRange {
    /// Coordinates and directions.
    pub const COORDINATE: NumberRange = NumberRange::within(-MAX_COORDINATE, MAX_COORDINATE);
    /// Sizes that may be nothing.
    pub const SIZE: NumberRange = NumberRange::within(0.0, MAX_COORDINATE);
    /// Channels of colours and of what multiplies them.
    pub const BRIGHTNESS: NumberRange = NumberRange::within(0.0, Rgb::MAX_CHANNEL);
    /// Parts of a whole.
    pub const FRACTION: NumberRange = NumberRange::within(0.0, 1.0);
    /// More than nothing, and without end.
    pub const ATTENUATION_LENGTH: NumberRange =
        NumberRange { low: 0.0, high: f32::INFINITY, ends: (false, true) };
    /// Turns: more than enough, and still exact to a thousandth.
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

    /// What may have been meant by a number that is not allowed.
    fn suggestion(&self, x: f32) -> Option<String> {
        if self.contains(-x) {
            Some(format!("did you mean {}?", -x))
        } else if self.high == 1.0 && x > 1.0 && x <= 100.0 {
            Some(format!("1 is all of it; {x} % is {}", x / 100.0))
        } else if x > self.high {
            Some(format!(
                "the {} that can stand here is {}",
                if self.ends.1 { "most" } else { "limit" },
                RangeEnd(self.high)
            ))
        } else if x < self.low {
            Some(format!(
                "the {} that can stand here is {}",
                if self.ends.0 { "least" } else { "limit" },
                RangeEnd(self.low)
            ))
        } else if x == self.low {
            Some(format!("as little more than {} as you like", RangeEnd(self.low)))
        } else {
            None
        }
    }

    /// The schema of one such number.
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

/// The double that is written like the single, and without a fraction where there is none.
fn shortest(x: f32) -> serde_json::Value {
    let double: f64 = x.to_string().parse().unwrap_or(f64::from(x));
    if double.fract() == 0.0 { (double as i64).into() } else { double.into() }
}

/// The end of a range as it is shown.
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
            (true, true) => write!(f, "between {low} and {high}"),
            (false, true) if self.high.is_infinite() => write!(f, "more than {low}"),
            (false, true) => write!(f, "more than {low} and at most {high}"),
            (true, false) => write!(f, "at least {low} and less than {high}"),
            (false, false) => write!(f, "more than {low} and less than {high}"),
        }
    }
}

/// The number of a value and its spelling, if it is one.
fn number(value: &DeValue<'_>) -> Option<(f32, String)> {
    match value {
        DeValue::Float(float) => Some((float.as_str().parse().ok()?, float.to_string())),
        DeValue::Integer(whole) if whole.radix() == 10 => {
            Some((whole.as_str().parse().ok()?, whole.to_string()))
        }
        DeValue::Integer(whole) => {
            // Beyond 128 bits it is beyond every range.
            let number = u128::from_str_radix(whole.as_str(), whole.radix()).unwrap_or(u128::MAX);
            Some((number as f32, whole.to_string()))
        }
        _ => None,
    }
}

/// Whether the value is a number, in whatever range.
pub fn is_number(value: &TomlValue<'_>) -> bool {
    matches!(value.get_ref(), DeValue::Float(_) | DeValue::Integer(_))
}

/// A number in a range.
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
    let fault = Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {spelling}"));
    reader.report(match range.suggestion(number) {
        Some(advice) => fault.with_help(advice),
        None => fault,
    })
}

/// An integer in a range.
pub fn integer_in(
    low: u32,
    high: u32,
    value: &TomlValue<'_>,
    key: &str,
    reader: &mut TableReader<'_>,
) -> Option<u32> {
    let needs = format!("an integer between {low} and {high}");
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

/// Declares types for numbers in ranges.
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
    /// A length of something, in scene lengths.
    PositiveLength: NumberRange::above(0.0, MAX_COORDINATE);
    /// A length that may be nothing.
    NonNegativeLength: NumberRange::SIZE;
    /// An angle of view, in degrees.
    ViewAngle: NumberRange { low: 0.0, high: 180.0, ends: (false, false) };
    /// The full angle of a cone of light, in degrees.
    ConeAngle: NumberRange::above(0.0, 360.0);
    /// The full angle of the brightest part of a cone of light, in degrees.
    BrightAngle: NumberRange::within(0.0, 360.0);
    /// What a colour is multiplied with.
    Intensity: NumberRange::BRIGHTNESS;
    /// The narrowness of a highlight.
    Shininess: NumberRange::within(0.0, 1e6);
    /// An index of refraction.
    RefractiveIndex: NumberRange::within(0.01, 100.0);
    /// How rough a surface is.
    Roughness: NumberRange::FRACTION;
}

/// Declares types for integers in ranges.
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
    /// Which body wins.
    Priority: 0, 255;
}
