//! Sphere.
//!
//! The schoolbook discriminant loses all digits when the sphere is some thousand radii away.
//! Here it is taken from the foot of the perpendicular from the centre on the ray, where only
//! small numbers are left, and the roots without cancellation (Haines, Günther,
//! Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems 7).

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::{Aabb, Ray, ShapeFault, Surface, check_radius, ray::LEAVING};
use crate::math::{ROUNDOFF, Real, Vec3, abs, gamma, sqrt, unit};

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
        let far = o.dot(o);
        // The schoolbook's discriminant, where it is below zero by more than its own rounding: most
        // spheres are missed by far. It carries less than 20 roundoffs of `far`.
        if (far * (1.0 - 24.0 * ROUNDOFF) - r2) * ray.square > b * b {
            return None;
        }
        let c = far - r2;
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

    /// Whether a hit lies so far inside the sphere's own box that the distance need not be moved
    /// into it: this is the shorter question, and nearly always answered with yes. It may be
    /// answered with no where yes would be right.
    ///
    /// Of the point `p` seen from the centre, each component carries three roundings and the
    /// distance of a wall three, each of what is at most `2 t + 2 r` large along a direction
    /// whose components are at most two: 16 roundoffs are more than all of them.
    #[inline(always)]
    pub(super) fn is_surely_in_its_box(&self, ray: &Ray, t: Real) -> bool {
        let p = ray.at_from(t, self.center);
        let room = self.radius - (t + self.radius) * (16.0 * ROUNDOFF);
        // Other scales may have rounded the distance again.
        ray.scale == 1.0 && p.x.abs() < room && p.y.abs() < room && p.z.abs() < room
    }

    #[inline(always)]
    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Surface {
        let normal = unit(ray.at_from(t, self.center)).unwrap_or(-ray.direction);
        let point = self.center + normal * self.radius;
        // The normal is off by four roundings, the product and the sum by one each; twice that
        // for the test that starts here, which subtracts the centre and squares again.
        let error = (abs(self.center) + Vec3::splat(self.radius)) * gamma(12 + LEAVING);
        Surface::flat(point, error, normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::meet::{is_distance, moved_into};
    use crate::math::{Dimension, Stream, vec3};

    #[test]
    fn what_is_surely_in_the_box_of_a_sphere_is_not_moved_into_it() {
        let random = |n: u32, most: Real| {
            let [x, y] = Stream::new(n, 1, 0, 7).pair(Dimension::PIXEL);
            let [z, _] = Stream::new(n, 2, 0, 7).pair(Dimension::PIXEL);
            (vec3(x, y, z) - Vec3::splat(0.5)) * (2.0 * most)
        };
        let (mut sure, mut met) = (0, 0);
        for n in 0..20_000 {
            // From near by to a thousand radii away, and at every pole where sphere and box touch.
            let radius = [1.0, 1e-3, 50.0][n as usize % 3];
            let center = random(4 * n, 10.0);
            let aside = if n % 2 == 0 { random(4 * n + 1, 1.0) } else { Vec3::X + random(4 * n + 1, 1e-3) };
            let Some(aside) = unit(aside) else { continue };
            let origin =
                center + random(4 * n + 2, 1.0) * (radius * [2.0, 100.0, 1000.0][n as usize / 3 % 3]);
            let Some(direction) = unit(center + aside * radius - origin) else { continue };
            let (sphere, ray) = (Sphere { center, radius }, Ray::near_unit(origin, direction, 0.0));
            let Some(t) = sphere.hit(&ray).filter(is_distance) else { continue };
            met += 1;
            if sphere.is_surely_in_its_box(&ray, t) {
                sure += 1;
                assert_eq!(
                    moved_into(sphere.bounds(), t, origin, ray.inverse),
                    Some(t),
                    "{sphere:?} {ray:?}"
                );
            }
        }
        assert!(met > 15_000 && sure * 2 > met, "{sure} of {met}");
    }
}
