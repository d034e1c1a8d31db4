//! Choices of the file: words and numbers of which there are only a few.

use clap::ValueEnum;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use toml::de::DeValue;

use super::similar::meant;
use super::table::{Read, Reader, Value};
use crate::faults::Fault;
use crate::finding::{HEAPS, MAILBOXES};
use crate::load::shown::shown;

/// One of the words that an option of the command line has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<T>(pub(super) T);

fn words<T: ValueEnum>() -> Vec<String> {
    T::value_variants().iter().filter_map(T::to_possible_value).map(|it| it.get_name().to_owned()).collect()
}

impl<T: ValueEnum> Read for Word<T> {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        let word = String::read(value, key, reader)?;
        if let Ok(it) = T::from_str(&word, false) {
            return Some(Word(it));
        }
        let words = words::<T>();
        let words: Vec<_> = words.iter().map(String::as_str).collect();
        let help = match meant(&word, &words) {
            Some(meant) => format!("did you mean {meant}?"),
            None => format!("there are {}", words.join(", ")),
        };
        reader.wrong(Fault::new(value.span(), format!("{} is no `{key}`", shown(&word))).help(help))
    }
}

impl<T: ValueEnum> JsonSchema for Word<T> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Word".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "enum": words::<T>() })
    }
}

/// Declares types for whole numbers of which there are only a few.
macro_rules! sizes {
    ($($(#[$doc:meta])* $Name:ident: $sizes:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub(super) struct $Name(pub(super) usize);

        impl Read for $Name {
            fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
                size_of(&$sizes, value, key, reader).map($Name)
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
                json_schema!({ "enum": $sizes })
            }
        }
    )*};
}

sizes! {
    /// The places of a heap.
    Heap: HEAPS;
    /// The slots of a mailbox.
    Mailbox: MAILBOXES;
}

fn size_of(sizes: &[usize], value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<usize> {
    let names: Vec<_> = sizes.iter().map(usize::to_string).collect();
    let needs = format!("one of {}", names.join(", "));
    let DeValue::Integer(whole) = value.get_ref() else {
        return reader.mismatch(value, key, &needs);
    };
    let number = usize::from_str_radix(whole.as_str(), whole.radix()).ok();
    if let Some(size) = number.filter(|number| sizes.contains(number)) {
        return Some(size);
    }
    let spelling: String = whole.to_string().chars().take(40).collect();
    reader.wrong(Fault::new(value.span(), format!("`{key}` must be {needs}, not {spelling}")))
}
