//! Scenes in TOML: one array of tables for each kind of thing, materials by name.
//!
//! | room | what it does |
//! |---|---|
//! | `format` | the tables and their keys, as users and editors see them |
//! | `table` | tables of keys become values of types |
//! | `render` | the table of settings |
//! | `numbers`, `places`, `colors` | what keys can hold |
//! | `similar` | what somebody may have meant |
//! | `make` | what was read becomes a description, by way of: |
//! | `materials`, `forms`, `meshes`, `lights`, `view` | the parts of it |
//! | `turn` | turns in space |
//!
//! A file is read in two steps, and whatever is wrong in either of them is told at once: first
//! every key by itself, then what only several keys together can get wrong.

mod colors;
mod format;
mod forms;
mod lights;
mod make;
mod materials;
mod meshes;
mod numbers;
mod places;
mod render;
mod similar;
mod syntax;
mod table;
mod turn;
mod view;

use std::collections::HashSet;
use std::path::Path;

use strahl_core::Resolution;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::description::Description;
use crate::failure::Failure;
use crate::faults::{Fault, Faults, Lines};
use crate::load::Files;
use format::File;
use make::Maker;
use materials::Names;
use meshes::Meshes;
use table::{Found, Read, Reader};

/// Reads the bytes of the file at `path`.
///
/// Where it has no view, one is chosen that suits its size, or `size` where it names none.
pub(super) fn read(
    files: &Files,
    path: &Path,
    bytes: &[u8],
    size: Resolution,
) -> Result<Description, Failure> {
    let wrong = |text: &str, list: Vec<Fault>| Failure::Faults(Box::new(Faults::new(path, text, list)));
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => {
            let place = error.valid_up_to();
            let fault = Fault::new(place..place + 1, "this is no UTF-8, so it is no TOML");
            return Err(wrong(&String::from_utf8_lossy(bytes), vec![fault]));
        }
    };
    let (document, errors) = DeTable::parse_recoverable(text);
    if document.get_ref().is_empty() && errors.is_empty() {
        let fault = Fault::new(0..0, "the file has no scene in it");
        return Err(wrong(text, vec![fault.help("a scene begins with a table, such as [[sphere]]")]));
    }
    let names = Names::of(document.get_ref());
    let (faults, complete) = (Found::default(), errors.is_empty());
    let mut reader = Reader { faults, names: &names, complete, puzzling: HashSet::new() };
    let document = Spanned::new(document.span(), DeValue::Table(document.into_inner()));
    let file = File::read(&document, "", &mut reader);
    if !errors.is_empty() {
        return Err(wrong(text, syntax::faults(text, document.get_ref(), errors, reader.faults.kept)));
    }

    let lines = Lines::of(text);
    let folder = path.parent().unwrap_or(Path::new(""));
    let maker = Maker::new(reader, &lines, Meshes::of(files, folder), size);
    let (description, reader) = maker.scene(file.unwrap_or_default());
    let Found { kept, count } = reader.faults;
    if count == 0 {
        return Ok(description);
    }
    Err(Failure::Faults(Box::new(Faults::new(path, text, kept).counting(count))))
}

/// The JSON Schema of scenes, for editors.
pub fn schema() -> String {
    let schema = serde_json::to_string_pretty(&format::schema()).unwrap_or_default();
    schema + "\n"
}
