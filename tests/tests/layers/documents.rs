//! Every path that a document names exists.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::workspace;

/// Folders without documents of the project.
const FOREIGN: [&str; 5] = ["target", ".git", "corpus", "artifacts", "node_modules"];

/// All documents below a folder.
fn documents(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_dir() && !FOREIGN.contains(&name) {
            documents(&path, found);
        } else if name.ends_with(".md") {
            found.push(path);
        }
    }
}

/// Paths that a document in this folder names: those that begin with `scenes/` or `tests/`, and the targets
/// of its links.
fn named_in(folder: &Path, text: &str) -> BTreeSet<PathBuf> {
    let is_of_a_path = |c: char| c.is_ascii_alphanumeric() || "._/-".contains(c);
    let paths = text.split(|c| !is_of_a_path(c)).map(|word| word.trim_end_matches('.'));
    let paths = paths.filter(|word| word.starts_with("scenes/") || word.starts_with("tests/"));
    let links = text.split("](").skip(1).filter_map(|link| link.split([')', '#', ' ']).next());
    let links = links.filter(|link| !link.is_empty() && !link.contains("://"));
    paths.map(PathBuf::from).chain(links.map(|link| folder.join(link))).collect()
}

#[test]
fn every_path_that_a_document_names_exists() {
    let mut found = Vec::new();
    documents(&workspace(), &mut found);
    let mut missing = Vec::new();
    let mut count = 0;
    for document in found {
        let name = document.strip_prefix(workspace()).unwrap();
        let text = fs::read_to_string(&document).unwrap();
        for path in named_in(name.parent().unwrap(), &text) {
            count += 1;
            let is_built = path.iter().any(|name| name == "target");
            if !is_built && !workspace().join(&path).exists() {
                missing.push(format!("{} names {}", name.display(), path.display()));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
    assert!(count > 50, "only {count} paths found");
}

#[test]
fn the_paths_that_a_document_names_are_found() {
    let text = "`strahl a scenes/b.toml`, host/tests/c; tests/d/e.rs. [f](g.md#h) [i](https://j/k) [l](#m)\n";
    let found: Vec<PathBuf> = named_in("tests".as_ref(), text).into_iter().collect();
    assert_eq!(found, ["scenes/b.toml", "tests/d/e.rs", "tests/g.md"].map(PathBuf::from));
}
