//! Hits of rays, and the surface at a hit.

use super::ItemId;
use crate::math::{Real, Vec3};

/// A hit of a ray on an item: where along the ray, and which item.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Parameter of the hit, in lengths of the ray's direction; positive and finite.
    pub t: Real,
    /// Item that was hit.
    pub item: ItemId,
}

/// The surface of a shape at a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceInteraction {
    /// Position, projected onto the shape, world space.
    pub point: Vec3,
    /// Bound on the absolute error of each component of `point`, in scene lengths. It includes the rounding
    /// errors of the next ray's origin ([`offset_origin`](super::offset_origin)).
    pub point_error: Vec3,
    /// Geometric unit normal. It points out of solids, away from the axis of cones, and is right-handed
    /// around the vertices of triangles and polygons. It defines the front side of the surface.
    pub normal: Vec3,
    /// Shading unit normal: interpolated for smooth shapes, equal to `normal` for all others.
    pub shading_normal: Vec3,
}

impl SurfaceInteraction {
    /// A surface whose shading normal is its geometric normal.
    pub(super) fn with_geometric_normal(point: Vec3, error: Vec3, normal: Vec3) -> Self {
        SurfaceInteraction { point, point_error: error, normal, shading_normal: normal }
    }
}
