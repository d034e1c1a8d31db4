//! Checks of the loaders, for every file, valid or not: no panic, bounded memory, and either a scene that the
//! tracer accepts or an error with an existing position and a message without control characters.
//!
//! Files are in memory, so that no input can reach the disk.

use std::path::{Path, PathBuf};

use strahl_scene::LoadError;
use strahl_scene::description::LoadedScene;
use strahl_scene::{SourceFiles, load_from};
use strahl_session::tables;
use strahl_settings::DEFAULT_SIZE;

use crate::memory::{Bound, peak_memory};

/// Checks the bytes of an NFF scene.
pub fn nff(bytes: &[u8]) {
    check(&[("scene.nff", bytes)], Bound::NFF);
}

/// Checks the bytes of a TOML scene, with a mesh file beside it.
pub fn toml(bytes: &[u8]) {
    let ply = include_bytes!("../../fuzz/seeds/ply/square.ply");
    check(&[("scene.toml", bytes), ("a.ply", ply)], Bound::TOML);
}

/// Checks the bytes of an OBJ model, followed by a zero and its materials.
pub fn obj(bytes: &[u8]) {
    let (model, materials) = match bytes.iter().position(|byte| *byte == 0) {
        Some(zero) => (&bytes[..zero], &bytes[zero + 1..]),
        None => (bytes, &[][..]),
    };
    check(&[("model.obj", model), ("a.mtl", materials)], Bound::MESH);
}

/// Checks the bytes of a PLY model.
pub fn ply(bytes: &[u8]) {
    check(&[("model.ply", bytes)], Bound::MESH);
}

/// Checks the bytes of a glTF or GLB model, with a buffer file beside it.
pub fn gltf(bytes: &[u8]) {
    let buffer = include_bytes!("../../fuzz/seeds/square.bin");
    check(&[("model.gltf", bytes), ("a.bin", buffer)], Bound::MESH);
}

/// Loads the first file and checks the result.
fn check(files: &[(&str, &[u8])], bound: Bound) {
    let size: usize = files.iter().map(|(_, bytes)| bytes.len()).sum();
    let in_memory = files.iter().map(|(name, bytes)| (PathBuf::from(name), bytes.to_vec()));
    let in_memory = SourceFiles::from_memory(in_memory);
    let path = Path::new(files[0].0);
    let (loaded, most) = peak_memory(|| load_from(&in_memory, path, DEFAULT_SIZE));
    match loaded {
        Ok(it) => {
            assert_scene(&it);
            // A mesh may have many instances, which count as bytes of the file.
            let copies = 12 * (it.vertices.len() + it.normals.len() + it.triangles.len());
            assert_memory(most, bound.of(size.max(copies)));
        }
        Err(error) => {
            assert_error(&error, files);
            assert_memory(most, bound.of(size));
        }
    }
}

fn assert_memory(most: usize, bound: usize) {
    assert!(most <= bound, "{most} bytes in use, the limit is {bound}");
}

/// A loaded scene is valid in both precisions.
fn assert_scene(it: &LoadedScene) {
    let single = tables::single::scene_tables(it);
    assert_eq!(single.scene().err(), None);
    assert!(tables::double::scene_tables(it).scene().is_ok());
    assert!(it.normals.is_empty() || it.normals.len() <= it.vertices.len());
    assert!(!it.normals.contains(&[0.0; 3]));
    assert!(it.warnings.iter().all(|warning| is_harmless(warning)), "{:?}", it.warnings);
}

/// An error has an existing position.
fn assert_error(error: &LoadError, files: &[(&str, &[u8])]) {
    let lines = |path: &Path| {
        let (_, bytes) = files.iter().find(|(name, _)| Path::new(name) == path).expect("a file of the input");
        bytes.split_inclusive(|byte| *byte == b'\n').count().max(1)
    };
    match error {
        LoadError::Invalid { path, line, reason } => {
            // Missing text at the end is reported in the line after it.
            assert!(line.is_none_or(|line| line >= 1 && line <= lines(path) + 1), "{line:?}: {reason}");
            assert!(is_harmless(reason) && reason.chars().count() < 400, "{reason:?}");
        }
        LoadError::Diagnostics(diagnostics) => {
            assert!(!diagnostics.list().is_empty());
            let last = lines(Path::new(files[0].0));
            for diagnostic in diagnostics.list() {
                let (line, column) = diagnostics.line_and_column(diagnostic);
                assert!(line >= 1 && line <= last && column >= 1, "{line}:{column} of {last} lines");
                assert!(is_harmless(&diagnostic.message), "{:?}", diagnostic.message);
                assert!(diagnostic.help.as_deref().is_none_or(is_harmless), "{:?}", diagnostic.help);
            }
            assert!(diagnostics.to_string().lines().all(is_harmless));
        }
        LoadError::Unreadable { path, .. } => {
            assert!(files.iter().all(|(name, _)| Path::new(name) != path), "{error}");
        }
        _ => unreachable!("{error}"),
    }
}

fn is_harmless(text: &str) -> bool {
    !text.contains(|c: char| c.is_control() && c != '\t')
}
