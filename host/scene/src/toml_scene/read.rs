//! A file in TOML becomes a description.

use std::collections::HashSet;
use std::path::Path;

use strahl_core::Resolution;
use toml::de::{DeTable, DeValue};

use super::build::{MeshFiles, SceneBuilder};
use super::format::SceneFile;
use super::syntax;
use super::value::{DiagnosticList, FromToml as _, MaterialNames, TableReader};
use crate::description::LoadedScene;
use crate::diagnostics::{Diagnostic, Diagnostics, LineIndex};
use crate::error::LoadError;
use crate::source_files::SourceFiles;

/// Reads the bytes of the file at `path`.
///
/// Where it has no view, one is chosen that suits its size, or `size` where it names none.
pub fn read(
    files: &SourceFiles,
    path: &Path,
    bytes: &[u8],
    size: Resolution,
) -> Result<LoadedScene, LoadError> {
    let wrong = |text: &str, list: Vec<Diagnostic>| {
        LoadError::Diagnostics(Box::new(Diagnostics::new(path, text, list)))
    };
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => {
            let place = error.valid_up_to();
            let fault = Diagnostic::new(place..place + 1, "this is no UTF-8, so it is no TOML");
            return Err(wrong(&String::from_utf8_lossy(bytes), vec![fault]));
        }
    };
    let (document, errors) = DeTable::parse_recoverable(text);
    if document.get_ref().is_empty() && errors.is_empty() {
        let fault = Diagnostic::new(0..0, "the file has no scene in it");
        return Err(wrong(text, vec![fault.with_help("a scene begins with a table, such as [[sphere]]")]));
    }
    let names = MaterialNames::of(document.get_ref());
    let (faults, complete) = (DiagnosticList::default(), errors.is_empty());
    let mut reader = TableReader {
        diagnostics: faults,
        material_names: &names,
        is_valid_toml: complete,
        tables_with_unknown_keys: HashSet::new(),
    };
    let document = toml::Spanned::new(document.span(), DeValue::Table(document.into_inner()));
    let file = SceneFile::from_toml(&document, "", &mut reader);
    if !errors.is_empty() {
        return Err(wrong(
            text,
            syntax::diagnostics(text, document.get_ref(), errors, reader.diagnostics.kept),
        ));
    }

    let lines = LineIndex::new(text);
    let folder = path.parent().unwrap_or(Path::new(""));
    let builder = SceneBuilder::new(reader, &lines, MeshFiles::of(files, folder), size);
    let (description, reader) = builder.build(file.unwrap_or_default());
    let DiagnosticList { kept, total: count } = reader.diagnostics;
    if count == 0 {
        return Ok(description);
    }
    Err(LoadError::Diagnostics(Box::new(Diagnostics::new(path, text, kept).with_total(count))))
}

/// The JSON Schema of scenes, for editors.
pub fn schema() -> String {
    let schema = serde_json::to_string_pretty(&schemars::schema_for!(SceneFile)).unwrap_or_default();
    schema + "\n"
}
