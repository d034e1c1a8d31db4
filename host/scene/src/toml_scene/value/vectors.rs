//! Points, directions, sizes and other arrays of numbers.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use toml::de::DeValue;

use super::numbers::{NumberRange, PositiveLength, is_number, number_in};
use super::reader::{FromToml, Spanned, TableReader, TomlValue};
use crate::description::Float3;
use crate::diagnostics::Diagnostic;

/// The values of an array of three; `needs` describes it in errors.
pub fn array_of_three<'v, 't>(
    value: &'v TomlValue<'t>,
    key: &str,
    needs: &str,
    reader: &mut TableReader<'_>,
) -> Option<[&'v TomlValue<'t>; 3]> {
    let DeValue::Array(list) = value.get_ref() else {
        return reader.report_type(value, key, needs);
    };
    match &list[..] {
        [x, y, z] => Some([x, y, z]),
        _ => {
            let count = list.len();
            reader.report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {count}")))
        }
    }
}

/// Reads three numbers in a range.
pub fn triple_in(
    range: NumberRange,
    value: &TomlValue<'_>,
    key: &str,
    reader: &mut TableReader<'_>,
) -> Option<Float3> {
    let [x, y, z] = array_of_three(value, key, "three numbers, as in [0, 1, 2]", reader)?;
    // All three are read before an error ends the function.
    let [x, y, z] = [x, y, z].map(|value| number_in(range, value, key, reader));
    Some([x?, y?, z?])
}

/// Reads three numbers, or one for all three.
pub fn number_or_three(
    range: NumberRange,
    value: &TomlValue<'_>,
    key: &str,
    reader: &mut TableReader<'_>,
) -> Option<Float3> {
    if is_number(value) {
        return number_in(range, value, key, reader).map(|x| [x; 3]);
    }
    match value.get_ref() {
        DeValue::Array(_) => triple_in(range, value, key, reader),
        _ => reader.report_type(value, key, "a number or three numbers"),
    }
}

/// The JSON Schema of three numbers.
pub fn triple_schema(range: NumberRange) -> Schema {
    json_schema!({ "type": "array", "items": range.schema(), "minItems": 3, "maxItems": 3 })
}

/// Declares types of three numbers.
macro_rules! triples {
    ($($(#[$doc:meta])* $Name:ident: $read:expr, $schema:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $Name(pub Float3);

        impl FromToml for $Name {
            fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
                #[allow(clippy::redundant_closure_call)]
                ($read)(value, key, reader).map($Name)
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
                $schema
            }
        }
    )*};
}

triples! {
    /// A point, in scene lengths.
    PointValue: |value, key, reader| triple_in(NumberRange::COORDINATE, value, key, reader), triple_schema(NumberRange::COORDINATE);
    /// A direction of any length but zero.
    DirectionValue: direction, triple_schema(NumberRange::COORDINATE);
    /// Lengths along three axes, at least zero.
    BoxSize: |value, key, reader| number_or_three(NumberRange::SIZE, value, key, reader), number_or_three_schema(NumberRange::SIZE);
    /// Angles of rotation about three axes, in degrees.
    EulerAngles: |value, key, reader| triple_in(NumberRange::ROTATION, value, key, reader), triple_schema(NumberRange::ROTATION);
    /// Factors along three axes, none of them zero.
    ScaleFactors: scale, number_or_three_schema(NumberRange::COORDINATE);
    /// The constant, linear and quadratic coefficients of the divisor of a light.
    FalloffValue: falloff, json_schema!({
        "anyOf": [{ "enum": ["none", "linear", "square"] }, triple_schema(NumberRange::SIZE)]
    });
}

fn number_or_three_schema(range: NumberRange) -> Schema {
    json_schema!({ "anyOf": [range.schema(), triple_schema(range)] })
}

fn direction(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Float3> {
    match triple_in(NumberRange::COORDINATE, value, key, reader)? {
        [0.0, 0.0, 0.0] => {
            let diagnostic = Diagnostic::new(value.span(), format!("`{key}` must not be the zero vector"));
            reader.report(diagnostic.with_help("at least one component must not be 0"))
        }
        direction => Some(direction),
    }
}

fn scale(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Float3> {
    let factors = number_or_three(NumberRange::COORDINATE, value, key, reader)?;
    if factors.contains(&0.0) {
        return reader.report(Diagnostic::new(value.span(), format!("`{key}` must not be 0")));
    }
    Some(factors)
}

fn falloff(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Float3> {
    let DeValue::String(name) = value.get_ref() else {
        let needs = "\"none\", \"linear\", \"square\" or three numbers";
        if !matches!(value.get_ref(), DeValue::Array(_)) {
            return reader.report_type(value, key, needs);
        }
        let parts = triple_in(NumberRange::SIZE, value, key, reader)?;
        if parts == [0.0; 3] {
            return reader.report(Diagnostic::new(
                value.span(),
                format!("at least one coefficient of `{key}` must not be 0"),
            ));
        }
        return Some(parts);
    };
    match name.as_ref() {
        "none" => Some([1.0, 0.0, 0.0]),
        "linear" => Some([0.0, 1.0, 0.0]),
        "square" => Some([0.0, 0.0, 1.0]),
        _ => {
            let message = format!("`{key}` is none of \"none\", \"linear\" and \"square\"");
            let help = "\"square\" is the physical falloff; [constant, linear, quadratic] sets any other";
            reader.report(Diagnostic::new(value.span(), message).with_help(help))
        }
    }
}

/// A list of points.
#[derive(Clone, Debug)]
pub struct PointList(pub Vec<Spanned<PointValue>>);

/// A list of directions.
#[derive(Clone, Debug)]
pub struct DirectionList(pub Vec<DirectionValue>);

/// Reads all values of an array; `needs` describes it in errors.
fn read_list<T: FromToml>(
    value: &TomlValue<'_>,
    key: &str,
    needs: &str,
    reader: &mut TableReader<'_>,
) -> Option<Vec<T>> {
    let DeValue::Array(list) = value.get_ref() else {
        return reader.report_type(value, key, needs);
    };
    if !list.is_empty() && list.iter().all(|value| !value.get_ref().is_array()) {
        let message = format!("`{key}` must be {needs}, not an array of single values");
        return reader.report(Diagnostic::new(value.span(), message));
    }
    let before = reader.diagnostics.total;
    let row = list.iter().filter_map(|value| T::from_toml(value, key, reader)).collect();
    (reader.diagnostics.total == before).then_some(row)
}

impl FromToml for PointList {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        read_list(value, key, "an array of points, as in [[0, 0, 0], [1, 0, 0], [0, 1, 0]]", reader)
            .map(PointList)
    }
}

impl FromToml for DirectionList {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        read_list(value, key, "an array of directions, one for each corner", reader).map(DirectionList)
    }
}

/// The JSON Schema of an array of three or more triples.
macro_rules! row_schema {
    ($Name:ident) => {
        impl JsonSchema for $Name {
            fn inline_schema() -> bool {
                true
            }
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($Name).into()
            }
            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({ "type": "array", "items": triple_schema(NumberRange::COORDINATE), "minItems": 3 })
            }
        }
    };
}
row_schema!(PointList);
row_schema!(DirectionList);

/// A width and a height in scene lengths, or one number for both.
#[derive(Clone, Copy, Debug)]
pub struct RectangleSize(pub [f32; 2]);

impl FromToml for RectangleSize {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        if is_number(value) {
            return PositiveLength::from_toml(value, key, reader)
                .map(|PositiveLength(side)| RectangleSize([side; 2]));
        }
        let needs = "two numbers, as in [2, 1]";
        let DeValue::Array(list) = value.get_ref() else {
            return reader.report_type(value, key, "a number or two numbers");
        };
        let [width, height] = &list[..] else {
            let count = list.len();
            return reader
                .report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {count}")));
        };
        let [width, height] = [width, height].map(|value| PositiveLength::from_toml(value, key, reader));
        Some(RectangleSize([width?.0, height?.0]))
    }
}

impl JsonSchema for RectangleSize {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Pair".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let length = PositiveLength::json_schema(generator);
        let both = json_schema!({ "type": "array", "items": length.clone(), "minItems": 2, "maxItems": 2 });
        json_schema!({ "anyOf": [length, both] })
    }
}

/// The times at which a shutter opens and closes; one number is the closing time.
#[derive(Clone, Copy, Debug)]
pub struct ShutterInterval(pub [f32; 2]);

impl FromToml for ShutterInterval {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        if is_number(value) {
            return number_in(NumberRange::SIZE, value, key, reader)
                .map(|closes| ShutterInterval([0.0, closes]));
        }
        let needs = "two times, as in [0, 1]";
        let DeValue::Array(list) = value.get_ref() else {
            return reader.report_type(value, key, "a number or two times");
        };
        let [opens, closes] = &list[..] else {
            let count = list.len();
            return reader
                .report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {count}")));
        };
        let [opens, closes] =
            [opens, closes].map(|value| number_in(NumberRange::COORDINATE, value, key, reader));
        let (opens, closes) = (opens?, closes?);
        if closes < opens {
            let message = format!("the `{key}` closes before it opens");
            let help = format!("did you mean [{closes}, {opens}]?");
            return reader.report(Diagnostic::new(value.span(), message).with_help(help));
        }
        Some(ShutterInterval([opens, closes]))
    }
}

impl JsonSchema for ShutterInterval {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Shutter".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let time = NumberRange::COORDINATE.schema();
        let both = json_schema!({ "type": "array", "items": time, "minItems": 2, "maxItems": 2 });
        json_schema!({ "anyOf": [NumberRange::SIZE.schema(), both] })
    }
}
