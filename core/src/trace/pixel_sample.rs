//! The light of one camera sample or of one pixel.

use super::HitId;
use crate::math::Rgb;

/// The light from a point of the film or from a whole pixel, and what is seen there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSample {
    /// Linear radiance, finite and not below zero.
    pub color: Rgb,
    /// What the camera rays hit.
    pub hit: HitId,
}

impl PixelSample {
    /// No light from nowhere.
    pub const BLACK: PixelSample = PixelSample { color: Rgb::BLACK, hit: HitId::Nothing };
}
