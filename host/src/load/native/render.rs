//! The table `[render]`: its keys are the settings that a scene can have.

use std::collections::BTreeMap;
use std::ops::Range;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use strahl_core::Resolution;
use strahl_settings::{
    Domain, Filter, Named, PartialSettings, SETTINGS, Setting, Settings, Value as _, Walk,
};
use toml::de::DeValue;

use super::numbers::{self, number_in, whole_in};
use super::similar::meant;
use super::table::{Keys, Read, Reader, Value};
use crate::faults::Fault;
use crate::load::MOST_PIXELS;
use crate::load::shown::shown;

/// Which picture is asked for; the command line wins.
#[derive(Debug, Default)]
pub(super) struct Render {
    /// The settings.
    pub(super) settings: PartialSettings,
    /// Where each of them stands, by its key.
    pub(super) places: BTreeMap<&'static str, Place>,
}

/// Where a setting stands, in bytes.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub(super) key: Range<usize>,
    pub(super) value: Range<usize>,
}

impl Render {
    /// What is wrong with settings that do not go together.
    pub(super) fn faults(&self) -> Vec<Fault> {
        let place = |key| self.places.get(key).map_or(0..0, |place| place.value.clone());
        let mut faults = Vec::new();
        let PartialSettings { sampler, filter, walk, heap, .. } = &self.settings;
        if filter.is_some_and(|filter| filter != Filter::Box)
            && sampler.is_some_and(|sampler| !sampler.takes_filter())
        {
            let fault = Fault::new(place("filter"), "no filter but \"box\" goes with this sampler");
            faults.push(fault.also(place("sampler"), "it fills the pixel by itself"));
        }
        if *walk == Some(Walk::Stack) && heap.is_some() {
            let fault = Fault::new(place("heap"), "a walk with a stack has no `heap`");
            faults.push(fault.also(place("walk"), "the walk"));
        }
        faults
    }
}

/// The settings that a scene can have.
fn settings() -> impl Iterator<Item = &'static Setting> {
    SETTINGS.iter().filter(|setting| setting.is_in_scenes())
}

impl Read for Render {
    fn read(value: &Value<'_>, name: &str, reader: &mut Reader<'_>) -> Option<Self> {
        let keys: Vec<&str> = settings().map(|setting| setting.name).collect();
        let table = Keys::of(value, name, &keys, reader)?;
        let mut render = Render::default();
        for setting in settings() {
            let Some((key, value)) = table.entry(setting.name) else { continue };
            render.places.insert(setting.name, Place { key, value: value.span() });
            if let Some(read) = read(setting, value, reader) {
                render.settings = render.settings.or(read);
            }
        }
        Some(render)
    }
}

/// The value of a setting.
fn read(setting: &Setting, value: &Value<'_>, reader: &mut Reader<'_>) -> Option<PartialSettings> {
    let word = word(setting, value, reader)?;
    setting.parse(&word).map_or_else(
        |reason| {
            let fault = Fault::new(value.span(), format!("this is no {}", setting.name));
            reader.wrong(fault.help(reason))
        },
        Some,
    )
}

/// The value of a setting, as the command line has it.
fn word(setting: &Setting, value: &Value<'_>, reader: &mut Reader<'_>) -> Option<String> {
    let key = setting.name;
    match setting.domain {
        Domain::Flag => bool::read(value, key, reader).map(|it| it.to_string()),
        Domain::Integer(first, last) => whole_in(first, last, value, key, reader).map(|it| it.to_string()),
        Domain::OneOf(numbers) => one_of(numbers, value, key, reader).map(|it| it.to_string()),
        Domain::Share => number_in(numbers::Range::SHARE, value, key, reader).map(|it| it.to_string()),
        Domain::Name(names) => name(names, value, key, reader),
        Domain::Names(_) | Domain::Text => String::read(value, key, reader),
        Domain::Size => size(value, key, reader).and_then(|size| size.word()),
    }
}

fn one_of(numbers: &[usize], value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<usize> {
    let names: Vec<_> = numbers.iter().map(usize::to_string).collect();
    let needs = format!("one of {}", names.join(", "));
    let DeValue::Integer(whole) = value.get_ref() else {
        return reader.mismatch(value, key, &needs);
    };
    let number = usize::from_str_radix(whole.as_str(), whole.radix()).ok();
    if let Some(number) = number.filter(|number| numbers.contains(number)) {
        return Some(number);
    }
    let spelling: String = whole.to_string().chars().take(40).collect();
    reader.wrong(Fault::new(value.span(), format!("`{key}` must be {needs}, not {spelling}")))
}

fn name(names: &[Named], value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<String> {
    let word = String::read(value, key, reader)?;
    let names: Vec<_> = names.iter().map(|it| it.name).collect();
    if names.contains(&word.as_str()) {
        return Some(word);
    }
    let help = match meant(&word, &names) {
        Some(meant) => format!("did you mean {meant}?"),
        None => format!("there are {}", names.join(", ")),
    };
    reader.wrong(Fault::new(value.span(), format!("{} is no `{key}`", shown(&word))).help(help))
}

fn size(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Resolution> {
    let needs = "two integers, as in [640, 480]";
    let DeValue::Array(list) = value.get_ref() else {
        return reader.mismatch(value, key, needs);
    };
    let [width, height] = &list[..] else {
        let count = list.len();
        return reader.wrong(Fault::new(value.span(), format!("`{key}` must be {needs}, not {count}")));
    };
    let [width, height] = [width, height].map(|value| whole_in(1, Resolution::MOST, value, key, reader));
    let (width, height) = (width?, height?);
    match Resolution::new(width, height) {
        Some(size) if u64::from(width) * u64::from(height) <= MOST_PIXELS => Some(size),
        _ => {
            let what = format!("{width} x {height} pixels are more than a file may ask for");
            let help = format!("up to {MOST_PIXELS} pixels, or use --size on the command line");
            reader.wrong(Fault::new(value.span(), what).help(help))
        }
    }
}

impl JsonSchema for Render {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Render".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let mut properties = serde_json::Map::new();
        for setting in settings() {
            properties.insert(setting.name.into(), schema(setting).to_value());
        }
        json_schema!({
            "description": "What picture is wanted; the command line wins.",
            "type": "object",
            "properties": properties,
            "additionalProperties": false,
        })
    }
}

fn schema(setting: &Setting) -> Schema {
    let mut schema = match setting.domain {
        Domain::Flag => json_schema!({ "type": "boolean" }),
        Domain::Integer(first, last) => {
            json_schema!({ "type": "integer", "minimum": first, "maximum": last })
        }
        Domain::OneOf(numbers) => json_schema!({ "enum": numbers }),
        Domain::Share => numbers::Range::SHARE.schema(),
        Domain::Name(names) => {
            let names: Vec<_> = names.iter().map(|it| it.name).collect();
            json_schema!({ "enum": names })
        }
        Domain::Names(_) | Domain::Text => json_schema!({ "type": "string" }),
        Domain::Size => json_schema!({
            "type": "array",
            "items": { "type": "integer", "minimum": 1, "maximum": Resolution::MOST },
            "minItems": 2,
            "maxItems": 2,
        }),
    };
    let default =
        setting.literal(&Settings::default()).map(|it| format!(" Default: {it}.")).unwrap_or_default();
    schema.insert("description".into(), format!("{}.{default}", setting.about()).into());
    schema
}
