//! The range of a hit: positive, finite, and inside the bounds of the shape.

use super::bounds::Aabb;
use crate::math::{Real, Vec3};

/// Whether `t` can be a hit: positive and finite.
pub(super) fn is_valid_t(t: &Real) -> bool {
    *t > 0.0 && *t <= Real::MAX
}

/// `t` clamped to the interval in which the ray is inside the box. `None` if there is no such interval, or
/// if the result is not a valid hit.
#[inline(always)]
pub(super) fn clamp_to_box(aabb: Aabb, t: Real, origin: Vec3, inverse_direction: Vec3) -> Option<Real> {
    let interval = aabb.intersect_components(origin, inverse_direction)?;
    let t = if t < interval.t_entry { interval.t_entry } else { t };
    let t = if t > interval.t_exit { interval.t_exit } else { t };
    Some(t).filter(is_valid_t)
}
