//! The names of materials.
//!
//! They are collected before anything is read, so that a name is known wherever its material stands, and whatever
//! else is wrong with that material.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

/// The names of materials, and where in the file each of them is said first.
pub struct MaterialNames(BTreeMap<String, Range<usize>>);

impl MaterialNames {
    /// The names in a document.
    pub fn of(document: &DeTable<'_>) -> Self {
        let materials = document.get("material").and_then(|value| match value.get_ref() {
            DeValue::Array(list) => Some(list),
            _ => None,
        });
        let mut names = BTreeMap::new();
        for material in materials.into_iter().flatten() {
            if let DeValue::Table(table) = material.get_ref()
                && let Some(value) = table.get("name")
                && let DeValue::String(name) = value.get_ref()
            {
                names.entry(name.to_string()).or_insert(value.span());
            }
        }
        MaterialNames(names)
    }

    /// Where one of them is said first.
    pub fn span_of(&self, name: &str) -> Option<&Range<usize>> {
        self.0.get(name)
    }

    /// As many of them as advice is looked for among.
    pub fn for_suggestions(&self) -> Vec<&str> {
        self.0.keys().map(String::as_str).take(1000).collect()
    }
}
