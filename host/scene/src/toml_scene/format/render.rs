//! The table `[render]`: its keys are the settings that a scene can have.

use std::collections::BTreeMap;
use std::ops::Range;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use strahl_core::Resolution;
use strahl_settings::{Domain, Filter, Named, SETTINGS, Setting, SettingsOverrides, Value as _, Walk};
use toml::de::DeValue;

use crate::diagnostics::Diagnostic;
use crate::limits::MAX_PIXELS_IN_FILE;
use crate::quote::quoted;
use crate::toml_scene::table::{Entry, KeyReader, Keys, add_aliases};
use crate::toml_scene::value::{
    FromToml, NumberRange, TableReader, TomlValue, integer_in, number_in, suggestion,
};

/// The settings in a scene file; the command line takes precedence.
#[derive(Debug, Default)]
pub struct RenderTable {
    /// The settings.
    pub settings: SettingsOverrides,
    /// The location of each setting, by key.
    pub spans: BTreeMap<&'static str, SettingSpan>,
}

/// The location of a setting, in bytes.
#[derive(Clone, Debug)]
pub struct SettingSpan {
    pub key: Range<usize>,
    pub value: Range<usize>,
}

impl RenderTable {
    /// The errors of settings that exclude each other.
    pub fn conflicts(&self) -> Vec<Diagnostic> {
        let place = |key| self.spans.get(key).map_or(0..0, |place| place.value.clone());
        let mut diagnostics = Vec::new();
        let SettingsOverrides { sampler, filter, walk, heap, .. } = &self.settings;
        if filter.is_some_and(|filter| filter != Filter::Box)
            && sampler.is_some_and(|sampler| !sampler.allows_filter())
        {
            let diagnostic =
                Diagnostic::new(place("filter"), "this sampler supports only the filter \"box\"");
            diagnostics.push(diagnostic.with_related(place("sampler"), "set here"));
        }
        if *walk == Some(Walk::Stack) && heap.is_some() {
            let diagnostic = Diagnostic::new(place("heap"), "`heap` requires walk = \"heap\"");
            diagnostics.push(diagnostic.with_related(place("walk"), "set here"));
        }
        diagnostics
    }
}

/// Aliases of keys.
const ALIASES: &[(&str, &str)] = &[("max_depth", "levels")];

/// The settings that a scene can set.
fn settings() -> impl Iterator<Item = &'static Setting> {
    SETTINGS.iter().filter(|setting| setting.is_in_scenes())
}

impl FromToml for RenderTable {
    fn from_toml(value: &TomlValue<'_>, name: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        let keys: Vec<&str> = settings().map(|setting| setting.name).collect();
        let table = KeyReader::of(value, name, Keys { keys: &keys, aliases: ALIASES }, reader)?;
        let mut render = RenderTable::default();
        for setting in settings() {
            let Some(Entry { key, span, value }) = table.entry(setting.name) else { continue };
            render.spans.insert(setting.name, SettingSpan { key: span, value: value.span() });
            if let Some(read) = read(setting, key, value, reader) {
                render.settings = render.settings.or(read);
            }
        }
        Some(render)
    }
}

/// Reads the value of a setting.
fn read(
    setting: &Setting,
    key: &str,
    value: &TomlValue<'_>,
    reader: &mut TableReader<'_>,
) -> Option<SettingsOverrides> {
    let word = word(setting, key, value, reader)?;
    setting.parse(&word).map_or_else(
        |reason| {
            let diagnostic = Diagnostic::new(value.span(), format!("invalid {key}"));
            reader.report(diagnostic.with_help(reason))
        },
        Some,
    )
}

/// Reads the value of a setting as an option value of the command line.
fn word(setting: &Setting, key: &str, value: &TomlValue<'_>, reader: &mut TableReader<'_>) -> Option<String> {
    match setting.domain {
        Domain::Flag => bool::from_toml(value, key, reader).map(|it| it.to_string()),
        Domain::Integer(first, last) => integer_in(first, last, value, key, reader).map(|it| it.to_string()),
        Domain::OneOf(numbers) => one_of(numbers, value, key, reader).map(|it| it.to_string()),
        Domain::Fraction => number_in(NumberRange::FRACTION, value, key, reader).map(|it| it.to_string()),
        Domain::Name(names) => name(names, value, key, reader),
        Domain::Names(_) | Domain::Text => String::from_toml(value, key, reader),
        Domain::Size => size(value, key, reader).and_then(|size| size.word()),
    }
}

fn one_of(
    numbers: &[usize],
    value: &TomlValue<'_>,
    key: &str,
    reader: &mut TableReader<'_>,
) -> Option<usize> {
    let names: Vec<_> = numbers.iter().map(usize::to_string).collect();
    let needs = format!("one of {}", names.join(", "));
    let DeValue::Integer(whole) = value.get_ref() else {
        return reader.report_type(value, key, &needs);
    };
    let number = usize::from_str_radix(whole.as_str(), whole.radix()).ok();
    if let Some(number) = number.filter(|number| numbers.contains(number)) {
        return Some(number);
    }
    let spelling: String = whole.to_string().chars().take(40).collect();
    reader.report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {spelling}")))
}

fn name(names: &[Named], value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<String> {
    let word = String::from_toml(value, key, reader)?;
    let names: Vec<_> = names.iter().map(|it| it.name).collect();
    if names.contains(&word.as_str()) {
        return Some(word);
    }
    let help = match suggestion(&word, &names) {
        Some(meant) => format!("did you mean {meant}?"),
        None => format!("valid values: {}", names.join(", ")),
    };
    reader.report(
        Diagnostic::new(value.span(), format!("{} is not a valid `{key}`", quoted(&word))).with_help(help),
    )
}

fn size(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Resolution> {
    let needs = "two integers, as in [640, 480]";
    let DeValue::Array(list) = value.get_ref() else {
        return reader.report_type(value, key, needs);
    };
    let [width, height] = &list[..] else {
        let count = list.len();
        return reader.report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {count}")));
    };
    let [width, height] =
        [width, height].map(|value| integer_in(1, Resolution::MAX_SIDE, value, key, reader));
    let (width, height) = (width?, height?);
    match Resolution::new(width, height) {
        Some(size) if u64::from(width) * u64::from(height) <= MAX_PIXELS_IN_FILE => Some(size),
        _ => {
            let message = format!("{width} x {height} pixels exceed the limit for a file");
            let help = format!("use at most {MAX_PIXELS_IN_FILE} pixels, or --size on the command line");
            reader.report(Diagnostic::new(value.span(), message).with_help(help))
        }
    }
}

impl JsonSchema for RenderTable {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Render".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let mut properties = serde_json::Map::new();
        for setting in settings() {
            properties.insert(setting.name.into(), setting.schema().to_value());
        }
        let mut schema = json_schema!({
            "description": "Render settings; the command line takes precedence.",
            "type": "object",
            "properties": properties,
            "additionalProperties": false,
        });
        add_aliases(ALIASES, &mut schema);
        schema
    }
}
