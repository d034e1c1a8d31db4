//! Tables of keys become values of types, and whatever is wrong in them is collected.
//!
//! Serde would stop at the first mistake and lose the place of some, so the tables of the format
//! are declared with the macro `tables`, which makes two things of one declaration: the struct
//! with its JSON Schema, and the reading of it. Every key of a table is read whatever is wrong
//! with the others, and what no type has a key for is a mistake of its own.

use std::collections::HashSet;
use std::ops::Range;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::materials::Names;
use super::similar::meant;
use crate::faults::Fault;
use crate::load::shown::shown;

/// A value of the file, with its place.
pub(super) type Value<'t> = Spanned<DeValue<'t>>;

/// What is found while the file is read.
pub(super) struct Reader<'n> {
    /// Everything that is wrong.
    pub(super) faults: Found,
    /// The names of the materials.
    pub(super) names: &'n Names,
    /// Whether a key that is not there is a mistake. Not in a file that is no TOML, where the
    /// key may be in the part that cannot be read.
    pub(super) complete: bool,
    /// Where tables begin that have a key which nobody knows: it may be meant for one that
    /// seems to be missing.
    pub(super) puzzling: HashSet<usize>,
}

/// What is wrong: all of it is counted, and as much is kept as anybody reads.
#[derive(Default)]
pub(super) struct Found {
    pub(super) kept: Vec<Fault>,
    pub(super) count: usize,
}

impl Found {
    const MOST: usize = 1000;

    pub(super) fn push(&mut self, fault: Fault) {
        self.count += 1;
        if self.kept.len() < Self::MOST {
            self.kept.push(fault);
        }
    }

    /// Whether advice for one more would be read by somebody.
    pub(super) fn has_room(&self) -> bool {
        self.kept.len() < Self::MOST
    }
}

impl Reader<'_> {
    /// Keeps a fault; none is what a reader answers then.
    pub(super) fn wrong<T>(&mut self, fault: Fault) -> Option<T> {
        self.faults.push(fault);
        None
    }

    /// Keeps a fault that is about something which a table does not have.
    pub(super) fn misses<T>(&mut self, fault: Fault) -> Option<T> {
        if self.complete && !self.puzzling.contains(&fault.span.start) {
            self.faults.push(fault);
        }
        None
    }

    /// The value is not of the kind that the key needs.
    pub(super) fn mismatch<T>(&mut self, value: &Value<'_>, key: &str, needs: &str) -> Option<T> {
        let is = kind(value.get_ref());
        self.wrong(Fault::new(value.span(), format!("`{key}` must be {needs}, not {is}")))
    }
}

/// What kind of value it is, for messages.
fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(_) => "an array",
        DeValue::Table(_) => "a table",
    }
}

/// What a key can hold.
pub(super) trait Read: Sized {
    /// The value of a key, or none and what is wrong with it.
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self>;

    /// What it is when there is no such key; none when there must be one.
    fn absent() -> Option<Self> {
        None
    }
}

impl<T: Read> Read for Option<T> {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        T::read(value, key, reader).map(Some)
    }

    fn absent() -> Option<Self> {
        Some(None)
    }
}

/// Something with its place in the file, in bytes. That of a table is its header.
#[derive(Clone, Debug)]
pub(super) struct At<T> {
    pub(super) it: T,
    pub(super) span: Range<usize>,
}

impl<T: Read> Read for At<T> {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        T::read(value, key, reader).map(|it| At { it, span: value.span() })
    }

    fn absent() -> Option<Self> {
        None
    }
}

/// The schema of one type is that of another.
macro_rules! schema_like {
    ([$($generic:tt)*] $Type:ty, $Other:ty) => {
        impl<$($generic)*> JsonSchema for $Type {
            fn inline_schema() -> bool {
                <$Other>::inline_schema()
            }
            fn schema_name() -> std::borrow::Cow<'static, str> {
                <$Other>::schema_name()
            }
            fn schema_id() -> std::borrow::Cow<'static, str> {
                <$Other>::schema_id()
            }
            fn json_schema(generator: &mut SchemaGenerator) -> Schema {
                <$Other>::json_schema(generator)
            }
        }
    };
}
schema_like!([T: JsonSchema] At<T>, T);
schema_like!([T: JsonSchema] One<T>, T);
schema_like!([T: JsonSchema] Many<T>, Vec<T>);

/// A table that a file has at most once: `[camera]`.
#[derive(Debug)]
pub(super) struct One<T>(pub(super) Option<At<T>>);

impl<T> Default for One<T> {
    fn default() -> Self {
        One(None)
    }
}

impl<T: Read> Read for One<T> {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        if let DeValue::Array(_) = value.get_ref() {
            let fault = Fault::new(value.span(), format!("there is only one `{key}`"));
            reader.faults.push(fault.help(format!("write [{key}] instead of [[{key}]]")));
            return Self::absent();
        }
        Some(One(At::read(value, key, reader)))
    }

    fn absent() -> Option<Self> {
        Some(One(None))
    }
}

/// Tables of which a file may have any number: `[[sphere]]`.
#[derive(Debug)]
pub(super) struct Many<T>(pub(super) Vec<At<T>>);

impl<T> Default for Many<T> {
    fn default() -> Self {
        Many(Vec::new())
    }
}

impl<T: Read> Read for Many<T> {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::Array(list) => {
                // All at once: a table that grows is there several times over for a while.
                let mut things = Vec::with_capacity(list.len());
                things.extend(list.iter().filter_map(|it| At::read(it, key, reader)));
                Some(Many(things))
            }
            DeValue::Table(_) => {
                let fault = Fault::new(value.span(), format!("there may be more than one `{key}`"));
                reader.faults.push(fault.help(format!("write [[{key}]] instead of [{key}]")));
                // What is wrong inside is told as well.
                T::read(value, key, reader);
                Self::absent()
            }
            _ => reader.mismatch(value, key, &format!("a table that begins with [[{key}]]")),
        }
    }

    fn absent() -> Option<Self> {
        Some(Many(Vec::new()))
    }
}

/// A table while its keys are read.
pub(super) struct Keys<'v, 't> {
    name: &'v str,
    table: &'v DeTable<'t>,
    span: Range<usize>,
    /// What unknown keys seem to mean.
    meant: Vec<String>,
}

impl<'v, 't> Keys<'v, 't> {
    /// The table that is the value of `name`, none of whose keys is outside `keys`.
    pub(super) fn of(
        value: &'v Value<'t>,
        name: &'v str,
        keys: &[&str],
        reader: &mut Reader<'_>,
    ) -> Option<Self> {
        let DeValue::Table(table) = value.get_ref() else {
            return reader.mismatch(value, name, "a table");
        };
        let mut guesses = Vec::new();
        for (key, _) in table.iter().filter(|(key, _)| !keys.contains(&key.get_ref().as_ref())) {
            let word = key.get_ref();
            let what = match name {
                "" => format!("a scene has no table {}", shown(word)),
                _ => format!("`{name}` has no key {}", shown(word)),
            };
            let guess = if reader.faults.has_room() { meant(word, keys) } else { None };
            let help = match &guess {
                Some(guess) => format!("did you mean {guess}?"),
                None => format!("there are {}", keys.join(", ")),
            };
            reader.faults.push(Fault::new(key.span(), what).help(help));
            reader.puzzling.insert(value.span().start);
            guesses.extend(guess);
        }
        Some(Keys { name, table, span: value.span(), meant: guesses })
    }

    /// A key with its value, where the table has it.
    pub(super) fn entry(&self, key: &str) -> Option<(Range<usize>, &'v Value<'t>)> {
        self.table.get_key_value(key).map(|(key, value)| (key.span(), value))
    }

    /// The value of a key.
    pub(super) fn get<T: Read>(&self, key: &str, reader: &mut Reader<'_>) -> Option<T> {
        if let Some(value) = self.table.get(key) {
            return T::read(value, key, reader);
        }
        let absent = T::absent();
        let is_meant = self.meant.iter().any(|guess| guess.contains(&format!("`{key}`")));
        if absent.is_none() && reader.complete && !is_meant {
            let fault = Fault::new(self.span.clone(), format!("this `{}` has no `{key}`", self.name));
            reader.faults.push(fault.help(format!("`{key}` has no default: give it a value")));
        }
        absent
    }
}

/// Declares tables of the format: the struct, its schema, and how it is read.
macro_rules! tables {
    ($(
        $(#[$about:meta])*
        struct $Name:ident {
            $($(#[$doc:meta])* $key:ident: $Type:ty,)*
        }
    )*) => {$(
        #[derive(Debug, schemars::JsonSchema)]
        #[schemars(deny_unknown_fields)]
        $(#[$about])*
        pub(super) struct $Name {
            $($(#[$doc])* pub(super) $key: $Type,)*
        }

        impl $crate::load::native::table::Read for $Name {
            fn read(
                value: &$crate::load::native::table::Value<'_>,
                name: &str,
                reader: &mut $crate::load::native::table::Reader<'_>,
            ) -> Option<Self> {
                let keys = [$(stringify!($key).trim_start_matches("r#")),*];
                let table = $crate::load::native::table::Keys::of(value, name, &keys, reader)?;
                // Each of them before any of them is missed.
                $(let $key = table.get(stringify!($key).trim_start_matches("r#"), reader);)*
                Some($Name { $($key: $key?,)* })
            }
        }
    )*};
}
pub(super) use tables;
