//! The triangles of a file, in groups of one material.

use strahl_core::Material;

use crate::description::Float3;

/// The triangles of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// The corners.
    pub vertices: Vec<Float3>,
    /// Normals of corners: none at all, or one for each point and none of them zero.
    pub normals: Vec<Float3>,
    /// The places of the corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Which triangles are of which material; they cover all triangles in order.
    pub groups: Vec<MaterialGroup>,
    /// The materials with their names.
    pub materials: Vec<(String, Material)>,
    /// What a user should know of that is no error.
    pub warnings: Vec<String>,
}

/// Triangles that follow each other and are of one material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialGroup {
    /// How many triangles.
    pub count: u32,
    /// The place of their material; none when the file names none.
    pub material: Option<u16>,
}
