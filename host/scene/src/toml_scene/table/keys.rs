//! Reading of the keys of a table.
//!
//! Every key is read, whatever errors the others have; unknown keys are errors. A key may have aliases, the names that other
//! programs use for it.

use std::ops::Range;

use schemars::Schema;
use toml::de::{DeTable, DeValue};

use crate::diagnostics::Diagnostic;
use crate::quote::quoted;
use crate::toml_scene::value::{FromToml, TableReader, TomlValue, key_suggestion};

/// The keys of a table, and its aliases: pairs of an alias and the key that it stands for.
#[derive(Clone, Copy)]
pub struct Keys<'k> {
    pub keys: &'k [&'k str],
    pub aliases: &'k [(&'k str, &'k str)],
}

impl Keys<'_> {
    fn contains(&self, word: &str) -> bool {
        self.keys.contains(&word) || self.aliases.iter().any(|(alias, _)| *alias == word)
    }
}

/// A table whose keys are being read.
pub struct KeyReader<'v, 't, 'k> {
    name: &'v str,
    table: &'v DeTable<'t>,
    span: Range<usize>,
    keys: Keys<'k>,
    /// Suggestions for unknown keys.
    suggestions: Vec<String>,
}

/// A key as it is written in the file, with its value.
pub struct Entry<'v, 't, 'k> {
    /// The key, or an alias of it.
    pub key: &'k str,
    /// The location of the key.
    pub span: Range<usize>,
    /// The value.
    pub value: &'v TomlValue<'t>,
}

impl<'v, 't, 'k> KeyReader<'v, 't, 'k> {
    /// The table `name`; unknown keys are reported, and keys that are given twice under different names.
    pub fn of(
        value: &'v TomlValue<'t>,
        name: &'v str,
        keys: Keys<'k>,
        reader: &mut TableReader<'_>,
    ) -> Option<Self> {
        let DeValue::Table(table) = value.get_ref() else {
            return reader.report_type(value, name, "a table");
        };
        let mut table = KeyReader { name, table, span: value.span(), keys, suggestions: Vec::new() };
        table.report_unknown_keys(reader);
        table.report_duplicates(reader);
        Some(table)
    }

    fn report_unknown_keys(&mut self, reader: &mut TableReader<'_>) {
        let Keys { keys, aliases } = self.keys;
        for (key, _) in self.table.iter().filter(|(key, _)| !self.keys.contains(key.get_ref().as_ref())) {
            let word = key.get_ref();
            let message = match self.name {
                "" => format!("unknown table {}", quoted(word)),
                name => format!("unknown key {} in `{name}`", quoted(word)),
            };
            let suggestion = match reader.diagnostics.has_capacity() {
                true => key_suggestion(self.name, word, keys, aliases),
                false => None,
            };
            let help = suggestion.clone().unwrap_or_else(|| format!("valid keys: {}", keys.join(", ")));
            reader.diagnostics.push(Diagnostic::new(key.span(), message).with_help(help));
            reader.tables_with_unknown_keys.insert(self.span.start);
            self.suggestions.extend(suggestion);
        }
    }

    fn report_duplicates(&self, reader: &mut TableReader<'_>) {
        let mut reported = Vec::new();
        for (_, key) in self.keys.aliases {
            let mut entries: Vec<_> = self.entries(key).collect();
            entries.sort_by_key(|entry| entry.span.start);
            if let [first, others @ ..] = &entries[..]
                && !reported.contains(key)
            {
                for other in others {
                    let message = format!("`{}` and `{}` are the same key", other.key, first.key);
                    let diagnostic = Diagnostic::new(other.span.clone(), message);
                    reader.diagnostics.push(diagnostic.with_related(first.span.clone(), "the other one"));
                }
                reported.push(key);
            }
        }
    }

    /// All entries of a key and its aliases.
    fn entries(&self, key: &'k str) -> impl Iterator<Item = Entry<'v, 't, 'k>> {
        let aliases =
            self.keys.aliases.iter().filter(move |(_, other)| *other == key).map(|(alias, _)| *alias);
        let table = self.table;
        std::iter::once(key).chain(aliases).filter_map(move |key| {
            let (name, value) = table.get_key_value(key)?;
            Some(Entry { key, span: name.span(), value })
        })
    }

    /// A key, under its own name or an alias; `None` if the table does not have it.
    pub fn entry(&self, key: &'k str) -> Option<Entry<'v, 't, 'k>> {
        self.entries(key).next()
    }

    /// Reads the value of a key; a missing key without a default is reported.
    pub fn get<T: FromToml>(&self, key: &'k str, reader: &mut TableReader<'_>) -> Option<T> {
        if let Some(entry) = self.entry(key) {
            return T::from_toml(entry.value, entry.key, reader);
        }
        let absent = T::default_if_absent();
        let is_meant = self.suggestions.iter().any(|suggestion| suggestion.contains(&format!("`{key}`")));
        if absent.is_none() && reader.is_valid_toml && !is_meant {
            let diagnostic =
                Diagnostic::new(self.span.clone(), format!("`{}` needs the key `{key}`", self.name));
            reader.diagnostics.push(diagnostic.with_help(format!("`{key}` has no default")));
        }
        absent
    }
}

/// Adds aliases to the properties of the JSON Schema of a table.
pub fn add_aliases(aliases: &[(&str, &str)], schema: &mut Schema) {
    let Some(properties) = schema.get_mut("properties").and_then(|it| it.as_object_mut()) else { return };
    for (alias, key) in aliases {
        let mut property = properties.get(*key).cloned().unwrap_or_default();
        property["description"] = format!("Alias of `{key}`.").into();
        properties.insert((*alias).into(), property);
    }
}
