//! Tables of the format.
//!
//! They are declared with the macro `tables`, which makes two things of one declaration: the struct with its JSON
//! Schema, and the reading of it.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use toml::de::DeValue;

use crate::diagnostics::Diagnostic;
use crate::native::value::{Read, Reader, Spanned, Value, schema_like};

schema_like!([T: JsonSchema] One<T>, T);
schema_like!([T: JsonSchema] Many<T>, Vec<T>);

/// A table that a file has at most once: `[camera]`.
#[derive(Debug)]
pub struct One<T>(pub Option<Spanned<T>>);

impl<T> Default for One<T> {
    fn default() -> Self {
        One(None)
    }
}

impl<T: Read> Read for One<T> {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        if let DeValue::Array(_) = value.get_ref() {
            let fault = Diagnostic::new(value.span(), format!("there is only one `{key}`"));
            reader.faults.push(fault.with_help(format!("write [{key}] instead of [[{key}]]")));
            return Self::absent();
        }
        Some(One(Spanned::read(value, key, reader)))
    }

    fn absent() -> Option<Self> {
        Some(One(None))
    }
}

/// Tables of which a file may have any number: `[[sphere]]`.
#[derive(Debug)]
pub struct Many<T>(pub Vec<Spanned<T>>);

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
                things.extend(list.iter().filter_map(|it| Spanned::read(it, key, reader)));
                Some(Many(things))
            }
            DeValue::Table(_) => {
                let fault = Diagnostic::new(value.span(), format!("there may be more than one `{key}`"));
                reader.faults.push(fault.with_help(format!("write [[{key}]] instead of [{key}]")));
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
        pub struct $Name {
            $($(#[$doc])* pub $key: $Type,)*
        }

        impl $crate::native::value::Read for $Name {
            fn read(
                value: &$crate::native::value::Value<'_>,
                name: &str,
                reader: &mut $crate::native::value::Reader<'_>,
            ) -> Option<Self> {
                let keys = [$(stringify!($key).trim_start_matches("r#")),*];
                let table = $crate::native::table::Keys::of(value, name, &keys, reader)?;
                // Each of them before any of them is missed.
                $(let $key = table.get(stringify!($key).trim_start_matches("r#"), reader);)*
                Some($Name { $($key: $key?,)* })
            }
        }
    )*};
}
pub(in crate::native) use tables;
