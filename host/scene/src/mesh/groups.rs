//! Triangle meshes, in groups of one material.

use strahl_core::Material;

use crate::description::Float3;

/// The triangles of a mesh file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// The vertices.
    pub vertices: Vec<Float3>,
    /// The vertex normals: empty, or one for each vertex, none of them zero.
    pub normals: Vec<Float3>,
    /// The triangles, as indices into `vertices`.
    pub triangles: Vec<[u32; 3]>,
    /// Groups of consecutive triangles of one material; together they cover all triangles in order.
    pub groups: Vec<MaterialGroup>,
    /// The materials, with their names.
    pub materials: Vec<(String, Material)>,
    /// Warnings for the user.
    pub warnings: Vec<String>,
}

/// Consecutive triangles of one material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialGroup {
    /// The number of triangles.
    pub count: u32,
    /// The index of the material; `None` if the file names none.
    pub material: Option<u16>,
}
