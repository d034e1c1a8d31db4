//! Validation of the numbers of a shape: points, directions and radii.

use super::error::ShapeError;
use crate::math::{MAX_COORDINATE, Real, Vec3, is_in_range, is_normalized};

/// Checks that every coordinate is finite and at most [`MAX_COORDINATE`].
pub(super) fn validate_point(p: Vec3) -> Result<(), ShapeError> {
    if is_in_range(p) { Ok(()) } else { Err(ShapeError::Coordinate) }
}

/// Checks that a normal or an axis is a unit vector.
pub(super) fn validate_direction(n: Vec3) -> Result<(), ShapeError> {
    if is_normalized(n) { Ok(()) } else { Err(ShapeError::NotNormalized) }
}

/// Checks a center, and that the radius is positive and at most [`MAX_COORDINATE`].
pub(super) fn validate_radius(center: Vec3, radius: Real) -> Result<(), ShapeError> {
    validate_point(center)?;
    if radius > 0.0 && radius <= MAX_COORDINATE { Ok(()) } else { Err(ShapeError::Radius) }
}
