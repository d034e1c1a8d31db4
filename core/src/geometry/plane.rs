//! Plane: all points level with a given one. It has no end, and so no box.
//!
//! The point is subtracted before anything else: the plane's distance from the world's origin would be
//! coarse far from there.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::{ItemId, Ray, ShapeFault, Surface, check_point, check_unit, ray::LEAVING};
use crate::math::{Real, Vec3, abs, gamma, largest};

/// An unbounded plane.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Plane {
    /// A point on it. Errors grow with the distance from here.
    pub point: Vec3,
    /// Upright on it, of length one.
    pub normal: Vec3,
    /// The item that it is: planes are tested before everything else, from their own table.
    pub item: ItemId,
}

impl Plane {
    pub(super) fn check(&self) -> Result<(), ShapeFault> {
        check_point(self.point)?;
        check_unit(self.normal)
    }

    pub(super) fn hit(&self, ray: &Ray) -> Option<Real> {
        Some((self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal))
    }

    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Surface {
        level(ray, t, self.point, self.normal)
    }
}

/// The surface where the ray is at `t`, moved onto the plane through `point` upright on `normal`.
pub(super) fn level(ray: &Ray, t: Real, point: Vec3, normal: Vec3) -> Surface {
    let p = ray.at_from(t, point);
    let point_on = point + (p - normal * p.dot(normal));
    let error = (abs(point_on) + Vec3::splat(largest(p))) * gamma(12 + LEAVING);
    Surface::flat(point_on, error, normal)
}

/// How far off a point the plane upright on the normal of a corner is, on the side of the normals or
/// on the other; nothing when it lies below the point. The corner is seen from the point.
pub(super) fn above(corner: Vec3, normal: Vec3, outside: bool) -> Vec3 {
    let height = corner.dot(normal);
    if if outside { height > 0.0 } else { height < 0.0 } { normal * height } else { Vec3::ZERO }
}
