//! What a picture is held against: the same picture with many samples, levels and no cutoff that
//! matters, by other random numbers.

use crate::render_request::RenderRequest;
use strahl_core::Limits;
use strahl_settings::{Confidence, Sampling, Settings};

/// The least rays in a pixel.
const LEAST: u32 = 32;
/// The most.
const MOST: u32 = 4096;
/// How sure it is that the mean of a pixel is as near to the true one as is asked: one standard error.
const LEVEL: f64 = 0.682_689_5;
/// Which part of the error that is aimed at each pixel of the truth may have itself. Its square is added
/// to what is measured: were all pixels as bad, the error would seem 12 % larger than it is; most are
/// far better.
const PART: f64 = 0.5;

/// The picture of high quality that a picture of this error is held against. Its random numbers have
/// nothing to do with those of the picture; `other` gives others again.
pub fn truth(request: &RenderRequest, limits: Limits, goal: f64, other: u32) -> RenderRequest {
    let confidence = Confidence { level: LEVEL, tolerance: (PART * goal) as f32 };
    let settings = Settings {
        sampler: Sampling::Stochastic { least: LEAST, most: MOST, confidence },
        select: None,
        seed: request.settings.seed.wrapping_add(0x7275_7468).wrapping_add(other),
        ..request.settings.clone()
    };
    RenderRequest { cost_map: None, ..request.with(settings.with_limits(limits)) }
}
