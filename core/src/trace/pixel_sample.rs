//! The result of tracing a camera sample or a pixel.

use super::HitId;
use crate::math::Rgb;

/// Radiance of a camera sample or of a whole pixel, and the item that is visible there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSample {
    /// Linear RGB, finite and not negative.
    pub color: Rgb,
    /// The item that the camera rays hit.
    pub hit: HitId,
}

impl PixelSample {
    /// Black, no item hit.
    pub const BLACK: PixelSample = PixelSample { color: Rgb::BLACK, hit: HitId::Nothing };
}
