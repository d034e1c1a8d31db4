//! Architecture tests: a module of the core uses only lower layers, no modules of any package use each other in
//! a circle, and each file is a module of one crate.

mod circles;
mod documents;
mod expansion;
mod files;
mod names;
mod proof;
mod scope;
mod source;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use circles::circles;
use names::Names;
use source::{Crate, Module};
use syn::Item;

/// The modules at the root of the core, lowest first. Those in one line do not use each other.
const LAYERS: [&[&str]; 10] = [
    &["math", "set"],
    &["geometry"],
    &["tally"],
    &["accel"],
    &["scene"],
    &["baked"],
    &["shade"],
    &["trace"],
    &["image"],
    &["render"],
];

/// Maximum number of lines of a module of the core, without its unit tests.
const MAX_LINES: usize = 350;

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

fn core() -> Crate {
    let core = Crate::read(&workspace().join("core/src/lib.rs"));
    assert!(core.modules.len() > 50, "only {} modules found", core.modules.len());
    core
}

/// All targets of the workspace's packages: the package, and the file of the root module. A package with `Real = f64` has
/// the sources of the package for single precision, and counts once.
fn targets() -> Vec<(String, PathBuf)> {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--no-deps", "--offline", "--format-version", "1"])
        .current_dir(workspace())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let mut targets: Vec<(String, PathBuf)> = Vec::new();
    for package in metadata["packages"].as_array().unwrap() {
        for target in package["targets"].as_array().unwrap() {
            let root = fs::canonicalize(target["src_path"].as_str().unwrap()).unwrap();
            if targets.iter().all(|(_, known)| *known != root) {
                targets.push((package["name"].as_str().unwrap().to_owned(), root));
            }
        }
    }
    targets
}

#[test]
fn a_module_of_the_core_uses_only_layers_below_its_own() {
    let core = core();
    let names = Names::of(&core);
    let layer = |module: &Module| {
        let name = module.path.first()?;
        let layer = LAYERS.iter().position(|layer| layer.contains(&name.as_str()));
        Some(layer.unwrap_or_else(|| panic!("{name} is in no layer")))
    };
    let mut uses = 0;
    // The root of the core names all of them.
    for (index, user) in core.modules.iter().enumerate().skip(1) {
        for used in names.used_by(index) {
            let used = &core.modules[used];
            let is_below = used.path.first() == user.path.first() || layer(used) < layer(user);
            let (user, used) = (user.path.join("::"), used.path.join("::"));
            assert!(is_below, "{user} uses crate::{used}, which does not lie below it");
            uses += 1;
        }
    }
    assert!(uses > 200, "only {uses} uses found");
}

#[test]
fn no_modules_use_each_other_in_a_circle() {
    let mut found = Vec::new();
    for (package, root) in targets() {
        for circle in circles(&Crate::read(&root)) {
            found.push(format!("{package}, {}\n    {}", circle.name, circle.uses.join("\n    ")));
        }
    }
    assert!(found.is_empty(), "in a circle:\n{}", found.join("\n"));
}

#[test]
fn the_core_links_no_crate_but_alloc_by_its_feature() {
    for module in core().modules {
        for item in &module.items {
            if let Item::ExternCrate(it) = item {
                let is_by_feature = source::features(&it.attrs).contains(&"alloc".to_owned());
                assert!(it.ident == "alloc" && is_by_feature, "{} links {}", module.file.display(), it.ident);
            }
        }
    }
}

#[test]
fn only_one_file_of_the_core_names_libm() {
    let core = core();
    let names = Names::of(&core);
    let named = (0..core.modules.len()).filter(|module| names.names_crate(*module, "libm"));
    let files: BTreeSet<&Path> = named.map(|module| core.modules[module].file.as_path()).collect();
    assert_eq!(Vec::from_iter(files), [workspace().join("core/src/math/float.rs")]);
}

#[test]
fn no_module_of_the_core_is_too_long() {
    for module in core().modules {
        let text = fs::read_to_string(&module.file).unwrap();
        let lines = text.lines().take_while(|line| line.trim() != "mod tests {").count();
        assert!(lines <= MAX_LINES, "{} has {lines} lines", module.file.display());
    }
}
