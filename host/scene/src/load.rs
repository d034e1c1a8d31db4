//! Loading of scene files in any format.

use std::path::Path;

use strahl_core::Resolution;
use strahl_settings::DEFAULT_SIZE;

use crate::description::LoadedScene;
use crate::error::LoadError;
use crate::source_files::SourceFiles;
use crate::{mesh, nff, toml_scene};

/// Loads the scene file at `path`; the extension selects the format.
pub fn load(path: &Path) -> Result<LoadedScene, LoadError> {
    load_for_size(path, DEFAULT_SIZE)
}

/// Loads the scene file at `path`. If it has no camera, one is chosen that shows the whole scene in a picture of `size`.
pub fn load_for_size(path: &Path, size: Resolution) -> Result<LoadedScene, LoadError> {
    load_from(&SourceFiles::on_disk(), path, size)
}

/// Like [`load_for_size`], with all files read through `files`.
pub fn load_from(files: &SourceFiles, path: &Path, size: Resolution) -> Result<LoadedScene, LoadError> {
    if mesh::is_mesh(path) {
        return mesh::default_scene(files, path, size);
    }
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    // A missing file is reported first, whatever its extension.
    let bytes = files.read(path).map_err(|error| LoadError::Unreadable { path: path.to_owned(), error })?;
    match extension.as_str() {
        "nff" => nff::read(path, &bytes),
        "toml" => toml_scene::read(files, path, &bytes, size),
        _ => Err(LoadError::Invalid {
            path: path.to_owned(),
            line: None,
            reason: "unsupported scene format; the extension must be .toml, .nff, .obj, .ply, .gltf or .glb"
                .into(),
        }),
    }
}
