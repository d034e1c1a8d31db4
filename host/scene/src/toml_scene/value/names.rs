//! Names of materials.
//!
//! They are collected before objects are read, so that an object can refer to a material that is defined later, or that
//! has errors.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

/// The names of materials, with the location of the first definition of each.
pub struct MaterialNames(BTreeMap<String, Range<usize>>);

impl MaterialNames {
    /// The names of all materials in a document.
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

    /// The location of the first definition of a name; `None` if it does not exist.
    pub fn span_of(&self, name: &str) -> Option<&Range<usize>> {
        self.0.get(name)
    }

    /// The names that are searched for suggestions: the first 1000.
    pub fn for_suggestions(&self) -> Vec<&str> {
        self.0.keys().map(String::as_str).take(1000).collect()
    }
}
