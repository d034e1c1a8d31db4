//! Declaration of tables.
//!
//! The macro `tables` declares a struct, its JSON Schema and its reading at once.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use toml::de::DeValue;

use crate::diagnostics::Diagnostic;
use crate::toml_scene::value::{FromToml, Spanned, TableReader, TomlValue, schema_like};

schema_like!([T: JsonSchema] SingleTable<T>, T);
schema_like!([T: JsonSchema] TableArray<T>, Vec<T>);

/// A table that a file can have once: `[camera]`.
#[derive(Debug)]
pub struct SingleTable<T>(pub Option<Spanned<T>>);

impl<T> Default for SingleTable<T> {
    fn default() -> Self {
        SingleTable(None)
    }
}

impl<T: FromToml> FromToml for SingleTable<T> {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        if let DeValue::Array(_) = value.get_ref() {
            let diagnostic = Diagnostic::new(value.span(), format!("`{key}` may appear only once"));
            reader.diagnostics.push(diagnostic.with_help(format!("write [{key}] instead of [[{key}]]")));
            return Self::default_if_absent();
        }
        Some(SingleTable(Spanned::from_toml(value, key, reader)))
    }

    fn default_if_absent() -> Option<Self> {
        Some(SingleTable(None))
    }
}

/// An array of tables: `[[sphere]]`.
#[derive(Debug)]
pub struct TableArray<T>(pub Vec<Spanned<T>>);

impl<T> Default for TableArray<T> {
    fn default() -> Self {
        TableArray(Vec::new())
    }
}

impl<T: FromToml> FromToml for TableArray<T> {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::Array(list) => {
                // Allocated at once: growing would temporarily take a multiple of the memory.
                let mut things = Vec::with_capacity(list.len());
                things.extend(list.iter().filter_map(|it| Spanned::from_toml(it, key, reader)));
                Some(TableArray(things))
            }
            DeValue::Table(_) => {
                let diagnostic = Diagnostic::new(value.span(), format!("`{key}` is an array of tables"));
                reader.diagnostics.push(diagnostic.with_help(format!("write [[{key}]] instead of [{key}]")));
                // Report errors inside the table as well.
                T::from_toml(value, key, reader);
                Self::default_if_absent()
            }
            _ => reader.report_type(value, key, &format!("a table that begins with [[{key}]]")),
        }
    }

    fn default_if_absent() -> Option<Self> {
        Some(TableArray(Vec::new()))
    }
}

/// Declares tables: struct, JSON Schema and reading. A key may be followed by its aliases: `from | eye: Type`.
macro_rules! tables {
    ($(
        $(#[$about:meta])*
        struct $Name:ident as $schema_name:tt {
            $($(#[$doc:meta])* $key:ident $(| $alias:ident)*: $Type:ty,)*
        }
    )*) => {$(
        #[derive(Debug, schemars::JsonSchema)]
        #[schemars(rename = $schema_name, deny_unknown_fields, transform = Self::add_aliases)]
        $(#[$about])*
        pub struct $Name {
            $($(#[$doc])* pub $key: $Type,)*
        }

        impl $Name {
            const ALIASES: &[(&str, &str)] = &[$($((stringify!($alias), stringify!($key)),)*)*];

            fn add_aliases(schema: &mut schemars::Schema) {
                $crate::toml_scene::table::add_aliases(Self::ALIASES, schema);
            }
        }

        impl $crate::toml_scene::value::FromToml for $Name {
            fn from_toml(
                value: &$crate::toml_scene::value::TomlValue<'_>,
                name: &str,
                reader: &mut $crate::toml_scene::value::TableReader<'_>,
            ) -> Option<Self> {
                let keys = $crate::toml_scene::table::Keys {
                    keys: &[$(stringify!($key).trim_start_matches("r#")),*],
                    aliases: Self::ALIASES,
                };
                let table = $crate::toml_scene::table::KeyReader::of(value, name, keys, reader)?;
                // Read all keys before a missing one ends the function.
                $(let $key = table.get(stringify!($key).trim_start_matches("r#"), reader);)*
                Some($Name { $($key: $key?,)* })
            }
        }
    )*};
}
pub(in crate::toml_scene) use tables;
