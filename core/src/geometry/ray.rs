//! Rays, and how one leaves a surface.

use crate::math::{Axis, Real, Vec3, abs, largest, power_of_two, vec3};

/// A half-line from `origin` along `direction`, and what every test of it needs.
///
/// Distances along it (`t`) count in lengths of `direction`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes, of any length; the tracer's own have length one.
    pub direction: Vec3,
    /// One over each component of the direction; infinite where that is zero, with its sign.
    pub inverse: Vec3,
    /// When: 0 where the shutter opens, 1 where it closes. Only what moves asks.
    pub time: Real,
    /// The axis along which the direction reaches farthest.
    pub axis: Axis,
    /// One over the component of the direction along `axis`.
    pub(super) third: Real,
    /// With [`Ray::upward`], what shows a place as the ray sees it: two of its coordinates, less
    /// what the ray itself moves along them on the way there.
    pub(super) across: Vec3,
    pub(super) upward: Vec3,
    /// The direction times `scale`, about one long: its square is in range, however long the
    /// direction is.
    pub(super) along: Vec3,
    /// The square of the length of `along`; no number when the ray meets nothing.
    pub(super) square: Real,
    /// A power of two.
    pub(super) scale: Real,
}

impl Ray {
    /// The ray from `origin` along `direction`, at the time 0. It meets nothing when one of both is not finite,
    /// or when the direction is zero or so short that one over it is not finite.
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        let ray = Self::scaled(origin, direction, 1.0 / power_of_two(largest(direction)), 0.0);
        // Nothing of what is finite, and no number of what is not.
        let nothing = origin.dot(Vec3::ZERO) + ray.third * 0.0;
        Ray { square: ray.square + nothing, ..ray }
    }

    /// The same ray for less work, where the direction is about one long: between a half and two.
    pub(crate) fn near_unit(origin: Vec3, direction: Vec3, time: Real) -> Self {
        debug_assert!(origin.is_finite() && largest(direction) > 0.25 && largest(direction) <= 2.0);
        Self::scaled(origin, direction, 1.0, time)
    }

    /// Inlined, so that what no shape of the tracer asks for is not made.
    #[inline(always)]
    fn scaled(origin: Vec3, direction: Vec3, scale: Real, time: Real) -> Self {
        let inverse = 1.0 / direction;
        let axis = Axis::largest_of(direction);
        let (turned, third) = (axis.to_third(direction), axis.to_third(inverse).z);
        let along = direction * scale;
        Ray {
            origin,
            direction,
            inverse,
            time,
            axis,
            third,
            across: axis.place_back(vec3(1.0, 0.0, -(turned.x * third))),
            upward: axis.place_back(vec3(0.0, 1.0, -(turned.y * third))),
            along,
            square: along.dot(along),
            scale,
        }
    }

    /// The same ray at another time.
    #[inline(always)]
    pub fn at_time(self, time: Real) -> Self {
        Ray { time, ..self }
    }

    /// Whether it can meet anything.
    pub(crate) fn is_sound(&self) -> bool {
        self.square > 0.0
    }

    /// The point `t` lengths of the direction away.
    pub fn at(&self, t: Real) -> Vec3 {
        self.origin + self.direction * t
    }

    /// The same, seen from `center`. Subtracted first, so that the error follows the distance
    /// between both and not their place.
    pub(super) fn at_from(&self, t: Real, center: Vec3) -> Vec3 {
        (self.origin - center) + self.direction * t
    }
}

/// The place near `point` from which a ray leaves a surface to the side of `normal`.
///
/// `point` lies on the surface to within `error` (a bound for each component); `normal` has
/// length one and points to the side that the ray goes to. The place certainly lies on that
/// side: it is moved along the normal just far enough to leave the box that the error spans.
/// No constant here has a unit, the step follows from the error alone ("Physically Based
/// Rendering", Pharr, Jakob, Humphreys, 6.8).
///
/// Differs from it: the place is not rounded away from the surface. What rounding takes from
/// the step is a roundoff of each component of the place, and `error` holds two for it, as that
/// of a [`Surface`](super::Surface) does.
#[inline(always)]
pub fn leave(point: Vec3, error: Vec3, normal: Vec3) -> Vec3 {
    point + normal * abs(normal).dot(error)
}

/// The roundings that the error of a surface holds for whoever leaves it.
pub(super) const LEAVING: u32 = 2;
