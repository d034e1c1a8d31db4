//! Scene files become descriptions.

use std::path::Path;

use strahl_core::Resolution;
use strahl_settings::DEFAULT_SIZE;

use crate::description::LoadedScene;
use crate::error::LoadError;
use crate::source_files::SourceFiles;
use crate::{mesh, nff, toml_scene};

/// Loads the scene file at `path`; its extension names the format.
pub fn load(path: &Path) -> Result<LoadedScene, LoadError> {
    load_for_size(path, DEFAULT_SIZE)
}

/// Loads the scene file at `path` for a picture of `size`: where the file has no view, one is
/// chosen that suits it.
pub fn load_for_size(path: &Path, size: Resolution) -> Result<LoadedScene, LoadError> {
    load_from(&SourceFiles::on_disk(), path, size)
}

/// The same from these files.
pub fn load_from(files: &SourceFiles, path: &Path, size: Resolution) -> Result<LoadedScene, LoadError> {
    if mesh::is_mesh(path) {
        return mesh::default_scene(files, path, size);
    }
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    // A file that is not there is told first, whatever its name.
    let bytes = files.read(path).map_err(|error| LoadError::Unreadable { path: path.to_owned(), error })?;
    match extension.as_str() {
        "nff" => nff::read(path, &bytes),
        "toml" => toml_scene::read(files, path, &bytes, size),
        _ => Err(LoadError::Invalid {
            path: path.to_owned(),
            line: None,
            reason:
                "not a scene that strahl reads; the extension must be .toml, .nff, .obj, .ply, .gltf or .glb"
                    .into(),
        }),
    }
}
