//! The keys of a table.
//!
//! Every key is read whatever is wrong with the others, and what no type has a key for is a mistake of its own.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::diagnostics::Diagnostic;
use crate::quote::quoted;
use crate::toml_scene::value::{FromToml, TableReader, TomlValue, suggestion};

/// A table while its keys are read.
pub struct KeyReader<'v, 't> {
    name: &'v str,
    table: &'v DeTable<'t>,
    span: Range<usize>,
    /// What unknown keys seem to mean.
    suggested_keys: Vec<String>,
}

impl<'v, 't> KeyReader<'v, 't> {
    /// The table that is the value of `name`, none of whose keys is outside `keys`.
    pub fn of(
        value: &'v TomlValue<'t>,
        name: &'v str,
        keys: &[&str],
        reader: &mut TableReader<'_>,
    ) -> Option<Self> {
        let DeValue::Table(table) = value.get_ref() else {
            return reader.report_type(value, name, "a table");
        };
        let mut guesses = Vec::new();
        for (key, _) in table.iter().filter(|(key, _)| !keys.contains(&key.get_ref().as_ref())) {
            let word = key.get_ref();
            let what = match name {
                "" => format!("a scene has no table {}", quoted(word)),
                _ => format!("`{name}` has no key {}", quoted(word)),
            };
            let guess = if reader.diagnostics.has_capacity() { suggestion(word, keys) } else { None };
            let help = match &guess {
                Some(guess) => format!("did you mean {guess}?"),
                None => format!("there are {}", keys.join(", ")),
            };
            reader.diagnostics.push(Diagnostic::new(key.span(), what).with_help(help));
            reader.tables_with_unknown_keys.insert(value.span().start);
            guesses.extend(guess);
        }
        Some(KeyReader { name, table, span: value.span(), suggested_keys: guesses })
    }

    /// A key with its value, where the table has it.
    pub fn entry(&self, key: &str) -> Option<(Range<usize>, &'v TomlValue<'t>)> {
        self.table.get_key_value(key).map(|(key, value)| (key.span(), value))
    }

    /// The value of a key.
    pub fn get<T: FromToml>(&self, key: &str, reader: &mut TableReader<'_>) -> Option<T> {
        if let Some(value) = self.table.get(key) {
            return T::from_toml(value, key, reader);
        }
        let absent = T::default_if_absent();
        let is_meant = self.suggested_keys.iter().any(|guess| guess.contains(&format!("`{key}`")));
        if absent.is_none() && reader.is_valid_toml && !is_meant {
            let fault = Diagnostic::new(self.span.clone(), format!("this `{}` has no `{key}`", self.name));
            reader.diagnostics.push(fault.with_help(format!("`{key}` has no default: give it a value")));
        }
        absent
    }
}
