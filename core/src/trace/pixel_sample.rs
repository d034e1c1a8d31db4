//! The result of tracing a camera sample or a pixel.

use super::HitId;
use crate::math::Rgb;

/// Color and hit of one camera sample, or of a whole pixel, for which a sampler combines several camera
/// samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSample {
    /// Radiance, linear RGB, finite and not negative; of a pixel, the weighted mean of its samples.
    pub color: Rgb,
    /// What was hit: the item, [`HitId::Nothing`], or [`HitId::Mixed`] if the rays of a pixel differ.
    pub hit: HitId,
}

impl PixelSample {
    /// Black, no item hit.
    pub const BLACK: PixelSample = PixelSample { color: Rgb::BLACK, hit: HitId::Nothing };
}
