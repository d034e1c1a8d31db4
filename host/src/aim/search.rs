//! Settings are tried on a sample of pixels.

use strahl_core::Limits;
use strahl_engine::{Progress, RenderError, RenderOptions};
use strahl_settings::Settings;

use super::plan::Rays;
use super::reference::reference;
use super::sparse::Sparse;
use crate::cost::WEIGHTS;
use crate::session::{RenderOutput, Session};

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
