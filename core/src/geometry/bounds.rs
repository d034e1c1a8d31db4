//! Boxes, and the conservative test of a ray against one.
//!
//! The test is the promise on which every accelerator rests: it never misses a box that the
//! exact ray meets, and a box round another box never begins later or ends earlier. Both hold
//! because each step is monotone in floating point, and because the far end is widened by the
//! worst rounding of both ends ("Robust BVH Ray Traversal", Ize, JCGT 2013).

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::ray::Ray;
use crate::math::{Real, Vec3, abs, gamma, vec3};

/// How much the far end of a box's interval is widened.
///
/// A wall's distance takes a subtraction, a reciprocal and a product: three roundings. If
/// near and far wall touch, the computed far end may lie below the near one by
/// `(1 + gamma(3)) / (1 - gamma(3))`, about 6 roundoffs; two more pay for this product.
pub(crate) const WIDEN: Real = 1.0 + 4.0 * Real::EPSILON;

/// A box with its faces upright on the axes; it contains its faces.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Aabb {
    /// The smallest coordinates.
    pub min: Vec3,
    /// The largest coordinates.
    pub max: Vec3,
}

/// The part of a ray that lies in a box, widened by rounding: `entry <= exit`, `exit >= 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Where the ray comes in; negative or zero when it starts inside.
    pub entry: Real,
    /// Where it goes out.
    pub exit: Real,
}

impl Aabb {
    /// The box of nothing: no ray meets it, and joined with another box it changes nothing.
    pub const EMPTY: Aabb = Aabb { min: Vec3::splat(Real::INFINITY), max: Vec3::splat(Real::NEG_INFINITY) };

    /// The box of the origin alone.
    #[cfg(not(feature = "double"))]
    pub(crate) const POINT: Aabb = Aabb { min: Vec3::ZERO, max: Vec3::ZERO };

    /// Whether it is the box of something, and no difference of its coordinates is infinite.
    #[cfg(not(feature = "double"))]
    pub(crate) fn is_finite(&self) -> bool {
        const FARTHEST_FACE: Real = Real::MAX / 8.0;
        let within =
            |v: Vec3| v.x.abs() <= FARTHEST_FACE && v.y.abs() <= FARTHEST_FACE && v.z.abs() <= FARTHEST_FACE;
        within(self.min) && within(self.max) && !self.is_empty()
    }

    /// The smallest box round some points.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |all, p| all.union(Aabb { min: p, max: p }))
    }

    /// The smallest box round some points, also in constants.
    pub const fn of_points(mut points: &[Vec3]) -> Self {
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

    /// The box of everything within `reach` of `center` along each axis, rounded outward.
    pub fn round(center: Vec3, reach: Vec3) -> Self {
        // Two roundings for the reach, one for the sum, and three for what makes up for them.
        let margin = reach * (1.0 + gamma(6)) + abs(center) * gamma(2);
        Aabb { min: center - margin, max: center + margin }
    }

    /// The smallest box round both.
    pub fn union(self, other: Self) -> Self {
        let low = |a: Real, b: Real| if a < b { a } else { b };
        let high = |a: Real, b: Real| if a > b { a } else { b };
        let (a, b) = (self, other);
        Aabb {
            min: vec3(low(a.min.x, b.min.x), low(a.min.y, b.min.y), low(a.min.z, b.min.z)),
            max: vec3(high(a.max.x, b.max.x), high(a.max.y, b.max.y), high(a.max.z, b.max.z)),
        }
    }

    /// Whether nothing is inside.
    pub fn is_empty(&self) -> bool {
        !(self.min.x <= self.max.x && self.min.y <= self.max.y && self.min.z <= self.max.z)
    }

    /// The part of the ray inside the box; none when the box lies beside or behind it.
    ///
    /// A component of the direction that is zero makes the distance of a wall infinite, or NaN
    /// when the ray starts in that very wall. Comparisons with NaN are false, and they are
    /// written so that false leaves the interval as it was: such a ray is inside that slab.
    #[inline]
    pub fn span(&self, ray: &Ray) -> Option<Span> {
        self.span_along(ray.origin, ray.inverse)
    }

    /// [`Aabb::span`] of a ray in parts.
    #[inline(always)]
    pub(super) fn span_along(&self, origin: Vec3, inverse: Vec3) -> Option<Span> {
        let low = (self.min - origin) * inverse;
        let high = (self.max - origin) * inverse;
        let order = |inverse: Real, a: Real, b: Real| if inverse >= 0.0 { (a, b) } else { (b, a) };
        let (x, y, z) = (
            order(inverse.x, low.x, high.x),
            order(inverse.y, low.y, high.y),
            order(inverse.z, low.z, high.z),
        );
        let mut entry = Real::NEG_INFINITY;
        let mut exit = Real::MAX;
        for (near, far) in [x, y, z] {
            entry = if near > entry { near } else { entry };
            exit = if far < exit { far } else { exit };
        }
        let exit = exit * WIDEN;
        (entry <= exit && exit >= 0.0 && entry <= Real::MAX).then_some(Span { entry, exit })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Aabb = Aabb { min: Vec3::ZERO, max: Vec3::ONE };

    fn span(origin: [f32; 3], direction: [f32; 3]) -> Option<(Real, Real)> {
        let v = |a: [f32; 3]| vec3(a[0] as Real, a[1] as Real, a[2] as Real);
        UNIT.span(&Ray::new(v(origin), v(direction))).map(|s| (s.entry, s.exit))
    }

    #[test]
    fn a_ray_through_the_box_is_inside_between_its_faces() {
        let (entry, exit) = span([-1.0, 0.5, 0.5], [1.0, 0.0, 0.0]).unwrap();
        assert_eq!(entry, 1.0);
        assert!(exit >= 2.0 && exit <= 2.0 * WIDEN);
    }

    #[test]
    fn a_box_behind_or_beside_is_missed() {
        assert_eq!(span([2.0, 0.5, 0.5], [1.0, 0.0, 0.0]), None);
        assert_eq!(span([-1.0, 1.5, 0.5], [1.0, 0.0, -0.0]), None);
        assert_eq!(span([-1.0, -0.5, 0.5], [1.0, -0.0, 0.0]), None);
    }

    #[test]
    fn a_ray_in_a_face_is_inside_whatever_the_sign_of_zero() {
        for zero in [0.0, -0.0] {
            for wall in [0.0, 1.0] {
                assert!(span([-1.0, wall, 0.5], [1.0, zero, zero]).is_some(), "{wall} {zero}");
                assert!(span([-1.0, wall, wall], [1.0, zero, zero]).is_some(), "{wall} {zero}");
            }
        }
    }

    #[test]
    fn a_flat_box_is_met_at_its_only_wall() {
        let flat = Aabb { min: vec3(0.0, 0.0, 0.3), max: vec3(1.0, 1.0, 0.3) };
        let ray = Ray::new(vec3(0.2, 0.3, -0.7), vec3(0.1, 0.2, 0.9));
        let span = flat.span(&ray).unwrap();
        assert!(span.entry <= span.exit && (span.entry - 1.0 / 0.9).abs() < 1e-6);
    }

    #[test]
    fn the_box_of_nothing_is_met_by_no_ray() {
        assert!(Aabb::EMPTY.is_empty() && Aabb::EMPTY.span(&Ray::new(Vec3::ZERO, Vec3::X)).is_none());
        assert_eq!(Aabb::EMPTY.union(UNIT), UNIT);
    }
}
