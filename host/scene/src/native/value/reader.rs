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
pub type Value<'t> = toml::Spanned<DeValue<'t>>;

/// What is found while the file is read.
pub struct Reader<'n> {
    /// Everything that is wrong.
    pub faults: Found,
    /// The names of the materials.
    pub names: &'n MaterialNames,
    /// Whether a key that is not there is a mistake. Not in a file that is no TOML, where the
    /// key may be in the part that cannot be read.
    pub complete: bool,
    /// Where tables begin that have a key which nobody knows: it may be meant for one that
    /// seems to be missing.
    pub puzzling: HashSet<usize>,
}

/// What is wrong: all of it is counted, and as much is kept as anybody reads.
#[derive(Default)]
pub struct Found {
    pub kept: Vec<Diagnostic>,
    pub count: usize,
}

impl Found {
    const MOST: usize = 1000;

    pub fn push(&mut self, fault: Diagnostic) {
        self.count += 1;
        if self.kept.len() < Self::MOST {
            self.kept.push(fault);
        }
    }

    /// Whether advice for one more would be read by somebody.
    pub fn has_room(&self) -> bool {
        self.kept.len() < Self::MOST
    }
}

impl Reader<'_> {
    /// Keeps a fault; none is what a reader answers then.
    pub fn wrong<T>(&mut self, fault: Diagnostic) -> Option<T> {
        self.faults.push(fault);
        None
    }

    /// Keeps a fault that is about something which a table does not have.
    pub fn misses<T>(&mut self, fault: Diagnostic) -> Option<T> {
        if self.complete && !self.puzzling.contains(&fault.span.start) {
            self.faults.push(fault);
        }
        None
    }

    /// The value is not of the kind that the key needs.
    pub fn mismatch<T>(&mut self, value: &Value<'_>, key: &str, needs: &str) -> Option<T> {
        let is = kind(value.get_ref());
        self.wrong(Diagnostic::new(value.span(), format!("`{key}` must be {needs}, not {is}")))
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
pub trait Read: Sized {
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
pub struct Spanned<T> {
    pub it: T,
    pub span: Range<usize>,
}

impl<T: Read> Read for Spanned<T> {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        T::read(value, key, reader).map(|it| Spanned { it, span: value.span() })
    }

    fn absent() -> Option<Self> {
        None
    }
}

schema_like!([T: JsonSchema] Spanned<T>, T);

impl Read for bool {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::Boolean(it) => Some(*it),
            _ => reader.mismatch(value, key, "true or false"),
        }
    }
}

impl Read for String {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::String(text) => Some(text.to_string()),
            _ => reader.mismatch(value, key, "a string"),
        }
    }
}
