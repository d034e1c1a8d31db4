//! Sphere.
//!
//! The textbook discriminant `b^2 - a c` loses all digits if the sphere is about a thousand radii away.
//! Here the discriminant is the squared radius minus the squared distance between the center and the ray,
//! which are small numbers, and the roots are computed without cancellation.
//!
//! Source: Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray
//! Tracing Gems, chapter 7.

use super::ranges::validate_radius;
use super::ray::OFFSET_ROUNDINGS;
use super::{Aabb, Ray, ShapeError, SurfaceInteraction};
use crate::math::{ROUNDOFF, Real, Vec3, abs, gamma, sqrt, try_normalize};

/// A solid sphere. Its normal points outward.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Sphere {
    /// Center, world space, coordinates in `-1e15..=1e15`.
    pub center: Vec3,
    /// Radius, in scene lengths, in `(0, 1e15]`.
    pub radius: Real,
}

impl Sphere {
    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        validate_radius(self.center, self.radius)
    }

    pub(super) fn bounds(&self) -> Aabb {
        Aabb::from_center(self.center, Vec3::splat(self.radius))
    }

    #[inline]
    pub(super) fn intersect(&self, ray: &Ray) -> Option<Real> {
        let o = ray.origin - self.center;
        let r2 = self.radius * self.radius;
        let b = -o.dot(ray.scaled_direction);
        let distance_squared = o.dot(o);
        // Early out if even the textbook discriminant is negative by more than its rounding error, which
        // is less than 20 roundoffs of `distance_squared`. Most rays miss most spheres.
        if (distance_squared * (1.0 - 24.0 * ROUNDOFF) - r2) * ray.scaled_length_squared > b * b {
            return None;
        }
        let c = distance_squared - r2;
        if b < 0.0 && c > 0.0 {
            return None; // outside the sphere, and moving away from it
        }
        // From the center to the closest point of the ray's line.
        let perpendicular = o + ray.scaled_direction * (b / ray.scaled_length_squared);
        let remainder = r2 - perpendicular.dot(perpendicular);
        if !(remainder >= 0.0) {
            return None;
        }
        let root = sqrt(ray.scaled_length_squared * remainder);
        let t = if b >= 0.0 {
            let q = b + root;
            if c > 0.0 { c / q } else { q / ray.scaled_length_squared }
        } else {
            c / (b - root)
        };
        Some(t * ray.direction_scale)
    }

    /// Whether the hit at `t` is certainly inside the bounds of the sphere, so that clamping `t` to the
    /// bounds would not change it. This test is cheaper than the clamp and true for nearly all hits. It
    /// may be false for a hit inside the bounds.
    ///
    /// Each component of the hit point relative to the center, and the `t` of each face of the box, carry
    /// three roundings of numbers of at most `2 t + 2 r`, for directions whose components are at most 2.
    /// 16 roundoffs of `t + r` are more than all of these.
    #[inline(always)]
    pub(super) fn is_certainly_in_bounds(&self, ray: &Ray, t: Real) -> bool {
        let p = ray.at_relative_to(t, self.center);
        let limit = self.radius - (t + self.radius) * (16.0 * ROUNDOFF);
        // With another scale, `t` may carry one more rounding.
        ray.direction_scale == 1.0 && p.x.abs() < limit && p.y.abs() < limit && p.z.abs() < limit
    }

    #[inline(always)]
    pub(super) fn surface_interaction(&self, ray: &Ray, t: Real) -> SurfaceInteraction {
        let normal = try_normalize(ray.at_relative_to(t, self.center)).unwrap_or(-ray.direction);
        let point = self.center + normal * self.radius;
        // The normal carries four roundings, the product and the sum one each. This is doubled for the
        // test of the next ray, which subtracts the center and squares again.
        let error = (abs(self.center) + Vec3::splat(self.radius)) * gamma(12 + OFFSET_ROUNDINGS);
        SurfaceInteraction::with_geometric_normal(point, error, normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::clamp::{clamp_to_box, is_valid_t};
    use crate::math::{Dimension, SobolSequence, vec3};

    #[test]
    fn hits_certainly_in_bounds_are_unchanged_by_the_clamp() {
        let random = |n: u32, max: Real| {
            let [x, y] = SobolSequence::new(n, 1, 0, 7).sample_2d(Dimension::PIXEL);
            let [z, _] = SobolSequence::new(n, 2, 0, 7).sample_2d(Dimension::PIXEL);
            (vec3(x, y, z) - Vec3::splat(0.5)) * (2.0 * max)
        };
        let (mut certain, mut hits) = (0, 0);
        for n in 0..20_000 {
            // Origins up to some thousand radii away. Every second ray hits near a pole, where sphere and
            // box touch.
            let radius = [1.0, 1e-3, 50.0][n as usize % 3];
            let center = random(4 * n, 10.0);
            let target = if n % 2 == 0 { random(4 * n + 1, 1.0) } else { Vec3::X + random(4 * n + 1, 1e-3) };
            let Some(target) = try_normalize(target) else { continue };
            let origin =
                center + random(4 * n + 2, 1.0) * (radius * [2.0, 100.0, 1000.0][n as usize / 3 % 3]);
            let Some(direction) = try_normalize(center + target * radius - origin) else { continue };
            let (sphere, ray) =
                (Sphere { center, radius }, Ray::with_near_unit_direction(origin, direction, 0.0));
            let Some(t) = sphere.intersect(&ray).filter(is_valid_t) else { continue };
            hits += 1;
            if sphere.is_certainly_in_bounds(&ray, t) {
                certain += 1;
                assert_eq!(
                    clamp_to_box(sphere.bounds(), t, origin, ray.inverse_direction),
                    Some(t),
                    "{sphere:?} {ray:?}"
                );
            }
        }
        assert!(hits > 15_000 && certain * 2 > hits, "{certain} of {hits}");
    }
}
