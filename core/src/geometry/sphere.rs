//! Sphere.
//!
//! The schoolbook discriminant loses all digits when the sphere is some thousand radii away.
//! Here it is taken from the foot of the perpendicular from the centre on the ray, where only
//! small numbers are left, and the roots without cancellation (Haines, Günther,
//! Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems 7).
//!
//! That costs about an eighth more instructions than the schoolbook's formula; `tests/HARD-CASES.md`
//! says what both make of hard rays.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::{Aabb, Ray, ShapeFault, Surface, check_radius};
use crate::math::{Real, Vec3, abs, gamma, sqrt, unit};

/// A full sphere; its normal points outward.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Sphere {
    /// The centre.
    pub center: Vec3,
    /// The radius, more than zero.
    pub radius: Real,
}

impl Sphere {
    pub(super) fn check(&self) -> Result<(), ShapeFault> {
        check_radius(self.center, self.radius)
    }

    pub(super) fn bounds(&self) -> Aabb {
        Aabb::round(self.center, Vec3::splat(self.radius))
    }

    #[inline]
    pub(super) fn hit(&self, ray: &Ray) -> Option<Real> {
        let o = ray.origin - self.center;
        let r2 = self.radius * self.radius;
        let b = -o.dot(ray.along);
        let c = o.dot(o) - r2;
        if b < 0.0 && c > 0.0 {
            return None; // outside, and going away
        }
        let foot = o + ray.along * (b / ray.square);
        let room = r2 - foot.dot(foot);
        if !(room >= 0.0) {
            return None;
        }
        let root = sqrt(ray.square * room);
        let t = if b >= 0.0 {
            let q = b + root;
            if c > 0.0 { c / q } else { q / ray.square }
        } else {
            c / (b - root)
        };
        Some(t * ray.scale)
    }

    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Surface {
        let normal = unit(ray.at_from(t, self.center)).unwrap_or(-ray.direction);
        let point = self.center + normal * self.radius;
        // The normal is off by four roundings, the product and the sum by one each; twice that
        // for the test that starts here, which subtracts the centre and squares again.
        let error = (abs(self.center) + Vec3::splat(self.radius)) * gamma(12);
        Surface::flat(point, error, normal)
    }
}
