//! Evaluation of settings on a sample of pixels, and the reference that they are compared with.

use strahl_core::Limits;
use strahl_engine::{Progress, RenderError, RenderOptions};
use strahl_session::{RenderOutput, Session};
use strahl_settings::{ConfidenceSettings, SamplerSettings, Settings};

use super::candidates::SamplingStrategy;
use super::sparse::SparsePixels;
use crate::cost_model::WEIGHTS;

/// Settings that the command line fixes; the search does not change them.
#[derive(Clone, Copy, Debug, Default)]
pub struct FixedSettings {
    /// Whether levels are fixed.
    pub levels: bool,
    /// Whether the cutoff is fixed.
    pub cutoff: bool,
    /// Whether the sampler is fixed.
    pub sampler: bool,
    /// Whether pixel selection is fixed.
    pub select: bool,
}

/// A target error.
#[derive(Clone, Copy, Debug)]
pub struct ErrorTarget {
    /// The maximum error (RMSE of sRGB-encoded values).
    pub max_error: f64,
    /// Fixed settings.
    pub fixed: FixedSettings,
    /// Whether the error of the whole picture is measured afterwards.
    pub verify: bool,
}

/// The settings that a search varies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QualitySettings {
    /// Levels and cutoff.
    pub limits: Limits,
    /// Sampler and pixel selection.
    pub rays: SamplingStrategy,
}

impl QualitySettings {
    /// The settings with these values.
    pub fn apply_to(self, settings: &Settings) -> Settings {
        self.rays.apply_to(settings).with_limits(self.limits)
    }
}

/// A search for settings on a sample of pixels.
pub struct SettingsSearch<'s> {
    session: &'s Session<'s>,
    /// The requested settings.
    pub settings: &'s Settings,
    options: RenderOptions<'s>,
    /// The target.
    pub target: ErrorTarget,
    progress: &'s dyn Progress,
    /// The sampled pixels.
    pub sparse: SparsePixels,
    /// Number of evaluated settings.
    pub evaluated: usize,
}

impl<'s> SettingsSearch<'s> {
    /// A search on the requested pixels.
    pub fn new(
        session: &'s Session<'s>,
        settings: &'s Settings,
        options: RenderOptions<'s>,
        target: ErrorTarget,
        progress: &'s dyn Progress,
    ) -> Self {
        let sparse = SparsePixels::new(settings, &options);
        SettingsSearch { session, settings, options, target, progress, sparse, evaluated: 0 }
    }

    /// Renders the sampled pixels. Returns the picture and its cost in instructions.
    pub fn evaluate(&mut self, candidate: QualitySettings) -> Result<(RenderOutput, f64), RenderError> {
        self.evaluated += 1;
        let cost_map = self.sparse.cost_map();
        let options = RenderOptions { cost_map: Some(&cost_map), ..self.sparse_options() };
        let output = self.session.render(&candidate.apply_to(self.settings), &options, self.progress)?;
        let cost = WEIGHTS.map_instructions(&cost_map, output.accelerator.choice.kind);
        Ok((output, cost))
    }

    /// Renders the sampled pixels with the settings of the reference.
    pub fn render_reference(&self, limits: Limits) -> Result<RenderOutput, RenderError> {
        let reference = reference_settings(self.settings, limits, self.target.max_error, 0);
        self.session.render(&reference, &self.sparse_options(), self.progress)
    }

    fn sparse_options(&self) -> RenderOptions<'_> {
        RenderOptions { mask: Some(self.sparse.mask()), ..self.options }
    }
}

/// Minimum samples per pixel of the reference.
const MIN_SAMPLES: u32 = 32;
/// Maximum samples per pixel of the reference.
const MAX_SAMPLES: u32 = 4096;
/// Confidence that the mean of a pixel is within the tolerance: one standard error.
const CONFIDENCE_LEVEL: f64 = 0.682_689_5;
/// Maximum error of each pixel of the reference, relative to the target error. Errors add as squares: if all pixels had
/// it, measured errors would be 12 % too large; most pixels are far better.
const NOISE_SHARE: f64 = 0.5;

/// The settings of the reference for a target error. Its random numbers are independent of those of the picture; each
/// `stream` gives others.
pub fn reference_settings(settings: &Settings, limits: Limits, max_error: f64, stream: u32) -> Settings {
    let confidence =
        ConfidenceSettings { confidence: CONFIDENCE_LEVEL, tolerance: (NOISE_SHARE * max_error) as f32 };
    let settings = Settings {
        sampler: SamplerSettings::Stochastic {
            min_samples: MIN_SAMPLES,
            max_samples: MAX_SAMPLES,
            confidence,
        },
        select: None,
        seed: settings.seed.wrapping_add(0x7275_7468).wrapping_add(stream),
        ..settings.clone()
    };
    settings.with_limits(limits)
}
