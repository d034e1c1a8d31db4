//! Ranges of the numbers that shapes are made of.

use super::fault::ShapeFault;
use crate::math::{FARTHEST, Real, Vec3, is_in_range, is_unit};

pub(super) fn validate_point(p: Vec3) -> Result<(), ShapeFault> {
    if is_in_range(p) { Ok(()) } else { Err(ShapeFault::Place) }
}

pub(super) fn validate_direction(n: Vec3) -> Result<(), ShapeFault> {
    if is_unit(n) { Ok(()) } else { Err(ShapeFault::NotUnit) }
}

pub(super) fn validate_radius(center: Vec3, radius: Real) -> Result<(), ShapeFault> {
    validate_point(center)?;
    if radius > 0.0 && radius <= FARTHEST { Ok(()) } else { Err(ShapeFault::Radius) }
}
