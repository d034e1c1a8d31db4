//! Settings in JSON: their values and their JSON Schema.

use schemars::{Schema, json_schema};
use serde_json::Value as Json;

use crate::choice::Named;
use crate::domain::Domain;
use crate::settings::{Setting, Settings, SettingsOverrides};

impl Setting {
    /// Its value; null if it has none.
    pub fn to_json(&self, settings: &Settings) -> Json {
        let literal = self.literal(settings);
        literal.and_then(|literal| serde_json::from_str(&literal).ok()).unwrap_or(Json::Null)
    }

    /// Reads a value; in the result only this setting is set, or none for null.
    pub fn parse_json(&self, value: &Json) -> Result<SettingsOverrides, String> {
        let mismatch = || Err(format!("`{}` must be {}, not {value}", self.name, self.domain));
        let word = match (value, self.domain) {
            (Json::Null, _) => return Ok(SettingsOverrides::default()),
            (Json::Bool(it), Domain::Flag) => it.to_string(),
            (Json::Number(it), Domain::Integer(..) | Domain::OneOf(_) | Domain::Fraction) => it.to_string(),
            (Json::String(it), Domain::Name(_) | Domain::Text) => it.clone(),
            (Json::Array(list), Domain::Names(_)) if list.is_empty() => {
                return Ok(SettingsOverrides::default());
            }
            (Json::Array(list), Domain::Names(_)) => joined(list, ",", |it| it.as_str().map(str::to_owned)),
            (Json::Array(list), Domain::Size) => joined(list, "x", |it| it.as_u64().map(|it| it.to_string())),
            _ => return mismatch(),
        };
        self.parse(&word)
    }

    /// The JSON Schema of its values, with its help and its default.
    pub fn schema(&self) -> Schema {
        let names = |all: &[Named]| all.iter().map(|it| it.name).collect::<Vec<_>>();
        let mut schema = match self.domain {
            Domain::Flag => json_schema!({ "type": "boolean" }),
            Domain::Integer(first, last) => {
                json_schema!({ "type": "integer", "minimum": first, "maximum": last })
            }
            Domain::OneOf(numbers) => json_schema!({ "enum": numbers }),
            Domain::Fraction => json_schema!({ "type": "number", "minimum": 0, "maximum": 1 }),
            Domain::Name(all) => json_schema!({ "enum": names(all) }),
            Domain::Names(all) => json_schema!({ "type": "array", "items": { "enum": names(all) } }),
            Domain::Size => json_schema!({
                "type": "array",
                "items": { "type": "integer", "minimum": 1, "maximum": strahl_core::Resolution::MAX_SIDE },
                "minItems": 2,
                "maxItems": 2,
            }),
            Domain::Text => json_schema!({ "type": "string" }),
        };
        let default = match self.literal(&Settings::default()) {
            // The number of threads depends on the machine.
            _ if !self.is_in_scenes() => String::new(),
            Some(literal) => format!(" Default: {literal}."),
            None => String::new(),
        };
        schema.insert("description".into(), format!("{}.{default}", self.about()).into());
        schema
    }
}

fn joined(list: &[Json], between: &str, word: fn(&Json) -> Option<String>) -> String {
    list.iter().filter_map(word).collect::<Vec<_>>().join(between)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::SETTINGS;

    #[test]
    fn every_value_reads_back_equal() {
        let changed = Settings {
            size: strahl_core::Resolution::new(8, 6).unwrap(),
            cutoff: 0.1,
            select: "8:0.05:items".parse().ok(),
            without: vec![crate::OptionalEffect::Lens, crate::OptionalEffect::Motion],
            colored_shadows: true,
            ..Settings::default()
        };
        for settings in [Settings::default(), changed] {
            for setting in SETTINGS {
                let json = setting.to_json(&settings);
                let read = Settings::from(setting.parse_json(&json).unwrap());
                assert_eq!(setting.word(&read), setting.word(&settings), "{} is {json}", setting.name);
            }
        }
    }

    #[test]
    fn values_of_another_type_are_rejected() {
        for setting in SETTINGS {
            for json in [Json::from(1e9), Json::from("no such thing"), serde_json::json!({})] {
                assert!(setting.parse_json(&json).is_err(), "{} is {json}", setting.name);
            }
        }
    }
}
