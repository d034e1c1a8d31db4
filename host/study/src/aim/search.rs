//! Settings are tried on a sample of pixels.

use strahl_core::Limits;
use strahl_engine::{Progress, RenderError, RenderOptions};
use strahl_settings::{ConfidenceSettings, SamplerSettings, Settings};

use super::candidates::SamplingStrategy;
use super::sparse::SparsePixels;
use crate::cost_model::WEIGHTS;
use strahl_session::{RenderOutput, Session};

/// What is not to be changed.
#[derive(Clone, Copy, Debug, Default)]
pub struct FixedSettings {
    /// Levels.
    pub levels: bool,
    /// The cutoff.
    pub cutoff: bool,
    /// Rays in a pixel.
    pub sampler: bool,
    /// Pixels that are traced.
    pub select: bool,
}

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub struct ErrorTarget {
    /// The largest error.
    pub max_error: f64,
    /// What stays as it is.
    pub fixed: FixedSettings,
    /// Whether the true error is to be measured.
    pub verify: bool,
}

/// Levels, cutoff and rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QualitySettings {
    /// Levels and cutoff.
    pub limits: Limits,
    /// Rays in a pixel, and which pixels.
    pub rays: SamplingStrategy,
}

impl QualitySettings {
    /// The same settings with these.
    pub fn apply_to(self, settings: &Settings) -> Settings {
        self.rays.apply_to(settings).with_limits(self.limits)
    }
}

/// A search on a sample of pixels.
pub struct SettingsSearch<'s> {
    session: &'s Session<'s>,
    /// The settings that are asked for.
    pub settings: &'s Settings,
    options: RenderOptions<'s>,
    /// What is aimed at.
    pub target: ErrorTarget,
    progress: &'s dyn Progress,
    /// The sample.
    pub sparse: SparsePixels,
    /// How many settings were tried.
    pub evaluated: usize,
}

impl<'s> SettingsSearch<'s> {
    /// For the pixels that are requested.
    pub fn new(
        session: &'s Session<'s>,
        settings: &'s Settings,
        options: RenderOptions<'s>,
        goal: ErrorTarget,
        progress: &'s dyn Progress,
    ) -> Self {
        let sparse = SparsePixels::new(settings, &options);
        SettingsSearch { session, settings, options, target: goal, progress, sparse, evaluated: 0 }
    }

    /// Traces the sample; its cost in instructions.
    pub fn evaluate(&mut self, candidate: QualitySettings) -> Result<(RenderOutput, f64), RenderError> {
        self.evaluated += 1;
        let cost_map = self.sparse.cost_map();
        let options = RenderOptions { cost_map: Some(&cost_map), ..self.sparse_options() };
        let output = self.session.render(&candidate.apply_to(self.settings), &options, self.progress)?;
        let cost = WEIGHTS.map_instructions(&cost_map, output.accelerator.choice.kind);
        Ok((output, cost))
    }

    /// Traces the sample as the reference has it.
    pub fn render_reference(&self, limits: Limits) -> Result<RenderOutput, RenderError> {
        let reference = reference_settings(self.settings, limits, self.target.max_error, 0);
        self.session.render(&reference, &self.sparse_options(), self.progress)
    }

    fn sparse_options(&self) -> RenderOptions<'_> {
        RenderOptions { mask: Some(self.sparse.mask()), ..self.options }
    }
}

/// The least rays in a pixel.
const MIN_SAMPLES: u32 = 32;
/// The most of them.
const MAX_SAMPLES: u32 = 4096;
/// How sure it is that the mean of a pixel is as near to the true one as is asked: one standard error.
const CONFIDENCE_LEVEL: f64 = 0.682_689_5;
/// Which part of the target error each pixel of the reference may have itself. Its square is added to what is measured:
/// were all pixels as bad, the error would seem 12 % larger than it is; most are far better.
const NOISE_SHARE: f64 = 0.5;

/// The settings of high quality with which a picture of this target error is compared. Its random numbers have nothing to
/// do with those of the picture; `other` gives others again.
pub fn reference_settings(settings: &Settings, limits: Limits, target: f64, other: u32) -> Settings {
    let confidence =
        ConfidenceSettings { confidence: CONFIDENCE_LEVEL, tolerance: (NOISE_SHARE * target) as f32 };
    let settings = Settings {
        sampler: SamplerSettings::Stochastic {
            min_samples: MIN_SAMPLES,
            max_samples: MAX_SAMPLES,
            confidence,
        },
        select: None,
        seed: settings.seed.wrapping_add(0x7275_7468).wrapping_add(other),
        ..settings.clone()
    };
    settings.with_limits(limits)
}
