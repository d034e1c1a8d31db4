//! The settings of a run, as `study.json` holds them.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error as _;
use serde::ser::SerializeMap as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};
use strahl_settings::{Domain, Group, ResolvedAccel, SETTINGS, Setting, Settings, SettingsOverrides};

/// All settings that determine a picture and its time.
#[derive(Clone, Debug, PartialEq)]
pub struct RunSettings {
    /// The settings. The size is not recorded: it is that of the study.
    pub settings: Settings,
    /// The accelerator, as text.
    pub accelerator: String,
    /// The equivalent command-line options.
    pub options: String,
}

/// The field of [`RunSettings::accelerator`].
const ACCELERATOR: &str = "accelerator";
/// The field of [`RunSettings::options`].
const OPTIONS: &str = "options";

impl RunSettings {
    /// The settings of a run with this accelerator.
    pub fn new(settings: &Settings, choice: &ResolvedAccel) -> Self {
        let (accelerator, options) = (choice.to_string(), command_line(settings));
        RunSettings { settings: settings.clone(), accelerator, options }
    }

    /// Declarations of the recorded settings.
    pub fn recorded() -> impl Iterator<Item = &'static Setting> {
        SETTINGS.iter().filter(|it| it.option_name().is_some() && !matches!(it.domain, Domain::Size))
    }

    /// The kind of accelerator: the first word of its text.
    pub fn accelerator_kind(&self) -> &str {
        self.accelerator.split(' ').next().unwrap_or_default()
    }
}

impl Serialize for RunSettings {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for setting in RunSettings::recorded() {
            map.serialize_entry(setting.name, &setting.to_json(&self.settings))?;
        }
        map.serialize_entry(ACCELERATOR, &self.accelerator)?;
        map.serialize_entry(OPTIONS, &self.options)?;
        map.end()
    }
}

impl<'de> Deserialize<'de> for RunSettings {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut fields = Map::deserialize(deserializer)?;
        let mut text = |name| match fields.remove(name) {
            Some(Value::String(text)) => Ok(text),
            Some(other) => Err(D::Error::custom(format!("`{name}` must be a string, not {other}"))),
            None => Err(D::Error::missing_field(name)),
        };
        let (accelerator, options) = (text(ACCELERATOR)?, text(OPTIONS)?);
        let mut settings = SettingsOverrides::default();
        for (name, value) in &fields {
            let Some(setting) = RunSettings::recorded().find(|setting| setting.name == name) else {
                return Err(D::Error::custom(format!("unknown field `{name}`")));
            };
            settings = settings.or(setting.parse_json(value).map_err(D::Error::custom)?);
        }
        Ok(RunSettings { settings: settings.into(), accelerator, options })
    }
}

impl JsonSchema for RunSettings {
    fn schema_name() -> Cow<'static, str> {
        "RunSettings".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let mut properties = Map::new();
        for setting in RunSettings::recorded() {
            let schema = setting.schema().to_value();
            let is_always = !setting.to_json(&Settings::default()).is_null();
            let schema = if is_always {
                schema
            } else {
                json_schema!({ "anyOf": [schema, { "type": "null" }] }).to_value()
            };
            properties.insert(setting.name.into(), schema);
        }
        let text = |about: &str| json_schema!({ "description": about, "type": "string" }).to_value();
        properties.insert(ACCELERATOR.into(), text("The accelerator, as text."));
        properties.insert(OPTIONS.into(), text("The equivalent command-line options."));
        json_schema!({
            "description": "All settings that determine a picture and its time, with the values of the command line.",
            "type": "object",
            "properties": properties,
            "required": [ACCELERATOR, OPTIONS],
            "additionalProperties": false,
        })
    }
}

/// The equivalent command-line options: levels, cutoff and sampler, and other settings that are not defaults. Size and threads
/// are left out.
pub fn command_line(settings: &Settings) -> String {
    let defaults = Settings::default();
    let is_shown = |it: &&Setting| {
        let is_basic = it.group == Group::Frame || it.name == "sampler";
        let is_of_study = it.name == "size" || it.group == Group::Work;
        !is_of_study && (is_basic || it.word(settings) != it.word(&defaults))
    };
    let options = settings.in_use().filter(is_shown).filter_map(|it| it.option(settings));
    options.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_those_of_the_command_line_without_defaults() {
        assert_eq!(command_line(&Settings::default()), "--levels 5 --cutoff 1/512 --sampler single");
        let settings = Settings { threads: 7, mailbox: 8, shadow_cache: false, ..Settings::default() };
        assert_eq!(
            command_line(&settings),
            "--levels 5 --cutoff 1/512 --sampler single --mailbox 8 --no-shadow-cache"
        );
    }
}
