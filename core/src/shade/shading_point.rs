//! A hit point with its normals on the side that the ray comes from, and origins of secondary rays.

use crate::geometry::{SurfaceInteraction, offset_origin};
use crate::math::Vec3;

/// A surface point as seen along a ray.
///
/// All vectors are in world space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadingPoint {
    /// The intersection; its normals do not depend on the ray.
    pub(crate) surface: SurfaceInteraction,
    /// Direction of the ray towards the surface, unit.
    pub(crate) ray_direction: Vec3,
    /// Whether the ray arrives on the side that the geometric normal points to.
    pub(crate) front_face: bool,
    /// Geometric normal, flipped to the side that the ray comes from.
    pub(crate) geometric_normal: Vec3,
    /// Shading normal, flipped together with the geometric normal.
    pub(crate) shading_normal: Vec3,
}

impl ShadingPoint {
    /// The point that a ray of this unit direction hits.
    pub(crate) fn new(surface: SurfaceInteraction, ray_direction: Vec3) -> Self {
        let front_face = surface.normal.dot(ray_direction) <= 0.0;
        let facing = |n: Vec3| if front_face { n } else { -n };
        ShadingPoint {
            surface,
            ray_direction,
            front_face,
            geometric_normal: facing(surface.normal),
            shading_normal: facing(surface.shading_normal),
        }
    }

    /// Normal for reflection and refraction: the shading normal, or the geometric normal where the shading
    /// normal faces away from the ray, as may happen near the silhouette of a coarse mesh.
    pub(crate) fn optical_normal(&self) -> Vec3 {
        self.normal_or_geometric(self.shading_normal)
    }

    /// `normal`, or the geometric normal if `normal` faces away from the ray.
    pub(crate) fn normal_or_geometric(&self, normal: Vec3) -> Vec3 {
        if normal.dot(self.ray_direction) < 0.0 { normal } else { self.geometric_normal }
    }

    /// Origin of a secondary ray on the side that the ray comes from.
    #[inline(always)]
    pub(crate) fn origin_in_front(&self) -> Vec3 {
        offset_origin(self.surface.point, self.surface.point_error, self.geometric_normal)
    }

    /// Origin of a secondary ray on the far side of the surface.
    #[inline(always)]
    pub(crate) fn origin_behind(&self) -> Vec3 {
        offset_origin(self.surface.point, self.surface.point_error, -self.geometric_normal)
    }
}
