//! What must hold of every file, right or wrong, that the loaders are given: no panic, no more
//! memory than a multiple of its size, a scene that the tracer takes, or a refusal with a place
//! that is there and a message that steers no terminal.
//!
//! Files are held in memory, so nothing that stands in one reaches the disk.

use std::path::{Path, PathBuf};

use strahl_scene::LoadError;
use strahl_scene::description::LoadedScene;
use strahl_scene::{SourceFiles, load_from};
use strahl_session::tables;
use strahl_settings::DEFAULT_SIZE;

use counting::{Bound, most_held};

#[path = "../../host/scene/tests/memory/counting.rs"]
pub mod counting;

/// Bytes of an NFF scene.
#[allow(dead_code)] // each target has its own
pub fn nff(bytes: &[u8]) {
    check(&[("scene.nff", bytes)], Bound::NFF);
}

/// Bytes of a TOML scene, beside which a mesh may stand.
#[allow(dead_code)]
pub fn toml(bytes: &[u8]) {
    let ply = include_bytes!("seeds/ply/square.ply");
    check(&[("scene.toml", bytes), ("a.ply", ply)], Bound::TOML);
}

/// Bytes of an OBJ model, and after a zero those of its materials.
#[allow(dead_code)]
pub fn obj(bytes: &[u8]) {
    let (model, materials) = match bytes.iter().position(|byte| *byte == 0) {
        Some(place) => (&bytes[..place], &bytes[place + 1..]),
        None => (bytes, &[][..]),
    };
    check(&[("model.obj", model), ("a.mtl", materials)], Bound::MESH);
}

/// Bytes of a PLY model.
#[allow(dead_code)]
pub fn ply(bytes: &[u8]) {
    check(&[("model.ply", bytes)], Bound::MESH);
}

/// Bytes of a glTF model in either form, beside which a buffer may stand.
#[allow(dead_code)]
pub fn gltf(bytes: &[u8]) {
    let buffer = include_bytes!("seeds/square.bin");
    check(&[("model.gltf", bytes), ("a.bin", buffer)], Bound::MESH);
}

/// Loads the first of the files.
fn check(files: &[(&str, &[u8])], bound: Bound) {
    let size: usize = files.iter().map(|(_, bytes)| bytes.len()).sum();
    let held = files.iter().map(|(name, bytes)| (PathBuf::from(name), bytes.to_vec()));
    let held = SourceFiles::from_memory(held);
    let path = Path::new(files[0].0);
    let (loaded, most) = most_held(|| load_from(&held, path, DEFAULT_SIZE));
    match loaded {
        Ok(it) => {
            is_scene(&it);
            // One mesh may stand in many places, so copies count as bytes of the file.
            let copies = 12 * (it.vertices.len() + it.normals.len() + it.triangles.len());
            is_bearable(most, bound.of(size.max(copies)));
        }
        Err(failure) => {
            is_refusal(&failure, files);
            is_bearable(most, bound.of(size));
        }
    }
}

fn is_bearable(most: usize, bound: usize) {
    assert!(most <= bound, "{most} bytes are held at once, {bound} may be");
}

/// What is loaded is a scene in either precision.
fn is_scene(it: &LoadedScene) {
    let single = tables::single::scene_tables(it);
    assert_eq!(single.scene().err(), None);
    assert!(tables::double::scene_tables(it).scene().is_ok());
    assert!(it.normals.is_empty() || it.normals.len() <= it.vertices.len());
    assert!(!it.normals.contains(&[0.0; 3]));
    assert!(it.warnings.iter().all(|warning| is_harmless(warning)), "{:?}", it.warnings);
}

/// What is refused is refused with a place that is there.
fn is_refusal(failure: &LoadError, files: &[(&str, &[u8])]) {
    let lines = |path: &Path| {
        let (_, bytes) =
            files.iter().find(|(name, _)| Path::new(name) == path).expect("a file that is there");
        bytes.split_inclusive(|byte| *byte == b'\n').count().max(1)
    };
    match failure {
        LoadError::Invalid { path, line, reason } => {
            // What is missing at the end is missed in the line after it.
            assert!(line.is_none_or(|line| line >= 1 && line <= lines(path) + 1), "{line:?}: {reason}");
            assert!(is_harmless(reason) && reason.chars().count() < 400, "{reason:?}");
        }
        LoadError::Diagnostics(faults) => {
            assert!(!faults.list().is_empty());
            let last = lines(Path::new(files[0].0));
            for fault in faults.list() {
                let (line, column) = faults.line_and_column(fault);
                assert!(line >= 1 && line <= last && column >= 1, "{line}:{column} of {last} lines");
                assert!(is_harmless(&fault.message), "{:?}", fault.message);
                assert!(fault.help.as_deref().is_none_or(is_harmless), "{:?}", fault.help);
            }
            assert!(faults.to_string().lines().all(is_harmless));
        }
        LoadError::Unreadable { path, .. } => {
            assert!(files.iter().all(|(name, _)| Path::new(name) != path), "{failure}");
        }
        _ => unreachable!("{failure}"),
    }
}

fn is_harmless(text: &str) -> bool {
    !text.contains(|c: char| c.is_control() && c != '\t')
}
