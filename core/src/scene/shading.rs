//! Flat or smooth shading of triangles and polygons.

/// Which normals shade the triangles and polygons that are added to [`SceneTables`](super::SceneTables).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// The geometric normal, so that facets are visible.
    Flat,
    /// Interpolated between the normals of the vertices, which must be there.
    Smooth,
}
