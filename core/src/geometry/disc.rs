//! Disc: the part of a plane within a radius.
//!
//! The distance to the edge is computed relative to the ray's origin: the coordinates of the hit point are
//! coarse far from the world's origin.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::plane::level;
use super::{Aabb, Ray, ShapeFault, Surface, check_radius, check_unit};
use crate::math::{Real, Vec3, sqrt};

/// A flat round disc.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Disc {
    /// The centre.
    pub center: Vec3,
    /// Upright on it, of length one.
    pub normal: Vec3,
    /// The radius, more than zero.
    pub radius: Real,
}

impl Disc {
    pub(super) fn check(&self) -> Result<(), ShapeFault> {
        check_radius(self.center, self.radius)?;
        check_unit(self.normal)
    }

    pub(super) fn bounds(&self) -> Aabb {
        Aabb::round(self.center, disc_reach(self.normal, self.radius))
    }

    pub(super) fn hit(&self, ray: &Ray) -> Option<Real> {
        let o = self.center - ray.origin;
        let t = o.dot(self.normal) / ray.direction.dot(self.normal);
        let p = ray.direction * t - o;
        (p.dot(p) <= self.radius * self.radius).then_some(t)
    }

    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Surface {
        level(ray, t, self.center, self.normal)
    }
}

/// How far a disc upright on `normal` reaches along each axis: `r sqrt(1 - n^2)`.
///
/// Written with the two other components, so that nothing cancels: a disc upright on an axis is
/// exactly flat.
pub(super) fn disc_reach(normal: Vec3, radius: Real) -> Vec3 {
    let square = normal * normal;
    let all = normal.dot(normal);
    let reach = |others: Real| radius * sqrt(others / all);
    Vec3::new(reach(square.y + square.z), reach(square.z + square.x), reach(square.x + square.y))
}
