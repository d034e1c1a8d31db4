//! What a picture is compared with: the same picture with many samples, levels and no cutoff that matters, by other
//! random numbers.

use strahl_core::Limits;
use strahl_settings::{ConfidenceSettings, SamplerSettings, Settings};

/// The least rays in a pixel.
const LEAST: u32 = 32;
/// The most.
const MOST: u32 = 4096;
/// How sure it is that the mean of a pixel is as near to the true one as is asked: one standard error.
const LEVEL: f64 = 0.682_689_5;
/// Which part of the target error each pixel of the reference may have itself. Its square is added to what is measured:
/// were all pixels as bad, the error would seem 12 % larger than it is; most are far better.
const PART: f64 = 0.5;

/// The settings of high quality with which a picture of this target error is compared. Its random numbers have nothing to
/// do with those of the picture; `other` gives others again.
pub fn reference(settings: &Settings, limits: Limits, target: f64, other: u32) -> Settings {
    let confidence = ConfidenceSettings { confidence: LEVEL, tolerance: (PART * target) as f32 };
    let settings = Settings {
        sampler: SamplerSettings::Stochastic { min_samples: LEAST, max_samples: MOST, confidence },
        select: None,
        seed: settings.seed.wrapping_add(0x7275_7468).wrapping_add(other),
        ..settings.clone()
    };
    settings.with_limits(limits)
}
