//! Mesh files that a scene references.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use crate::mesh::TriangleMesh;
use crate::source_files::SourceFiles;

/// The meshes of all files read so far; each file is read once.
pub struct MeshFiles<'m> {
    pub files: &'m SourceFiles,
    pub folder: &'m Path,
    pub read: HashMap<PathBuf, Option<TriangleMesh>>,
}

impl<'m> MeshFiles<'m> {
    /// No meshes, for a scene in `folder`.
    pub fn of(files: &'m SourceFiles, folder: &'m Path) -> Self {
        MeshFiles { files, folder, read: HashMap::new() }
    }
}
