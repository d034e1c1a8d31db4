//! Bounding spheres of boxes, and a conservative test whether a ray hits one.
//!
//! A bounding sphere of an elongated item encloses much empty space. A bounding box encloses less and is
//! hardly more expensive to test. The spheres exist for comparison.
//!
//! Source: Rubin and Whitted, "A 3-Dimensional Representation for Fast Rendering of Complex Scenes",
//! SIGGRAPH 1980, discuss both.

use super::bounds::Aabb;
use super::ray::Ray;
use crate::math::{Real, Vec3, abs, gamma, length, sqrt};

/// A sphere that contains the bounding box of an item or group, for
/// [`List::with_spheres`](crate::accel::List::with_spheres).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundingSphere {
    center: Vec3,
    /// Negative for the empty sphere.
    radius: Real,
}

/// A ray with values precomputed for tests of bounding spheres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoundingSphereRay<'r> {
    ray: &'r Ray,
    /// Reciprocal of the squared length of the scaled direction.
    inverse_length_squared: Real,
    /// Reciprocal of the length of the scaled direction.
    inverse_length: Real,
}

impl<'r> BoundingSphereRay<'r> {
    /// Prepares `ray` for tests of many spheres.
    pub(crate) fn new(ray: &'r Ray) -> Self {
        BoundingSphereRay {
            ray,
            inverse_length_squared: 1.0 / ray.scaled_length_squared,
            inverse_length: 1.0 / sqrt(ray.scaled_length_squared),
        }
    }
}

impl BoundingSphere {
    /// The empty sphere: never hit. The initial value for buffers.
    pub const EMPTY: BoundingSphere = BoundingSphere { center: Vec3::ZERO, radius: -1.0 };

    /// The bounding sphere of a box, rounded outward.
    pub(crate) fn of_box(aabb: &Aabb) -> Self {
        if aabb.is_empty() {
            return BoundingSphere::EMPTY;
        }
        let center = (aabb.min + aabb.max) * 0.5;
        // The distance from the rounded center to the farthest corner.
        let corner = (aabb.max - center).max(center - aabb.min);
        BoundingSphere { center, radius: length(corner) * (1.0 + gamma(8)) }
    }

    /// Whether the ray enters the sphere at `t_max` or before, in lengths of its direction.
    ///
    /// It is true if [`Aabb::intersect`] of the enclosed box begins at `t_max` or before: the margin of the
    /// radius covers the rounding errors of both tests, which are relative to the distance from the ray's
    /// origin.
    #[inline]
    pub(crate) fn is_hit(&self, prepared: &BoundingSphereRay<'_>, t_max: Real) -> bool {
        let ray = prepared.ray;
        let to_center = self.center - ray.origin;
        let t_center = to_center.dot(ray.scaled_direction) * prepared.inverse_length_squared;
        let perpendicular = to_center - ray.scaled_direction * t_center;
        let distance = abs(to_center);
        let radius = self.radius + (self.radius + distance.x + distance.y + distance.z) * gamma(32);
        let half_chord = radius * prepared.inverse_length;
        // NaN counts as a hit.
        let misses = self.radius < 0.0
            || perpendicular.dot(perpendicular) > radius * radius
            || t_center + half_chord < 0.0
            || (t_center - half_chord) * ray.direction_scale > t_max * (1.0 + gamma(8));
        !misses
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    /// Whether a ray hits the cube from -1 to 1, and whether it hits the bounding sphere of this cube.
    fn hits(origin: Vec3, direction: Vec3, t_max: Real) -> [bool; 2] {
        let cube = Aabb { min: Vec3::splat(-1.0), max: Vec3::ONE };
        let ray = Ray::new(origin, direction);
        let hits_box = cube.intersect(&ray).is_some_and(|interval| interval.t_entry <= t_max);
        [hits_box, BoundingSphere::of_box(&cube).is_hit(&BoundingSphereRay::new(&ray), t_max)]
    }

    #[test]
    fn a_ray_that_starts_inside_a_volume_hits() {
        assert_eq!(hits(vec3(0.5, 0.0, 0.0), Vec3::X, 100.0), [true; 2]);
        assert_eq!(hits(vec3(0.5, 0.0, 0.0), Vec3::X, 0.1), [true; 2], "and ends inside");
    }

    #[test]
    fn a_ray_that_ends_inside_a_volume_hits() {
        assert_eq!(hits(vec3(-5.0, 0.1, 0.2), Vec3::X, 5.0), [true; 2]);
        assert_eq!(hits(vec3(-5.0, 0.1, 0.2), Vec3::X * 1e20, 5e-20), [true; 2], "long direction");
    }

    #[test]
    fn a_ray_that_passes_through_a_volume_hits() {
        assert_eq!(hits(vec3(-5.0, 0.1, 0.2), Vec3::X, 100.0), [true; 2]);
        assert_eq!(hits(vec3(-5.0, -5.0, -5.0), Vec3::ONE * 1e-20, Real::MAX), [true; 2], "short direction");
    }

    #[test]
    fn a_ray_beside_behind_or_beyond_t_max_misses() {
        assert_eq!(hits(vec3(-5.0, 2.0, 0.0), Vec3::X, 100.0), [false; 2], "beside");
        assert_eq!(hits(vec3(5.0, 0.0, 0.0), Vec3::X, 100.0), [false; 2], "behind");
        assert_eq!(hits(vec3(-5.0, 0.0, 0.0), Vec3::X, 2.0), [false; 2], "beyond t_max");
        assert_eq!(
            hits(vec3(-5.0, 1.2, 1.2), Vec3::X, 100.0),
            [false, true],
            "in the sphere, beside an edge of the cube"
        );
        assert!(!BoundingSphere::EMPTY.is_hit(&BoundingSphereRay::new(&Ray::new(Vec3::ZERO, Vec3::X)), 1.0));
    }
}
