//! What an object is made of: a material with a name, or one that stands in the object.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use toml::de::DeValue;

use super::material::Material;
use crate::diagnostics::Diagnostic;
use crate::native::value::{Read, Reader, Spanned, Value, is_color, meant};
use crate::quote::quoted;

/// What an object is made of.
#[derive(Debug)]
pub enum Surface {
    /// A material of the file.
    Named(String),
    /// One that only this object has.
    Own(Box<Spanned<Material>>),
}

impl Read for Surface {
    fn read(value: &Value<'_>, key: &str, reader: &mut Reader<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::String(name) if reader.names.first(name).is_some() => {
                Some(Surface::Named(name.to_string()))
            }
            // It may be in the part that cannot be read.
            DeValue::String(_) if !reader.complete => None,
            DeValue::String(name) => {
                let fault = Diagnostic::new(value.span(), format!("there is no material {}", quoted(name)));
                let names = if reader.faults.has_room() { reader.names.some() } else { Vec::new() };
                let help = match meant(name, &names) {
                    Some(meant) => format!("did you mean {meant}?"),
                    None if is_color(name) => format!("write {{ color = {:?} }}", short(name)),
                    None => format!("write [[material]] and name = {:?} below it", short(name)),
                };
                reader.wrong(fault.with_help(help))
            }
            DeValue::Table(_) => {
                let own: Spanned<Material> = Spanned::read(value, key, reader)?;
                if let Some(name) = &own.it.name {
                    let fault =
                        Diagnostic::new(name.span.clone(), "a material that stands in an object has no name");
                    return reader.wrong(fault.with_help("write it as a [[material]] to use it by name"));
                }
                Some(Surface::Own(Box::new(own)))
            }
            _ => reader.mismatch(value, key, "the name of a material or a table of its own"),
        }
    }
}

fn short(name: &str) -> String {
    name.chars().take(40).collect()
}

impl JsonSchema for Surface {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Surface".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let own = generator.subschema_for::<Material>();
        json_schema!({ "anyOf": [{ "type": "string" }, own] })
    }
}
