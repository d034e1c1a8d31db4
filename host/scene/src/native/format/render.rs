//! The table `[render]`: its keys are the settings that a scene can have.

use std::collections::BTreeMap;
use std::ops::Range;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use strahl_core::Resolution;
use strahl_settings::{Domain, Filter, Named, SETTINGS, Setting, SettingsOverrides, Value as _, Walk};
use toml::de::DeValue;

use crate::diagnostics::Diagnostic;
use crate::limits::MOST_PIXELS;
use crate::native::table::Keys;
use crate::native::value::{Range as NumberRange, Read, Reader, Value, meant, number_in, whole_in};
use crate::quote::quoted;

/// Which picture is asked for; the command line wins.
#[derive(Debug, Default)]
pub struct Render {
    /// The settings.
    pub settings: SettingsOverrides,
    /// Where each of them stands, by its key.
    pub places: BTreeMap<&'static str, Place>,
}

/// Where a setting stands, in bytes.
#[derive(Clone, Debug)]
pub struct Place {
    pub key: Range<usize>,
    pub value: Range<usize>,
}

impl Render {
    /// What is wrong with settings that do not go together.
    pub fn faults(&self) -> Vec<Diagnostic> {
        let place = |key| self.places.get(key).map_or(0..0, |place| place.value.clone());
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
fn read(setting: &Setting, value: &Value<'_>, reader: &mut Reader<'_>) -> Option<SettingsOverrides> {
    let word = word(setting, value, reader)?;
    setting.parse(&word).map_or_else(
        |reason| {
            let fault = Diagnostic::new(value.span(), format!("this is no {}", setting.name));
            reader.wrong(fault.with_help(reason))
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
        Domain::Fraction => number_in(NumberRange::SHARE, value, key, reader).map(|it| it.to_string()),
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
    reader.wrong(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {spelling}")))
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
    reader.wrong(Diagnostic::new(value.span(), format!("{} is no `{key}`", quoted(&word))).with_help(help))
}

fn size(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Resolution> {
    let needs = "two integers, as in [640, 480]";
    let DeValue::Array(list) = value.get_ref() else {
        return reader.mismatch(value, key, needs);
    };
    let [width, height] = &list[..] else {
        let count = list.len();
        return reader.wrong(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {count}")));
    };
    let [width, height] = [width, height].map(|value| whole_in(1, Resolution::MAX_SIDE, value, key, reader));
    let (width, height) = (width?, height?);
    match Resolution::new(width, height) {
        Some(size) if u64::from(width) * u64::from(height) <= MOST_PIXELS => Some(size),
        _ => {
            let what = format!("{width} x {height} pixels are more than a file may ask for");
            let help = format!("up to {MOST_PIXELS} pixels, or use --size on the command line");
            reader.wrong(Diagnostic::new(value.span(), what).with_help(help))
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
