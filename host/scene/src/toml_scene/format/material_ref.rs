//! The material of an object: the name of a material, or an inline material.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use toml::de::DeValue;

use super::material::MaterialTable;
use crate::diagnostics::Diagnostic;
use crate::quote::quoted;
use crate::toml_scene::value::{FromToml, Spanned, TableReader, TomlValue, is_color_name, suggestion};

/// The material of an object.
#[derive(Debug)]
pub enum MaterialRef {
    /// The name of a material.
    Named(String),
    /// An inline material.
    Inline(Box<Spanned<MaterialTable>>),
}

impl FromToml for MaterialRef {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::String(name) if reader.material_names.span_of(name).is_some() => {
                Some(MaterialRef::Named(name.to_string()))
            }
            // It may be in a part that cannot be parsed.
            DeValue::String(_) if !reader.is_valid_toml => None,
            DeValue::String(name) => {
                let diagnostic = Diagnostic::new(value.span(), format!("unknown material {}", quoted(name)));
                let names = if reader.diagnostics.has_capacity() {
                    reader.material_names.for_suggestions()
                } else {
                    Vec::new()
                };
                let help = match suggestion(name, &names) {
                    Some(meant) => format!("did you mean {meant}?"),
                    None if is_color_name(name) => format!("write {{ color = {:?} }}", short(name)),
                    None => format!("define it as [[material]] with name = {:?}", short(name)),
                };
                reader.report(diagnostic.with_help(help))
            }
            DeValue::Table(_) => {
                let own: Spanned<MaterialTable> = Spanned::from_toml(value, key, reader)?;
                if let Some(name) = &own.value.name {
                    let diagnostic =
                        Diagnostic::new(name.span.clone(), "an inline material cannot have a name");
                    return reader
                        .report(diagnostic.with_help("write it as a [[material]] to use it by name"));
                }
                Some(MaterialRef::Inline(Box::new(own)))
            }
            _ => reader.report_type(value, key, "a material name or an inline table"),
        }
    }
}

fn short(name: &str) -> String {
    name.chars().take(40).collect()
}

impl JsonSchema for MaterialRef {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Surface".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let own = generator.subschema_for::<MaterialTable>();
        json_schema!({ "anyOf": [{ "type": "string" }, own] })
    }
}
