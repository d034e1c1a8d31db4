//! Places, directions and sizes: threes of numbers.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use toml::de::DeValue;

use super::numbers::{Length, Range, is_number, number_in};
use super::reader::{Read, Reader, Spanned, Value};
use crate::description::Float3;
use crate::diagnostics::Diagnostic;

/// The values of an array of three.
pub fn three<'v, 't>(
    value: &'v Value<'t>,
    key: &str,
    needs: &str,
    reader: &mut Reader<'_>,
) -> Option<[&'v Value<'t>; 3]> {
    let DeValue::Array(list) = value.get_ref() else {
        return reader.mismatch(value, key, needs);
    };
    match &list[..] {
        [x, y, z] => Some([x, y, z]),
        _ => {
            let count = list.len();
            reader.wrong(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {count}")))
        }
    }
}

/// Three numbers in a range.
pub fn triple_in(range: Range, value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Float3> {
    let [x, y, z] = three(value, key, "three numbers, as in [0, 1, 2]", reader)?;
    // All of them are read, so that all of them are told.
    let [x, y, z] = [x, y, z].map(|value| number_in(range, value, key, reader));
    Some([x?, y?, z?])
}

/// Three numbers, or one for all three.
pub fn one_or_three(range: Range, value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Float3> {
    if is_number(value) {
        return number_in(range, value, key, reader).map(|x| [x; 3]);
    }
    match value.get_ref() {
        DeValue::Array(_) => triple_in(range, value, key, reader),
        _ => reader.mismatch(value, key, "a number or three numbers"),
    }
}

/// The schema of three numbers.
pub fn triple_schema(range: Range) -> Schema {
    json_schema!({ "type": "array", "items": range.schema(), "minItems": 3, "maxItems": 3 })
}

/// Declares types for threes of numbers.
macro_rules! triples {
    ($($(#[$doc:meta])* $Name:ident: $read:expr, $schema:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $Name(pub Float3);

        impl Read for $Name {
            fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
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
    /// A place: coordinates in scene lengths.
    Point: |value, key, reader| triple_in(Range::SPACE, value, key, reader), triple_schema(Range::SPACE);
    /// A direction of any length but zero.
    Direction: direction, triple_schema(Range::SPACE);
    /// Lengths along three axes, none below zero.
    Sizes: |value, key, reader| one_or_three(Range::SIZE, value, key, reader), number_or_three(Range::SIZE);
    /// Degrees about three axes.
    Turn: |value, key, reader| triple_in(Range::TURN, value, key, reader), triple_schema(Range::TURN);
    /// Factors along three axes, none of them zero.
    Scale: scale, number_or_three(Range::SPACE);
    /// What a light is divided by: constant, linear and quadratic part.
    Falloff: falloff, json_schema!({
        "anyOf": [{ "enum": ["none", "linear", "square"] }, triple_schema(Range::SIZE)]
    });
}

fn number_or_three(range: Range) -> Schema {
    json_schema!({ "anyOf": [range.schema(), triple_schema(range)] })
}

fn direction(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Float3> {
    match triple_in(Range::SPACE, value, key, reader)? {
        [0.0, 0.0, 0.0] => {
            let fault =
                Diagnostic::new(value.span(), format!("`{key}` must be a direction, and has no length"));
            reader.wrong(fault.with_help("one of its numbers must not be 0"))
        }
        direction => Some(direction),
    }
}

fn scale(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Float3> {
    let factors = one_or_three(Range::SPACE, value, key, reader)?;
    if factors.contains(&0.0) {
        return reader.wrong(Diagnostic::new(value.span(), format!("`{key}` must not be 0")));
    }
    Some(factors)
}

fn falloff(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Float3> {
    let DeValue::String(name) = value.get_ref() else {
        let needs = "\"none\", \"linear\", \"square\" or three numbers";
        if !matches!(value.get_ref(), DeValue::Array(_)) {
            return reader.mismatch(value, key, needs);
        }
        let parts = triple_in(Range::SIZE, value, key, reader)?;
        if parts == [0.0; 3] {
            return reader.wrong(Diagnostic::new(value.span(), format!("one part of `{key}` must not be 0")));
        }
        return Some(parts);
    };
    match name.as_ref() {
        "none" => Some([1.0, 0.0, 0.0]),
        "linear" => Some([0.0, 1.0, 0.0]),
        "square" => Some([0.0, 0.0, 1.0]),
        _ => {
            let what = format!("`{key}` is none of \"none\", \"linear\" and \"square\"");
            let help = "\"square\" is as physics has it; [constant, linear, quadratic] is any other";
            reader.wrong(Diagnostic::new(value.span(), what).with_help(help))
        }
    }
}

/// Places in a row.
#[derive(Clone, Debug)]
pub struct Points(pub Vec<Spanned<Point>>);

/// Directions in a row.
#[derive(Clone, Debug)]
pub struct Directions(pub Vec<Direction>);

/// The values of an array, all of which are read.
fn row<T: Read>(value: &Value<'_>, key: &str, needs: &str, reader: &mut Reader<'_>) -> Option<Vec<T>> {
    let DeValue::Array(list) = value.get_ref() else {
        return reader.mismatch(value, key, needs);
    };
    if !list.is_empty() && list.iter().all(|value| !value.get_ref().is_array()) {
        let what = format!("`{key}` must be {needs}, not one of single values");
        return reader.wrong(Diagnostic::new(value.span(), what));
    }
    let before = reader.faults.count;
    let row = list.iter().filter_map(|value| T::read(value, key, reader)).collect();
    (reader.faults.count == before).then_some(row)
}

impl Read for Points {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        row(value, key, "an array of places, as in [[0, 0, 0], [1, 0, 0], [0, 1, 0]]", reader).map(Points)
    }
}

impl Read for Directions {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        row(value, key, "an array of directions, one for each corner", reader).map(Directions)
    }
}

/// The schema of a row is an array of three or more.
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
                json_schema!({ "type": "array", "items": triple_schema(Range::SPACE), "minItems": 3 })
            }
        }
    };
}
row_schema!(Points);
row_schema!(Directions);

/// A width and a height in scene lengths, or one number for both.
#[derive(Clone, Copy, Debug)]
pub struct Pair(pub [f32; 2]);

impl Read for Pair {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        if is_number(value) {
            return Length::read(value, key, reader).map(|Length(side)| Pair([side; 2]));
        }
        let needs = "two numbers, as in [2, 1]";
        let DeValue::Array(list) = value.get_ref() else {
            return reader.mismatch(value, key, "a number or two numbers");
        };
        let [width, height] = &list[..] else {
            let count = list.len();
            return reader
                .wrong(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {count}")));
        };
        let [width, height] = [width, height].map(|value| Length::read(value, key, reader));
        Some(Pair([width?.0, height?.0]))
    }
}

impl JsonSchema for Pair {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Pair".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let length = Length::json_schema(generator);
        let both = json_schema!({ "type": "array", "items": length.clone(), "minItems": 2, "maxItems": 2 });
        json_schema!({ "anyOf": [length, both] })
    }
}

/// When a shutter opens and closes, or how long it is open.
#[derive(Clone, Copy, Debug)]
pub struct Shutter(pub [f32; 2]);

impl Read for Shutter {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        if is_number(value) {
            return number_in(Range::SIZE, value, key, reader).map(|closes| Shutter([0.0, closes]));
        }
        let needs = "two times, as in [0, 1]";
        let DeValue::Array(list) = value.get_ref() else {
            return reader.mismatch(value, key, "a number or two times");
        };
        let [opens, closes] = &list[..] else {
            let count = list.len();
            return reader
                .wrong(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {count}")));
        };
        let [opens, closes] = [opens, closes].map(|value| number_in(Range::SPACE, value, key, reader));
        let (opens, closes) = (opens?, closes?);
        if closes < opens {
            let what = format!("the `{key}` closes before it opens");
            let help = format!("did you mean [{closes}, {opens}]?");
            return reader.wrong(Diagnostic::new(value.span(), what).with_help(help));
        }
        Some(Shutter([opens, closes]))
    }
}

impl JsonSchema for Shutter {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Shutter".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let time = Range::SPACE.schema();
        let both = json_schema!({ "type": "array", "items": time, "minItems": 2, "maxItems": 2 });
        json_schema!({ "anyOf": [Range::SIZE.schema(), both] })
    }
}
