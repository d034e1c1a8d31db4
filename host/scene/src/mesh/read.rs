//! Reads mesh files; the extension selects the format.

use std::path::Path;

use strahl_core::Resolution;

use super::error::invalid;
use super::groups::TriangleMesh;
use super::{default_view, gltf, obj, ply};
use crate::description::LoadedScene;
use crate::error::LoadError;
use crate::source_files::SourceFiles;

/// The extensions of the supported formats, in lower case.
pub const EXTENSIONS: [&str; 4] = ["obj", "ply", "gltf", "glb"];

/// Reads the mesh in the file at `path`; the extension selects the format.
pub fn read(path: &Path) -> Result<TriangleMesh, LoadError> {
    read_from(&SourceFiles::on_disk(), path)
}

/// Like [`read`], with all files read through `files`.
pub fn read_from(files: &SourceFiles, path: &Path) -> Result<TriangleMesh, LoadError> {
    parse(files, path, files.read(path))
}

/// Like [`read_from`], for a file that a scene references.
pub(crate) fn read_referenced(files: &SourceFiles, path: &Path) -> Result<TriangleMesh, LoadError> {
    parse(files, path, files.read_referenced(path))
}

fn parse(
    files: &SourceFiles,
    path: &Path,
    bytes: std::io::Result<Vec<u8>>,
) -> Result<TriangleMesh, LoadError> {
    let bytes = bytes.map_err(|error| LoadError::Unreadable { path: path.to_owned(), error })?;
    let in_file = |error| invalid(path, error);
    match extension(path).as_str() {
        "obj" => obj::read(files, path, &bytes),
        "ply" => ply::read(&bytes).map_err(in_file),
        "gltf" | "glb" => gltf::read(files, path, bytes),
        _ => {
            let reason = "unsupported mesh format; the extension must be .obj, .ply, .gltf or .glb";
            Err(in_file((None, reason.into())))
        }
    }
}

/// Whether the extension of `path` is that of a supported mesh format.
pub fn is_mesh(path: &Path) -> bool {
    EXTENSIONS.contains(&extension(path).as_str())
}

/// The mesh in the file at `path` as a scene, with a camera that shows all of it in a picture of `size`.
pub(crate) fn default_scene(
    files: &SourceFiles,
    path: &Path,
    size: Resolution,
) -> Result<LoadedScene, LoadError> {
    // PLY does not define the up axis; z is usual. OBJ has y up by convention, glTF by definition.
    let up = if extension(path) == "ply" { default_view::UpAxis::Z } else { default_view::UpAxis::Y };
    default_view::with_default_view(read_from(files, path)?, up, size)
        .map_err(|reason| invalid(path, (None, reason)))
}

fn extension(path: &Path) -> String {
    path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase()
}
