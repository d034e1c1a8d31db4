//! How shading normals are found.

/// How the shading normals of triangles and polygons are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// The geometric normal.
    Flat,
    /// Interpolated between the normals of the vertices.
    Smooth,
}
