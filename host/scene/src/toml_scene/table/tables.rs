//! Tables of the format.
//!
//! They are declared with the macro `tables`, which makes two things of one declaration: the struct with its JSON
//! Schema, and the reading of it.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use toml::de::DeValue;

use crate::diagnostics::Diagnostic;
use crate::toml_scene::value::{FromToml, Spanned, TableReader, TomlValue, schema_like};

schema_like!([T: JsonSchema] SingleTable<T>, T);
schema_like!([T: JsonSchema] TableArray<T>, Vec<T>);

/// A table that a file has at most once: `[camera]`.
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
            let fault = Diagnostic::new(value.span(), format!("there is only one `{key}`"));
            reader.diagnostics.push(fault.with_help(format!("write [{key}] instead of [[{key}]]")));
            return Self::default_if_absent();
        }
        Some(SingleTable(Spanned::from_toml(value, key, reader)))
    }

    fn default_if_absent() -> Option<Self> {
        Some(SingleTable(None))
    }
}

/// Tables of which a file may have any number: `[[sphere]]`.
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
                // All at once: a table that grows is there several times over for a while.
                let mut things = Vec::with_capacity(list.len());
                things.extend(list.iter().filter_map(|it| Spanned::from_toml(it, key, reader)));
                Some(TableArray(things))
            }
            DeValue::Table(_) => {
                let fault = Diagnostic::new(value.span(), format!("there may be more than one `{key}`"));
                reader.diagnostics.push(fault.with_help(format!("write [[{key}]] instead of [{key}]")));
                // What is wrong inside is told as well.
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

/// Declares tables of the format: the struct, its schema, and how it is read.
macro_rules! tables {
    ($(
        $(#[$about:meta])*
        struct $Name:ident as $schema_name:tt {
            $($(#[$doc:meta])* $key:ident: $Type:ty,)*
        }
    )*) => {$(
        #[derive(Debug, schemars::JsonSchema)]
        #[schemars(rename = $schema_name, deny_unknown_fields)]
        $(#[$about])*
        pub struct $Name {
            $($(#[$doc])* pub $key: $Type,)*
        }

        impl $crate::toml_scene::value::FromToml for $Name {
            fn from_toml(
                value: &$crate::toml_scene::value::TomlValue<'_>,
                name: &str,
                reader: &mut $crate::toml_scene::value::TableReader<'_>,
            ) -> Option<Self> {
                let keys = [$(stringify!($key).trim_start_matches("r#")),*];
                let table = $crate::toml_scene::table::KeyReader::of(value, name, &keys, reader)?;
                // Each of them before any of them is missed.
                $(let $key = table.get(stringify!($key).trim_start_matches("r#"), reader);)*
                Some($Name { $($key: $key?,)* })
            }
        }
    )*};
}
pub(in crate::toml_scene) use tables;
