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
use crate::toml_scene::table::KeyReader;
use crate::toml_scene::value::{
    FromToml, NumberRange, TableReader, TomlValue, integer_in, number_in, suggestion,
};

/// Which picture is asked for; the command line wins.
#[derive(Debug, Default)]
pub struct RenderTable {
    /// The settings.
    pub settings: SettingsOverrides,
    /// Where each of them stands, by its key.
    pub spans: BTreeMap<&'static str, SettingSpan>,
}

/// Where a setting stands, in bytes.
#[derive(Clone, Debug)]
pub struct SettingSpan {
    pub key: Range<usize>,
    pub value: Range<usize>,
}

impl RenderTable {
    /// What is wrong with settings that do not go together.
    pub fn conflicts(&self) -> Vec<Diagnostic> {
        let place = |key| self.spans.get(key).map_or(0..0, |place| place.value.clone());
        let mut faults = Vec::new();
        let SettingsOverrides { sampler, filter, walk, heap, .. } = &self.settings;
        if filter.is_some_and(|filter| filter != Filter::Box)
            && sampler.is_some_and(|sampler| !sampler.allows_filter())
        {
            let fault = Diagnostic::new(place("filter"), "no filter but \"box\" goes with this sampler");
            faults.push(fault.with_related(place("sampler"), "it fills the pixel by itself"));
        }
        if *walk == Some(Walk::Stack) && heap.is_some() {
            let fault = Diagnostic::new(place("heap"), "a walk with a stack has no `heap`");
            faults.push(fault.with_related(place("walk"), "the walk"));
        }
        faults
    }
}

/// The settings that a scene can have.
fn settings() -> impl Iterator<Item = &'static Setting> {
    SETTINGS.iter().filter(|setting| setting.is_in_scenes())
}

impl FromToml for RenderTable {
    fn from_toml(value: &TomlValue<'_>, name: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        let keys: Vec<&str> = settings().map(|setting| setting.name).collect();
        let table = KeyReader::of(value, name, &keys, reader)?;
        let mut render = RenderTable::default();
        for setting in settings() {
            let Some((key, value)) = table.entry(setting.name) else { continue };
            render.spans.insert(setting.name, SettingSpan { key, value: value.span() });
            if let Some(read) = read(setting, value, reader) {
                render.settings = render.settings.or(read);
            }
        }
        Some(render)
    }
}

/// The value of a setting.
fn read(setting: &Setting, value: &TomlValue<'_>, reader: &mut TableReader<'_>) -> Option<SettingsOverrides> {
    let word = word(setting, value, reader)?;
    setting.parse(&word).map_or_else(
        |reason| {
            let fault = Diagnostic::new(value.span(), format!("this is no {}", setting.name));
            reader.report(fault.with_help(reason))
        },
        Some,
    )
}

/// The value of a setting, as the command line has it.
fn word(setting: &Setting, value: &TomlValue<'_>, reader: &mut TableReader<'_>) -> Option<String> {
    let key = setting.name;
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
        None => format!("there are {}", names.join(", ")),
    };
    reader.report(Diagnostic::new(value.span(), format!("{} is no `{key}`", quoted(&word))).with_help(help))
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
            let what = format!("{width} x {height} pixels are more than a file may ask for");
            let help = format!("up to {MAX_PIXELS_IN_FILE} pixels, or use --size on the command line");
            reader.report(Diagnostic::new(value.span(), what).with_help(help))
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
        json_schema!({
            "description": "What picture is wanted; the command line wins.",
            "type": "object",
            "properties": properties,
            "additionalProperties": false,
        })
    }
}
