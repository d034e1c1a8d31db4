//! What an object is made of: a material with a name, or one that stands in the object.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use toml::de::DeValue;

use super::material::MaterialTable;
use crate::diagnostics::Diagnostic;
use crate::quote::quoted;
use crate::toml_scene::value::{FromToml, Spanned, TableReader, TomlValue, is_color_name, suggestion};

/// What an object is made of.
#[derive(Debug)]
pub enum MaterialRef {
    /// A material of the file.
    Named(String),
    /// One that only this object has.
    Inline(Box<Spanned<MaterialTable>>),
}

impl FromToml for MaterialRef {
    fn from_toml(value: &TomlValue<'_>, key: &str, reader: &mut TableReader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::String(name) if reader.material_names.span_of(name).is_some() => {
                Some(MaterialRef::Named(name.to_string()))
            }
            // It may be in the part that cannot be read.
            DeValue::String(_) if !reader.is_valid_toml => None,
            DeValue::String(name) => {
                let fault = Diagnostic::new(value.span(), format!("there is no material {}", quoted(name)));
                let names = if reader.diagnostics.has_capacity() {
                    reader.material_names.for_suggestions()
                } else {
                    Vec::new()
                };
                let help = match suggestion(name, &names) {
                    Some(meant) => format!("did you mean {meant}?"),
                    None if is_color_name(name) => format!("write {{ color = {:?} }}", short(name)),
                    None => format!("write [[material]] and name = {:?} below it", short(name)),
                };
                reader.report(fault.with_help(help))
            }
            DeValue::Table(_) => {
                let own: Spanned<MaterialTable> = Spanned::from_toml(value, key, reader)?;
                if let Some(name) = &own.value.name {
                    let fault =
                        Diagnostic::new(name.span.clone(), "a material that stands in an object has no name");
                    return reader.report(fault.with_help("write it as a [[material]] to use it by name"));
                }
                Some(MaterialRef::Inline(Box::new(own)))
            }
            _ => reader.report_type(value, key, "the name of a material or a table of its own"),
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
