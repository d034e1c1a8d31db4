//! Motion blur: shapes that move while the shutter is open.
//!
//! A ray hits a translated shape exactly as the ray translated back hits the shape at rest. So a moving
//! shape stores a static shape and its offsets when the shutter opens and closes, and only the origin of
//! the ray changes before the intersection test. Accelerators use the bounds of the whole motion.
//!
//! Source: Cook, Porter and Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984 (a time for each ray).

use super::ranges::validate_point;
use super::{Aabb, Ray, Shape, ShapeError};
use crate::math::{Real, Vec3, abs, clamp, gamma};

/// A shape that moves along a straight line at constant speed while the shutter is open.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct MovingShape {
    /// The shape at rest; not a moving shape itself.
    pub shape: Shape,
    /// Offset from the shape at rest when the shutter opens, in scene lengths.
    pub offset_at_open: Vec3,
    /// Offset from the shape at rest when the shutter closes, in scene lengths.
    pub offset_at_close: Vec3,
}

impl MovingShape {
    /// Offset from the shape at rest at `time`, in scene lengths: interpolated between `offset_at_open` at
    /// 0 and `offset_at_close` at 1. Times outside of `0..=1` are clamped.
    pub fn offset_at(&self, time: Real) -> Vec3 {
        self.offset_at_open + (self.offset_at_close - self.offset_at_open) * clamp(time, 0.0, 1.0)
    }

    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        if let Shape::Moving(_) = self.shape {
            return Err(ShapeError::NestedMotion);
        }
        validate_point(self.offset_at_open)?;
        validate_point(self.offset_at_close)
    }

    /// The ray in the frame of the shape at rest.
    pub(super) fn ray_at_rest(&self, ray: &Ray) -> Ray {
        Ray { origin: ray.origin - self.offset_at(ray.time), ..*ray }
    }

    /// Bounds of the whole motion, rounded outward. `rest`: bounds of the shape at rest.
    pub(super) fn swept_bounds(&self, rest: Aabb) -> Aabb {
        let at = |offset: Vec3| {
            // The sum takes one rounding, the interpolated offset three. The rest of both bounds covers the
            // roundings of the margin itself.
            let margin = (abs(rest.min) + abs(rest.max)) * gamma(2)
                + (abs(self.offset_at_open) + abs(self.offset_at_close)) * gamma(6);
            Aabb { min: rest.min + offset - margin, max: rest.max + offset + margin }
        };
        at(self.offset_at_open).union(at(self.offset_at_close))
    }
}
