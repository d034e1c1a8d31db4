//! What fuzzing begins with, and what it has found: every file is read as fuzzing reads it.
//!
//! The allocator of this program counts, so it has one test and no others beside it.

use std::fs;
use std::path::Path;

#[path = "../../../tests/fuzz/checks.rs"]
mod checks;
#[path = "../../../tests/fuzz/packs.rs"]
mod packs;

#[test]
fn what_fuzzing_begins_with_and_what_it_has_found_is_read_or_refused_as_it_should() {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/fuzz");
    let mut count = 0;
    for folder in ["seeds", "finds"] {
        for (target, check) in [
            ("nff", checks::nff as fn(&[u8])),
            ("toml", checks::toml),
            ("obj", checks::obj),
            ("ply", checks::ply),
            ("gltf", checks::gltf),
            ("pack", packs::pack),
        ] {
            let Ok(files) = fs::read_dir(fuzz.join(folder).join(target)) else { continue };
            for file in files {
                let path = file.unwrap().path();
                // Told when a check fails.
                eprintln!("{}", path.display());
                check(&fs::read(&path).unwrap());
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count} files");
}
