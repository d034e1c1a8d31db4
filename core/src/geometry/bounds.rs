//! Axis-aligned bounding boxes and the conservative test of a ray against one.
//!
//! All accelerators rely on two guarantees: the test never misses a box that the exact ray hits, and the
//! interval of a box contains the interval of every box inside it. They hold because each operation is
//! monotone in floating point, and because the end of the interval is widened by the largest rounding error
//! of both ends.
//!
//! Sources: Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986 (slabs); Ize, "Robust BVH Ray
//! Traversal", JCGT 2013 (widening).

use super::ray::Ray;
use crate::math::{Real, Vec3, abs, gamma, vec3};

/// Factor by which the end of the interval of a box is widened.
///
/// The `t` of a face takes a subtraction, a reciprocal and a product: three roundings. If the exact values
/// of entry and exit are equal, the computed exit may be below the entry by the factor
/// `(1 + gamma(3)) / (1 - gamma(3))`, about 6 roundoffs. Two more cover the multiplication by this factor.
pub(crate) const WIDEN: Real = 1.0 + 4.0 * Real::EPSILON;

/// Largest absolute coordinate of bounds, so that no difference of two coordinates overflows.
pub(crate) const MAX_FACE_COORDINATE: Real = Real::MAX / 8.0;

/// An axis-aligned bounding box. It contains its faces.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
#[doc(alias = "bounding box")]
pub struct Aabb {
    /// Corner with the smallest coordinates.
    pub min: Vec3,
    /// Corner with the largest coordinates.
    pub max: Vec3,
}

/// The interval of `t` in which a ray is inside a box, widened for rounding errors: `t_entry <= t_exit`,
/// `t_exit >= 0`. In lengths of the ray's direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayInterval {
    /// Start of the interval; zero or negative if the ray starts inside.
    pub t_entry: Real,
    /// End of the interval.
    pub t_exit: Real,
}

impl Aabb {
    /// The empty box: never hit, neutral for [`Aabb::union`].
    pub const EMPTY: Aabb = Aabb { min: Vec3::splat(Real::INFINITY), max: Vec3::splat(Real::NEG_INFINITY) };

    /// The box that contains the origin only.
    #[cfg(feature = "baked")]
    pub(crate) const ORIGIN: Aabb = Aabb { min: Vec3::ZERO, max: Vec3::ZERO };

    /// Whether the box is not empty and no difference of its coordinates overflows.
    #[cfg(feature = "baked")]
    pub(crate) fn is_finite(&self) -> bool {
        let is_in_range = |v: Vec3| {
            v.x.abs() <= MAX_FACE_COORDINATE
                && v.y.abs() <= MAX_FACE_COORDINATE
                && v.z.abs() <= MAX_FACE_COORDINATE
        };
        is_in_range(self.min) && is_in_range(self.max) && !self.is_empty()
    }

    /// The smallest box that contains all `points`; [`Aabb::EMPTY`] without points.
    pub fn enclosing(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |bounds, p| bounds.union(Aabb { min: p, max: p }))
    }

    /// The smallest box that contains all `points`, usable in constants; [`Aabb::EMPTY`] without points.
    pub const fn from_points(mut points: &[Vec3]) -> Self {
        const fn low(a: Real, b: Real) -> Real {
            if b < a { b } else { a }
        }
        const fn high(a: Real, b: Real) -> Real {
            if b > a { b } else { a }
        }
        let Aabb { mut min, mut max } = Self::EMPTY;
        while let Some((p, rest)) = points.split_first() {
            min = vec3(low(min.x, p.x), low(min.y, p.y), low(min.z, p.z));
            max = vec3(high(max.x, p.x), high(max.y, p.y), high(max.z, p.z));
            points = rest;
        }
        Aabb { min, max }
    }

    /// The box around `center` with the given half extent along each axis, rounded outward.
    pub fn from_center(center: Vec3, half_extent: Vec3) -> Self {
        // Two roundings for the half extent, one for the sum, and three for the margin itself.
        let margin = half_extent * (1.0 + gamma(6)) + abs(center) * gamma(2);
        Aabb { min: center - margin, max: center + margin }
    }

    /// The smallest box that contains both boxes.
    pub fn union(self, other: Self) -> Self {
        let low = |a: Real, b: Real| if a < b { a } else { b };
        let high = |a: Real, b: Real| if a > b { a } else { b };
        let (a, b) = (self, other);
        Aabb {
            min: vec3(low(a.min.x, b.min.x), low(a.min.y, b.min.y), low(a.min.z, b.min.z)),
            max: vec3(high(a.max.x, b.max.x), high(a.max.y, b.max.y), high(a.max.z, b.max.z)),
        }
    }

    /// Whether the box contains no point: `min` is above `max` in some coordinate, or a coordinate is NaN.
    pub fn is_empty(&self) -> bool {
        !(self.min.x <= self.max.x && self.min.y <= self.max.y && self.min.z <= self.max.z)
    }

    /// The interval in which the ray's line is inside the box; `None` if the ray misses the box or the box is
    /// behind its origin. It is not clipped: it begins before 0 if the origin is inside, and may end after any
    /// `t_max`.
    ///
    /// A zero component of the direction gives infinite `t` for both faces of that axis, or NaN if the ray
    /// lies in a face. Comparisons with NaN are false and then leave the interval unchanged, so such a ray
    /// is inside that slab.
    #[inline]
    pub fn intersect(&self, ray: &Ray) -> Option<RayInterval> {
        self.intersect_components(ray.origin, ray.inverse_direction)
    }

    /// [`Aabb::intersect`] of the ray with the given origin and reciprocal direction.
    #[inline(always)]
    pub(super) fn intersect_components(&self, origin: Vec3, inverse_direction: Vec3) -> Option<RayInterval> {
        let t_min_face = (self.min - origin) * inverse_direction;
        let t_max_face = (self.max - origin) * inverse_direction;
        let order = |inverse: Real, a: Real, b: Real| if inverse >= 0.0 { (a, b) } else { (b, a) };
        let (x, y, z) = (
            order(inverse_direction.x, t_min_face.x, t_max_face.x),
            order(inverse_direction.y, t_min_face.y, t_max_face.y),
            order(inverse_direction.z, t_min_face.z, t_max_face.z),
        );
        let mut entry = Real::NEG_INFINITY;
        let mut exit = Real::MAX;
        for (t_near, t_far) in [x, y, z] {
            entry = if t_near > entry { t_near } else { entry };
            exit = if t_far < exit { t_far } else { exit };
        }
        let exit = exit * WIDEN;
        (entry <= exit && exit >= 0.0 && entry <= Real::MAX)
            .then_some(RayInterval { t_entry: entry, t_exit: exit })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Aabb = Aabb { min: Vec3::ZERO, max: Vec3::ONE };

    fn unit_cube_interval(origin: [f32; 3], direction: [f32; 3]) -> Option<(Real, Real)> {
        let v = |a: [f32; 3]| vec3(a[0] as Real, a[1] as Real, a[2] as Real);
        UNIT.intersect(&Ray::new(v(origin), v(direction))).map(|interval| (interval.t_entry, interval.t_exit))
    }

    #[test]
    fn a_ray_through_the_box_is_inside_between_its_faces() {
        let (entry, exit) = unit_cube_interval([-1.0, 0.5, 0.5], [1.0, 0.0, 0.0]).unwrap();
        assert_eq!(entry, 1.0);
        assert!(exit >= 2.0 && exit <= 2.0 * WIDEN);
    }

    #[test]
    fn a_box_behind_or_beside_is_missed() {
        assert_eq!(unit_cube_interval([2.0, 0.5, 0.5], [1.0, 0.0, 0.0]), None);
        assert_eq!(unit_cube_interval([-1.0, 1.5, 0.5], [1.0, 0.0, -0.0]), None);
        assert_eq!(unit_cube_interval([-1.0, -0.5, 0.5], [1.0, -0.0, 0.0]), None);
    }

    #[test]
    fn a_ray_in_a_face_is_inside_whatever_the_sign_of_zero() {
        for zero in [0.0, -0.0] {
            for face in [0.0, 1.0] {
                assert!(unit_cube_interval([-1.0, face, 0.5], [1.0, zero, zero]).is_some(), "{face} {zero}");
                assert!(unit_cube_interval([-1.0, face, face], [1.0, zero, zero]).is_some(), "{face} {zero}");
            }
        }
    }

    #[test]
    fn a_flat_box_is_hit_at_its_plane() {
        let flat = Aabb { min: vec3(0.0, 0.0, 0.3), max: vec3(1.0, 1.0, 0.3) };
        let ray = Ray::new(vec3(0.2, 0.3, -0.7), vec3(0.1, 0.2, 0.9));
        let interval = flat.intersect(&ray).unwrap();
        assert!(interval.t_entry <= interval.t_exit && (interval.t_entry - 1.0 / 0.9).abs() < 1e-6);
    }

    #[test]
    fn the_empty_box_is_never_hit() {
        assert!(Aabb::EMPTY.is_empty() && Aabb::EMPTY.intersect(&Ray::new(Vec3::ZERO, Vec3::X)).is_none());
        assert_eq!(Aabb::EMPTY.union(UNIT), UNIT);
    }
}
