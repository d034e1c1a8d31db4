//! A surface as a ray sees it, and where rays leave it.

use crate::geometry::{SurfaceInteraction, offset_origin};
use crate::math::Vec3;

/// A surface as it is seen along a ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    /// The surface.
    pub(crate) surface: SurfaceInteraction,
    /// The direction of the ray, of length one.
    pub(crate) along: Vec3,
    /// Whether the ray comes from the side that the normal points to.
    pub(crate) outside: bool,
    /// The geometric normal on the ray's side.
    pub(crate) facing: Vec3,
    /// The shading normal, on the same side.
    pub(crate) shading: Vec3,
}

impl Seen {
    pub(crate) fn new(surface: SurfaceInteraction, along: Vec3) -> Self {
        let outside = surface.normal.dot(along) <= 0.0;
        let turned = |n: Vec3| if outside { n } else { -n };
        Seen {
            surface,
            along,
            outside,
            facing: turned(surface.normal),
            shading: turned(surface.shading_normal),
        }
    }

    /// The normal that mirrors and breaks light: the shading one, or the geometric one where the
    /// shading one is turned away from the ray, as it may be near the outline of a coarse mesh.
    pub(crate) fn optical(&self) -> Vec3 {
        self.unless_turned_away(self.shading)
    }

    /// The normal, or the geometric one where it is turned away from the ray.
    pub(crate) fn unless_turned_away(&self, normal: Vec3) -> Vec3 {
        if normal.dot(self.along) < 0.0 { normal } else { self.facing }
    }

    /// Where a ray starts that stays on the side that the surface is seen from.
    #[inline(always)]
    pub(crate) fn before(&self) -> Vec3 {
        offset_origin(self.surface.point, self.surface.point_error, self.facing)
    }

    /// Where a ray starts that goes on through the surface.
    #[inline(always)]
    pub(crate) fn behind(&self) -> Vec3 {
        offset_origin(self.surface.point, self.surface.point_error, -self.facing)
    }
}
