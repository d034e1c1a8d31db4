//! Settings are tried on a sample of pixels.

use strahl_core::Limits;
use strahl_engine::{Progress, RenderError, RenderOptions};
use strahl_settings::{ConfidenceSettings, SamplerSettings, Settings};

use super::candidates::Rays;
use super::sparse::Sparse;
use crate::cost_model::WEIGHTS;
use strahl_session::{RenderOutput, Session};

/// What is not to be changed.
#[derive(Clone, Copy, Debug, Default)]
pub struct Fixed {
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
pub struct Goal {
    /// The largest error.
    pub error: f64,
    /// What stays as it is.
    pub fixed: Fixed,
    /// Whether the true error is to be measured.
    pub verify: bool,
}

/// Levels, cutoff and rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Levels and cutoff.
    pub limits: Limits,
    /// Rays in a pixel, and which pixels.
    pub rays: Rays,
}

impl Candidate {
    /// The same settings with these.
    pub fn apply(self, settings: &Settings) -> Settings {
        self.rays.apply(settings).with_limits(self.limits)
    }
}

/// A search on a sample of pixels.
pub struct Search<'s> {
    session: &'s Session<'s>,
    /// The settings that are asked for.
    pub settings: &'s Settings,
    options: RenderOptions<'s>,
    /// What is aimed at.
    pub goal: Goal,
    progress: &'s dyn Progress,
    /// The sample.
    pub sparse: Sparse,
    /// How many settings were tried.
    pub tried: usize,
}

impl<'s> Search<'s> {
    /// For the pixels that are requested.
    pub fn new(
        session: &'s Session<'s>,
        settings: &'s Settings,
        options: RenderOptions<'s>,
        goal: Goal,
        progress: &'s dyn Progress,
    ) -> Self {
        let sparse = Sparse::new(settings, &options);
        Search { session, settings, options, goal, progress, sparse, tried: 0 }
    }

    /// Traces the sample; its cost in instructions.
    pub fn trace(&mut self, candidate: Candidate) -> Result<(RenderOutput, f64), RenderError> {
        self.tried += 1;
        let cost_map = self.sparse.cost_map();
        let options = RenderOptions { cost_map: Some(&cost_map), ..self.sampled() };
        let output = self.session.render(&candidate.apply(self.settings), &options, self.progress)?;
        let cost = WEIGHTS.work_of_map(&cost_map, output.accelerator.choice.kind);
        Ok((output, cost))
    }

    /// Traces the sample as the reference has it.
    pub fn trace_reference(&self, limits: Limits) -> Result<RenderOutput, RenderError> {
        let reference = reference(self.settings, limits, self.goal.error, 0);
        self.session.render(&reference, &self.sampled(), self.progress)
    }

    fn sampled(&self) -> RenderOptions<'_> {
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
pub fn reference(settings: &Settings, limits: Limits, target: f64, other: u32) -> Settings {
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
