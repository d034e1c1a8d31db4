//! A surface as a ray sees it, and where rays leave it.

use crate::geometry::{SurfaceInteraction, offset_origin};
use crate::math::Vec3;

/// A surface as it is seen along a ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadingPoint {
    /// The surface.
    pub(crate) surface: SurfaceInteraction,
    /// The direction of the ray, of length one.
    pub(crate) ray_direction: Vec3,
    /// Whether the ray comes from the side that the normal points to.
    pub(crate) front_face: bool,
    /// The geometric normal on the ray's side.
    pub(crate) geometric_normal: Vec3,
    /// The shading normal, on the same side.
    pub(crate) shading_normal: Vec3,
}

impl ShadingPoint {
    pub(crate) fn new(surface: SurfaceInteraction, along: Vec3) -> Self {
        let outside = surface.normal.dot(along) <= 0.0;
        let turned = |n: Vec3| if outside { n } else { -n };
        ShadingPoint {
            surface,
            ray_direction: along,
            front_face: outside,
            geometric_normal: turned(surface.normal),
            shading_normal: turned(surface.shading_normal),
        }
    }

    /// The normal that mirrors and breaks light: the shading one, or the geometric one where the
    /// shading one is turned away from the ray, as it may be near the outline of a coarse mesh.
    pub(crate) fn optical_normal(&self) -> Vec3 {
        self.normal_or_geometric(self.shading_normal)
    }

    /// The normal, or the geometric one where it is turned away from the ray.
    pub(crate) fn normal_or_geometric(&self, normal: Vec3) -> Vec3 {
        if normal.dot(self.ray_direction) < 0.0 { normal } else { self.geometric_normal }
    }

    /// Where a ray starts that stays on the side that the surface is seen from.
    #[inline(always)]
    pub(crate) fn origin_in_front(&self) -> Vec3 {
        offset_origin(self.surface.point, self.surface.point_error, self.geometric_normal)
    }

    /// Where a ray starts that goes on through the surface.
    #[inline(always)]
    pub(crate) fn origin_behind(&self) -> Vec3 {
        offset_origin(self.surface.point, self.surface.point_error, -self.geometric_normal)
    }
}
