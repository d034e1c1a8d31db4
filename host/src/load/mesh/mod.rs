//! Files of triangles: OBJ with MTL, PLY and glTF 2.0.
//!
//! Each format has a room that reads its words; what they find is gathered by the same rules:
//!
//! * Polygons are cut into triangles, concave ones too.
//! * Where some corners have normals and others none, or one that is zero, the others get that
//!   of their triangle. Where none has one the mesh stays flat: nothing is smoothed that the
//!   file does not ask for.
//! * A triangle without area keeps its number; one warning counts them.
//! * What has no place in a mesh (lines, textures, colours of corners ...) is counted in a
//!   warning for each kind.
//! * No number in a file is believed before as much data has been seen, so memory is bounded
//!   by a multiple of the sizes of the files, except that glTF may place one mesh many times.

mod gather;
mod gltf;
mod mtl;
mod obj;
mod ply;
mod text;
mod triangulate;
mod view;

use std::path::Path;

use strahl_core::{Material, Resolution};

use super::Files;
use crate::description::{Description, Triple};
use crate::failure::Failure;

/// The extensions of the formats that are read here.
pub const EXTENSIONS: [&str; 4] = ["obj", "ply", "gltf", "glb"];

/// The triangles of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The corners.
    pub points: Vec<Triple>,
    /// Normals of corners: none at all, or one for each point and none of them zero.
    pub normals: Vec<Triple>,
    /// The places of the corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Which triangles are of which material; they cover all triangles in order.
    pub groups: Vec<Group>,
    /// The materials with their names.
    pub materials: Vec<(String, Material)>,
    /// What a user should know of that is no error.
    pub warnings: Vec<String>,
}

/// Triangles that follow each other and are of one material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Group {
    /// How many triangles.
    pub count: u32,
    /// The place of their material; none when the file names none.
    pub material: Option<u16>,
}

/// Reads the mesh in the file at `path`; its extension names the format.
pub fn read(path: &Path) -> Result<Mesh, Failure> {
    read_from(&Files::on_disk(), path)
}

/// The same from these files.
pub fn read_from(files: &Files, path: &Path) -> Result<Mesh, Failure> {
    parse(files, path, files.read(path))
}

/// The same of a file that another one names.
pub(super) fn read_companion(files: &Files, path: &Path) -> Result<Mesh, Failure> {
    parse(files, path, files.companion(path))
}

fn parse(files: &Files, path: &Path, bytes: std::io::Result<Vec<u8>>) -> Result<Mesh, Failure> {
    let bytes = bytes.map_err(|error| Failure::Unreadable { path: path.to_owned(), error })?;
    let wrong = |(line, reason): Wrong| Failure::Input { path: path.to_owned(), line, reason };
    match extension(path).as_str() {
        "obj" => obj::read(files, path, &bytes),
        "ply" => ply::read(&bytes).map_err(wrong),
        "gltf" | "glb" => gltf::read(files, path, bytes),
        _ => {
            let reason = "not a mesh that strahl reads; the extension must be .obj, .ply, .gltf or .glb";
            Err(wrong((None, reason.into())))
        }
    }
}

/// Whether the extension of `path` is that of a format that is read here.
pub fn is_mesh(path: &Path) -> bool {
    EXTENSIONS.contains(&extension(path).as_str())
}

/// The mesh in the file at `path` as a scene of its own, seen whole in a picture of `size`.
pub(super) fn scene(files: &Files, path: &Path, size: Resolution) -> Result<Description, Failure> {
    // In PLY files nothing says what is up. Programs that make things stand them on the plane
    // of x and y; OBJ and glTF files have y up by custom and by definition.
    let up = if extension(path) == "ply" { view::Up::Z } else { view::Up::Y };
    view::staged(read_from(files, path)?, up, size).map_err(|reason| Failure::Input {
        path: path.to_owned(),
        line: None,
        reason,
    })
}

fn extension(path: &Path) -> String {
    path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase()
}

/// The line, where there are lines, and what is wrong there.
type Wrong = (Option<usize>, String);
