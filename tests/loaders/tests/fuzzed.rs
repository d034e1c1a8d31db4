//! Seeds and findings of fuzzing, read in the same way as by the fuzzers.
//!
//! The allocator counts all allocations of the process, so the program has only one test.

use std::fs;
use std::path::Path;

use strahl_loader_tests::{baked, loading};

#[test]
fn seeds_and_findings_of_fuzzing_load_or_are_rejected() {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz");
    let mut count = 0;
    for folder in ["seeds", "finds"] {
        for (target, check) in [
            ("nff", loading::nff as fn(&[u8])),
            ("toml", loading::toml),
            ("obj", loading::obj),
            ("ply", loading::ply),
            ("gltf", loading::gltf),
            ("pack", baked::pack),
        ] {
            let Ok(files) = fs::read_dir(fuzz.join(folder).join(target)) else { continue };
            for file in files {
                let path = file.unwrap().path();
                // Printed if a check fails.
                eprintln!("{}", path.display());
                check(&fs::read(&path).unwrap());
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count} files");
}
