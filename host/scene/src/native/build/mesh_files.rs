//! The files of meshes.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use crate::files::Files;
use crate::mesh::Mesh;

/// The files of meshes, each of which is read once.
pub struct MeshFiles<'m> {
    pub files: &'m Files,
    pub folder: &'m Path,
    pub read: HashMap<PathBuf, Option<Mesh>>,
}

impl<'m> MeshFiles<'m> {
    /// None yet, of a scene in `folder`.
    pub fn of(files: &'m Files, folder: &'m Path) -> Self {
        MeshFiles { files, folder, read: HashMap::new() }
    }
}
