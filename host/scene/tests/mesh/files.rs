//! Small files of every format, and functions to read them.

use std::path::{Path, PathBuf};

use base64::Engine;
use strahl_scene::LoadError;
use strahl_scene::mesh::{MaterialGroup, TriangleMesh, read};
use tempfile::TempDir;

/// A folder with files.
pub struct Folder(TempDir);

impl Folder {
    pub fn of(files: &[(&str, &[u8])]) -> Self {
        let folder = Folder(tempfile::tempdir().unwrap());
        for (name, bytes) in files {
            std::fs::write(folder.path(name), bytes).unwrap();
        }
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }
}

/// The mesh in a file of this name, with other files in the same folder.
pub fn read_with(name: &str, bytes: &[u8], others: &[(&str, &[u8])]) -> TriangleMesh {
    let folder = Folder::of(others);
    std::fs::write(folder.path(name), bytes).unwrap();
    read(&folder.path(name)).unwrap_or_else(|failure| panic!("{failure}\n{}", String::from_utf8_lossy(bytes)))
}

/// The mesh in a file with this extension.
pub fn mesh(extension: &str, bytes: impl AsRef<[u8]>) -> TriangleMesh {
    read_with(&format!("file.{extension}"), bytes.as_ref(), &[])
}

/// The error of a file of this name.
pub fn failure(name: &str, bytes: &[u8], others: &[(&str, &[u8])]) -> (LoadError, PathBuf) {
    let folder = Folder::of(others);
    let path = folder.path(name);
    std::fs::write(&path, bytes).unwrap();
    (read(&path).expect_err(&String::from_utf8_lossy(bytes)), path)
}

/// The line and the message of the error of a file.
pub fn refused(extension: &str, bytes: impl AsRef<[u8]>) -> (Option<usize>, String) {
    match failure(&format!("file.{extension}"), bytes.as_ref(), &[]) {
        (LoadError::Invalid { path, line, reason }, file) if path == file => (line, reason),
        (other, _) => panic!("{other:?}"),
    }
}

/// Groups with these numbers of triangles and these materials.
pub fn groups(groups: &[(u32, Option<u16>)]) -> Vec<MaterialGroup> {
    groups.iter().map(|(count, material)| MaterialGroup { count: *count, material: *material }).collect()
}

/// A unit square of two triangles, in OBJ.
pub const SQUARE_OBJ: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

/// The same square in PLY.
pub const SQUARE_PLY: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
    property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

/// The mesh of both files.
pub fn square() -> TriangleMesh {
    TriangleMesh {
        vertices: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        groups: groups(&[(2, None)]),
        ..TriangleMesh::default()
    }
}

/// The bytes of numbers, in the encoding of glTF.
pub fn floats(numbers: &[f32]) -> Vec<u8> {
    numbers.iter().flat_map(|x| x.to_le_bytes()).collect()
}

/// Four vertices in 48 bytes, their normals in another 48, six indices in 12.
pub fn square_bytes() -> Vec<u8> {
    let mut bytes = floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
    bytes.extend(floats(&[0.0, 0.0, 1.0].repeat(4)));
    bytes.extend([0_u16, 1, 2, 0, 2, 3].iter().flat_map(|i| i.to_le_bytes()));
    bytes
}

/// The views and accessors of [`square_bytes`]: 0 points, 1 normals, 2 indices.
pub const SQUARE_PLACES: &str = r#"
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":48},
    {"buffer":0,"byteOffset":96,"byteLength":12}],
"accessors":[
    {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
    {"bufferView":1,"componentType":5126,"count":4,"type":"VEC3"},
    {"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}]"#;

/// A file in glTF of [`square_bytes`] with these nodes, meshes and the rest.
pub fn gltf_of(rest: &str) -> String {
    let data = base64::engine::general_purpose::STANDARD.encode(square_bytes());
    let uri = format!("data:application/octet-stream;base64,{data}");
    gltf_with(&format!(r#""uri":"{uri}","#), rest)
}

/// The same with another URI of the buffer.
pub fn gltf_with(uri: &str, rest: &str) -> String {
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},{rest},{SQUARE_PLACES},\n\"buffers\":[{{{uri}\"byteLength\":108}}]}}"
    )
}

/// One node, one mesh.
pub const PLAIN: &str = r#""scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":2}]}]"#;

/// A `.glb` file of these two chunks.
pub fn glb(json: &str, binary: Option<&[u8]>) -> Vec<u8> {
    let mut parts = Vec::new();
    let mut part = |kind: &[u8; 4], bytes: &[u8], padding: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), padding);
        parts.extend((bytes.len() as u32).to_le_bytes());
        parts.extend(kind);
        parts.extend(bytes);
    };
    part(b"JSON", json.as_bytes(), b' ');
    if let Some(binary) = binary {
        part(b"BIN\0", binary, 0);
    }
    let mut file = b"glTF".to_vec();
    file.extend(2_u32.to_le_bytes());
    file.extend((parts.len() as u32 + 12).to_le_bytes());
    file.extend(parts);
    file
}

/// Whether the path ends in this file name.
pub fn is_named(path: &Path, name: &str) -> bool {
    path.file_name().is_some_and(|n| n == name)
}
