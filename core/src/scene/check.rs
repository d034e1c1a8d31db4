//! Checks of the fields of a scene.
//!
//! [`Scene::new`](super::Scene::new) checks many fields once, so code size matters more than time: the checks
//! are not inlined, and none returns early.

use super::{Field, FieldError};
use crate::math::{MAX_COORDINATE, Real, Rgb, Vec3, is_normalized, length};

/// Checks fields one after the other and keeps the first error.
pub(super) struct FieldChecks {
    first_error: Option<FieldError>,
}

impl FieldChecks {
    /// Runs `checks`: the first error, if any.
    pub(super) fn run(checks: impl FnOnce(&mut Self)) -> Result<(), FieldError> {
        let mut fields = FieldChecks { first_error: None };
        checks(&mut fields);
        fields.first_error.map_or(Ok(()), Err)
    }

    /// Checks that `is_valid`; otherwise `value` is that of the error.
    #[inline(never)]
    #[allow(clippy::unnecessary_cast)] // in single precision
    pub(super) fn require(&mut self, field: Field, value: Real, is_valid: bool) {
        if !is_valid && self.first_error.is_none() {
            self.first_error = Some(FieldError { field, value: value as f32 });
        }
    }

    /// Checks that `value` is in `low..=high`.
    #[inline(never)]
    pub(super) fn range(&mut self, field: Field, value: Real, low: Real, high: Real) {
        self.require(field, value, value >= low && value <= high);
    }

    /// Checks that every channel is in `0..=max`.
    #[inline(never)]
    pub(super) fn color(&mut self, field: Field, color: &Rgb, max: Real) {
        for channel in [color.r, color.g, color.b] {
            self.range(field, channel, 0.0, max);
        }
    }

    /// Checks that every coordinate is in `-1e15..=1e15`.
    #[inline(never)]
    pub(super) fn point(&mut self, field: Field, point: &Vec3) {
        for coordinate in point.to_array() {
            self.range(field, coordinate, -MAX_COORDINATE, MAX_COORDINATE);
        }
    }

    /// Checks that `direction` is a unit vector.
    #[inline(never)]
    pub(super) fn direction(&mut self, field: Field, direction: &Vec3) {
        self.require(field, length(*direction), is_normalized(*direction));
    }
}
