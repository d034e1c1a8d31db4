//! Values of the file become values of types, and whatever is wrong in them is collected.
//!
//! Serde would stop at the first mistake and lose the place of some. Here every value is read whatever is wrong with
//! the others.

use std::collections::HashSet;
use std::ops::Range;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use toml::de::DeValue;

use super::names::MaterialNames;
use super::schema_like::schema_like;
use crate::diagnostics::Diagnostic;

/// A value of the file, with its place.
pub type TomlValue<'t> = toml::Spanned<DeValue<'t>>;

/// What is found while the file is read.
pub struct TableReader<'n> {
    /// Everything that is wrong.
    pub diagnostics: DiagnosticList,
    /// The names of the materials.
    pub material_names: &'n MaterialNames,
    /// Whether a key that is not there is a mistake. Not in a file that is no TOML, where the
    /// key may be in the part that cannot be read.
    pub is_valid_toml: bool,
    /// Where tables begin that have a key which nobody knows: it may be meant for one that
    /// seems to be missing.
    pub tables_with_unknown_keys: HashSet<usize>,
}

/// What is wrong: all of it is counted, and as much is kept as anybody reads.
#[derive(Default)]
pub struct DiagnosticList {
    pub kept: Vec<Diagnostic>,
    pub total: usize,
}

impl DiagnosticList {
    const MAX_KEPT: usize = 1000;

    pub fn push(&mut self, fault: Diagnostic) {
        self.total += 1;
        if self.kept.len() < Self::MAX_KEPT {
            self.kept.push(fault);
        }
    }

    /// Whether advice for one more would be read by somebody.
    pub fn has_capacity(&self) -> bool {
        self.kept.len() < Self::MAX_KEPT
    }
}

impl TableReader<'_> {
    /// Keeps a fault; none is what a reader answers then.
    pub fn report<T>(&mut self, fault: Diagnostic) -> Option<T> {
        self.diagnostics.push(fault);
        None
    }

    /// Keeps a fault that is about something which a table does not have.
    pub fn report_missing<T>(&mut self, fault: Diagnostic) -> Option<T> {
        if self.is_valid_toml && !self.tables_with_unknown_keys.contains(&fault.span.start) {
            self.diagnostics.push(fault);
        }
        None
    }

    /// The value is not of the kind that the key needs.
    pub fn report_type<T>(&mut self, value: &TomlValue<'_>, key: &str, needs: &str) -> Option<T> {
        let is = type_name(value.get_ref());
        self.report(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {is}")))
    }
}

/// What kind of value it is, for messages.
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

/// What a key can hold.
pub trait FromToml: Sized {
    /// The value of a key, or none and what is wrong with it.
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self>;

    /// What it is when there is no such key; none when there must be one.
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

/// Something with its place in the file, in bytes. That of a table is its header.
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
