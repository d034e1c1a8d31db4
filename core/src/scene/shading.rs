//! Flat or smooth shading of triangles and polygons.

/// Shading normals of triangles and polygons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// The geometric normal.
    Flat,
    /// Interpolated between the normals of the vertices.
    Smooth,
}
