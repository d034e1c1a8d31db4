//! Checks of the fields of a scene.
//!
//! Not inlined: [`Scene::new`](super::Scene::new) calls them many times, where code size matters more than
//! time.

use super::{Field, FieldError};
use crate::math::{MAX_COORDINATE, Real, Rgb, Vec3, is_normalized, length};

/// The error for `field`, which has this value.
pub(super) fn error(field: Field, value: Real) -> FieldError {
    FieldError { field, value: single(value) }
}

/// The value as errors report it, in single precision.
#[allow(clippy::unnecessary_cast)] // in single precision
const fn single(value: Real) -> f32 {
    value as f32
}

/// Checks that `value` is in `low..=high`.
#[inline(never)]
pub(super) fn range(field: Field, value: Real, low: Real, high: Real) -> Result<(), FieldError> {
    if value >= low && value <= high { Ok(()) } else { Err(error(field, value)) }
}

/// Checks that every channel is in `0..=max`.
#[inline(never)]
pub(super) fn color(field: Field, color: Rgb, max: Real) -> Result<(), FieldError> {
    [color.r, color.g, color.b].into_iter().try_for_each(|channel| range(field, channel, 0.0, max))
}

/// Checks that every coordinate is in `-1e15..=1e15`.
#[inline(never)]
pub(super) fn point(field: Field, point: Vec3) -> Result<(), FieldError> {
    let coordinate = |x| range(field, x, -MAX_COORDINATE, MAX_COORDINATE);
    point.to_array().into_iter().try_for_each(coordinate)
}

/// Checks that `direction` is a unit vector.
#[inline(never)]
pub(super) fn direction(field: Field, direction: Vec3) -> Result<(), FieldError> {
    if is_normalized(direction) { Ok(()) } else { Err(error(field, length(direction))) }
}
