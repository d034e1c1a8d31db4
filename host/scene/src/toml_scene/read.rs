//! Reads a scene in TOML.

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
/// If it has no camera, one is chosen for the resolution in the file, or for `size` if the file has none.
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
            let diagnostic = Diagnostic::new(place..place + 1, "not UTF-8, so not TOML");
            return Err(wrong(&String::from_utf8_lossy(bytes), vec![diagnostic]));
        }
    };
    let (document, errors) = DeTable::parse_recoverable(text);
    if document.get_ref().is_empty() && errors.is_empty() {
        let diagnostic = Diagnostic::new(0..0, "the file is empty");
        return Err(wrong(
            text,
            vec![diagnostic.with_help("a scene begins with a table, such as [[sphere]]")],
        ));
    }
    let names = MaterialNames::of(document.get_ref());
    let (diagnostics, complete) = (DiagnosticList::default(), errors.is_empty());
    let mut reader = TableReader {
        diagnostics,
        material_names: &names,
        is_valid_toml: complete,
        tables_with_unknown_keys: HashSet::new(),
    };
    let document = toml::Spanned::new(document.span(), DeValue::Table(document.into_inner()));
    let file = SceneFile::from_toml(&document, "", &mut reader);
    if !errors.is_empty() {
        return Err(wrong(
            text,
            syntax::diagnostics(text, document.get_ref(), errors, reader.diagnostics.list),
        ));
    }

    let lines = LineIndex::new(text);
    let folder = path.parent().unwrap_or(Path::new(""));
    let builder = SceneBuilder::new(reader, &lines, MeshFiles::of(files, folder), size);
    let (description, reader) = builder.build(file.unwrap_or_default());
    let DiagnosticList { list, total } = reader.diagnostics;
    if total == 0 {
        return Ok(description);
    }
    Err(LoadError::Diagnostics(Box::new(Diagnostics::new(path, text, list).with_total(total))))
}

/// The JSON Schema of scenes, for editors.
pub fn schema() -> String {
    let schema = serde_json::to_string_pretty(&schemars::schema_for!(SceneFile)).unwrap_or_default();
    schema + "\n"
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::super::value::HINTS;

    /// The keys of a table, by the schema.
    fn keys(schema: &Value, table: &str) -> Vec<String> {
        let camel_case = |word: &str| word[..1].to_uppercase() + &word[1..];
        let name: String = table.split('_').filter(|word| !word.is_empty()).map(camel_case).collect();
        let table = if table.is_empty() { schema } else { &schema["$defs"][&name] };
        table["properties"].as_object().unwrap_or_else(|| panic!("{name}")).keys().cloned().collect()
    }

    #[test]
    fn hints_are_for_words_that_are_no_keys_and_suggest_keys_of_their_tables() {
        let schema: Value = serde_json::from_str(&super::schema()).unwrap();
        for hint in HINTS {
            let tables: Vec<_> = hint.tables.iter().map(|table| keys(&schema, table)).collect();
            for key in hint.keys.split(' ').filter(|key| !key.is_empty()) {
                assert!(
                    tables.iter().any(|keys| keys.iter().any(|it| it == key)),
                    "{key} of {:?}",
                    hint.tables
                );
            }
            for word in hint.words.split(' ') {
                let is_hint = |keys: &Vec<String>| !keys.iter().any(|key| key == word);
                assert!(tables.iter().any(is_hint), "{word} is a key of {:?}", hint.tables);
            }
        }
    }
}
