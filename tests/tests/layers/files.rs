//! Each file is a module of one crate, in the folder that its path names.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, ItemMod, Meta};

use crate::source::{Crate, parsed};
use crate::{targets, workspace};

/// All Rust files below a folder, without those of builds.
fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_symlink() || name == "target" || name == ".git" {
            continue;
        }
        if path.is_dir() {
            rust_files(&path, found);
        } else if name.ends_with(".rs") {
            found.push(path);
        }
    }
}

/// The modules with a `path` attribute.
#[derive(Default)]
struct NamedModules(Vec<String>);

impl<'ast> Visit<'ast> for NamedModules {
    fn visit_item_mod(&mut self, module: &'ast ItemMod) {
        if module.attrs.iter().any(names_a_path) {
            self.0.push(module.ident.to_string());
        }
        visit::visit_item_mod(self, module);
    }
}

/// Whether this is `#[path = ...]`, or may become it by `cfg_attr`.
fn names_a_path(attribute: &Attribute) -> bool {
    match &attribute.meta {
        Meta::NameValue(it) => it.path.is_ident("path"),
        Meta::List(it) => it.path.is_ident("cfg_attr") && has_word(it.tokens.clone(), "path"),
        Meta::Path(_) => false,
    }
}

fn has_word(tokens: TokenStream, word: &str) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Ident(it) => it == word,
        TokenTree::Group(it) => has_word(it.stream(), word),
        _ => false,
    })
}

fn named_modules(file: &syn::File) -> Vec<String> {
    let mut named = NamedModules::default();
    named.visit_file(file);
    named.0
}

#[test]
fn no_module_has_a_path_attribute() {
    let mut files = Vec::new();
    rust_files(&workspace(), &mut files);
    assert!(files.len() > 300, "only {} files found", files.len());
    for file in files {
        let named = named_modules(&parsed(&file));
        assert!(named.is_empty(), "{}: {}", file.display(), named.join(", "));
    }
}

#[test]
fn path_attributes_of_modules_are_found() {
    let text = r#"
        #[path = "a.rs"]
        mod first;
        mod inside {
            #[cfg_attr(test, path = "b.rs")]
            mod second;
        }
        #[cfg(test)]
        mod third;
    "#;
    assert_eq!(named_modules(&syn::parse_str(text).unwrap()), ["first", "second"]);
}

#[test]
fn no_file_is_a_module_of_two_targets() {
    let mut target_of: HashMap<PathBuf, PathBuf> = HashMap::new();
    for (_, root) in targets() {
        for module in Crate::read(&root).modules {
            let file = fs::canonicalize(module.file).unwrap();
            let other = target_of.entry(file.clone()).or_insert_with(|| root.clone());
            assert_eq!(*other, root, "{}", file.display());
        }
    }
}
