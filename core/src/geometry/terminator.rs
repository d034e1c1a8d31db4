//! Shadow terminator correction for smooth triangles and polygons.
//!
//! A smooth shape is flat; only its shading normals are those of a curved surface. If a shading normal
//! faces a light below the horizon of the flat face, a shadow ray from the face would immediately enter the
//! shape, and the boundary of the shadow would follow the edges of the faces. The curved surface lies
//! farther out, so such a shadow ray starts there: at the point plus the interpolated offsets to the
//! tangent planes of the vertices.
//!
//! Shadow rays to lights above the horizon start at the face, so they skip no occluder between the face and
//! the curved surface.
//!
//! Source: Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, chapter 4.

use super::tables::get;
use super::{Geometry, Shape, ShapeFeatures, ShapeKind, triangle};
use crate::math::Vec3;

impl Geometry<'_> {
    /// Offset from a point of a smooth shape to the curved surface that its shading normals represent;
    /// `None` for other shapes.
    ///
    /// `front_face`: the side of the offset, that of the normals or the other.
    pub(crate) fn terminator_offset<S: ShapeFeatures>(
        &self,
        shape: Shape,
        point: Vec3,
        front_face: bool,
    ) -> Option<Vec3> {
        let supports = |kind| S::SMOOTH_SHADING && S::SHAPES.contains(kind);
        match shape {
            Shape::SmoothTriangle(indices) if supports(ShapeKind::SmoothTriangle) => {
                let (vertices, normals) = (self.vertices(indices)?, self.vertex_normals(indices)?);
                Some(triangle::terminator_offset(vertices, normals, point, front_face))
            }
            Shape::Polygon(index) if supports(ShapeKind::Polygon) => get(self.polygons, index)?
                .terminator_offset(self.vertices, self.vertex_normals, point, front_face),
            _ => None,
        }
    }
}
