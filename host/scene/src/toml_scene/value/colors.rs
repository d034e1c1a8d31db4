//! Colors: linear [r, g, b], a gray, `#rrggbb`, or a name.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use strahl_core::Rgb;
use toml::de::DeValue;

use super::numbers::{NumberRange, is_number};
use super::reader::{FromToml, TableReader, TomlValue};
use super::suggest::suggestion;
use super::vectors::{number_or_three, triple_schema};
use crate::diagnostics::Diagnostic;
use crate::quote::quoted;

/// The color names of CSS, in sRGB.
const NAMES: &[(&str, u32)] = &[
    ("black", 0x000000),
    ("white", 0xffffff),
    ("gray", 0x808080),
    ("silver", 0xc0c0c0),
    ("red", 0xff0000),
    ("green", 0x008000),
    ("lime", 0x00ff00),
    ("blue", 0x0000ff),
    ("yellow", 0xffff00),
    ("cyan", 0x00ffff),
    ("magenta", 0xff00ff),
    ("orange", 0xffa500),
    ("gold", 0xffd700),
    ("tomato", 0xff6347),
    ("pink", 0xffc0cb),
    ("purple", 0x800080),
    ("brown", 0xa52a2a),
    ("maroon", 0x800000),
    ("olive", 0x808000),
    ("teal", 0x008080),
    ("navy", 0x000080),
    ("skyblue", 0x87ceeb),
    ("beige", 0xf5f5dc),
    ("ivory", 0xfffff0),
];

/// A color without an upper bound of 1.
#[derive(Clone, Copy, Debug)]
pub struct ColorValue(pub Rgb);

/// A color whose channels are in `[0, 1]`: a reflectance or transmittance.
#[derive(Clone, Copy, Debug)]
pub struct UnitColor(pub Rgb);

/// The attenuation length for each channel, in `(0, inf]`.
#[derive(Clone, Copy, Debug)]
pub struct AttenuationLength(pub Rgb);

impl FromToml for ColorValue {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        read_color(NumberRange::BRIGHTNESS, value, key, reader).map(ColorValue)
    }
}

impl FromToml for UnitColor {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        read_color(NumberRange::FRACTION, value, key, reader).map(UnitColor)
    }
}

impl FromToml for AttenuationLength {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        number_or_three(NumberRange::ATTENUATION_LENGTH, value, key, reader)
            .map(|[r, g, b]| AttenuationLength(Rgb::new(r, g, b)))
    }
}

fn read_color(
    range: NumberRange,
    value: &TomlValue<'_>,
    key: &str,
    reader: &mut TableReader<'_>,
) -> Option<Rgb> {
    let wrong = match value.get_ref() {
        DeValue::String(text) => match parse_color(text) {
            Ok(color) => return Some(color),
            Err(wrong) => wrong,
        },
        DeValue::Array(_) => {
            return number_or_three(range, value, key, reader).map(|[r, g, b]| Rgb::new(r, g, b));
        }
        _ if is_number(value) => {
            return number_or_three(range, value, key, reader).map(|[r, g, b]| Rgb::new(r, g, b));
        }
        _ => return reader.report_type(value, key, "a color: [r, g, b], a number, \"#rrggbb\" or a name"),
    };
    reader.report(Diagnostic::new(value.span(), wrong.0).with_help(wrong.1))
}

/// Parses a color; an error has a message and advice.
fn parse_color(text: &str) -> Result<Rgb, (String, String)> {
    if let Some(digits) = text.strip_prefix('#') {
        let code = match digits.len() {
            6 if digits.bytes().all(|byte| byte.is_ascii_hexdigit()) => u32::from_str_radix(digits, 16).ok(),
            _ => None,
        };
        let wrong =
            || (format!("{} is not a color", quoted(text)), "write # and six hexadecimal digits".into());
        return code.map(from_srgb_code).ok_or_else(wrong);
    }
    match NAMES.iter().find(|(name, _)| *name == text) {
        Some((_, code)) => Ok(from_srgb_code(*code)),
        None => {
            let names: Vec<&str> = NAMES.iter().map(|(name, _)| *name).collect();
            let help = match suggestion(text, &names) {
                Some(meant) => format!("did you mean {meant}?"),
                None => format!("write \"#rrggbb\", [r, g, b] or one of {}", names.join(", ")),
            };
            Err((format!("unknown color {}", quoted(text)), help))
        }
    }
}

/// Whether `name` is the name of a color.
pub fn is_color_name(name: &str) -> bool {
    NAMES.iter().any(|(other, _)| *other == name)
}

/// Decodes three sRGB bytes (IEC 61966-2-1) to linear light.
fn from_srgb_code(code: u32) -> Rgb {
    let channel = |shift: u32| {
        let v = f64::from(code >> shift & 0xff) / 255.0;
        // libm: identical on all platforms.
        let linear = if v <= 0.04045 { v / 12.92 } else { libm::pow((v + 0.055) / 1.055, 2.4) };
        linear as f32
    };
    Rgb::new(channel(16), channel(8), channel(0))
}

fn color_schema(range: NumberRange, name: &str, about: &str) -> Schema {
    let names: Vec<&str> = NAMES.iter().map(|(name, _)| *name).collect();
    json_schema!({
        "title": name,
        "description": about,
        "anyOf": [
            triple_schema(range),
            range.schema(),
            { "type": "string", "pattern": "^#[0-9a-fA-F]{6}$" },
            { "enum": names }
        ]
    })
}

impl JsonSchema for ColorValue {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Color".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        color_schema(
            NumberRange::BRIGHTNESS,
            "Color",
            "Linear [r, g, b], a gray, \"#rrggbb\" in sRGB, or a name.",
        )
    }
}

impl JsonSchema for UnitColor {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Share".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        color_schema(
            NumberRange::FRACTION,
            "Share",
            "A reflectance or transmittance: a number from 0 to 1, or a color.",
        )
    }
}

impl JsonSchema for AttenuationLength {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Clarity".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [NumberRange::ATTENUATION_LENGTH.schema(), triple_schema(NumberRange::ATTENUATION_LENGTH)] })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_srgb_code_is_encoded_to_the_same_bytes_in_a_picture() {
        for code in 0..=255 {
            let gray = from_srgb_code(code << 16 | code << 8 | code);
            assert_eq!(gray.to_srgb8(), [code as u8; 3]);
        }
        assert_eq!(from_srgb_code(0xff0000), Rgb::new(1.0, 0.0, 0.0));
        for (name, code) in NAMES {
            assert_eq!(parse_color(name), parse_color(&format!("#{code:06x}")));
        }
    }
}
