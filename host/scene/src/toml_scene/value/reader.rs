//! Reading of typed values, with a list of all errors.
//!
//! Serde is not used: it would stop at the first error, and lose the location of some. Here every value is read, whatever
//! errors the others have.

use std::collections::HashSet;
use std::ops::Range;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use toml::de::DeValue;

use super::names::MaterialNames;
use super::schema_like::schema_like;
use crate::diagnostics::Diagnostic;

/// A value of the file, with its location.
pub type TomlValue<'t> = toml::Spanned<DeValue<'t>>;

/// The state of reading a file.
pub struct TableReader<'n> {
    /// The errors.
    pub diagnostics: DiagnosticList,
    /// The names of the materials.
    pub material_names: &'n MaterialNames,
    /// Whether the file is valid TOML. Otherwise a missing key is not an error: it may be in a part that cannot be parsed.
    pub is_valid_toml: bool,
    /// The start of each table with an unknown key, which may be a misspelled required key.
    pub tables_with_unknown_keys: HashSet<usize>,
}

/// A list of errors: all are counted, the first 1000 are stored.
#[derive(Default)]
pub struct DiagnosticList {
    pub list: Vec<Diagnostic>,
    pub total: usize,
}

impl DiagnosticList {
    const MAX_STORED: usize = 1000;

    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.total += 1;
        if self.list.len() < Self::MAX_STORED {
            self.list.push(diagnostic);
        }
    }

    /// Whether one more error would be stored, and is worth advice.
    pub fn has_capacity(&self) -> bool {
        self.list.len() < Self::MAX_STORED
    }
}

impl TableReader<'_> {
    /// Reports an error and returns `None`.
    pub fn report<T>(&mut self, diagnostic: Diagnostic) -> Option<T> {
        self.diagnostics.push(diagnostic);
        None
    }

    /// Reports that a table lacks a key, unless the key may be misspelled or in a part that cannot be parsed.
    pub fn report_missing<T>(&mut self, diagnostic: Diagnostic) -> Option<T> {
        if self.is_valid_toml && !self.tables_with_unknown_keys.contains(&diagnostic.span.start) {
            self.diagnostics.push(diagnostic);
        }
        None
    }

    /// Reports that the value has not the required type; `needs` describes it.
    pub fn report_type<T>(&mut self, value: &TomlValue<'_>, key: &str, needs: &str) -> Option<T> {
        let is = type_name(value.get_ref());
        self.report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {is}")))
    }
}

/// The type of a value, for messages.
fn type_name(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(_) => "an array",
        DeValue::Table(_) => "a table",
    }
}

/// A type that can be read from a TOML value.
pub trait FromToml: Sized {
    /// Reads the value of a key; `None` after an error, which is reported.
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self>;

    /// The value if the key is missing; `None` if the key is required.
    fn default_if_absent() -> Option<Self> {
        None
    }
}

impl<T: FromToml> FromToml for Option<T> {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        T::from_toml(value, key, reader).map(Some)
    }

    fn default_if_absent() -> Option<Self> {
        Some(None)
    }
}

/// A value with its location in the file, in bytes; that of a table is its header.
#[derive(Clone, Debug)]
pub struct Spanned<T> {
    pub value: T,
    pub span: Range<usize>,
}

impl<T: FromToml> FromToml for Spanned<T> {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        T::from_toml(value, key, reader).map(|it| Spanned { value: it, span: value.span() })
    }

    fn default_if_absent() -> Option<Self> {
        None
    }
}

schema_like!([T: JsonSchema] Spanned<T>, T);

impl FromToml for bool {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::Boolean(it) => Some(*it),
            _ => reader.report_type(value, key, "true or false"),
        }
    }
}

impl FromToml for String {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::String(text) => Some(text.to_string()),
            _ => reader.report_type(value, key, "a string"),
        }
    }
}
