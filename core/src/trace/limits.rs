//! How far the tree of rays is to go.

use crate::math::Real;

/// Which picture is wanted: how far the tree of rays goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Levels of rays: 1 is the camera ray alone.
    pub levels: u8,
    /// A ray is sent when its weight in the brightest channel is more than this, in `0..=1`.
    pub cutoff: Real,
}

impl Limits {
    /// Five levels, and what could make half a step of an 8-bit picture.
    pub const DEFAULT: Limits = Limits { levels: 5, cutoff: 1.0 / 512.0 };
}
