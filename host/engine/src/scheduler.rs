//! The schedule of progressive rendering.

use std::time::Instant;

use strahl_settings::{SamplerSettings, SelectionSettings};

use crate::output::Color;

/// The settings of a pass, which renders a whole picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// The sampler; samples are reused by `single` and `stochastic`.
    pub sampler: SamplerSettings,
    /// The selection of pixels that are traced; `None` for all.
    pub select: Option<SelectionSettings>,
    /// The time at which the pass is cancelled; cancelling the first pass is an error.
    pub deadline: Option<Instant>,
}

/// The remaining work, for the choice of the next pass.
pub struct Outlook<'o> {
    /// The number of pixels whose center has not been traced.
    pub untraced_pixels: u64,
    /// The number of all pixels.
    pub pixels: u64,
    /// The estimated number of further rays until the mean of every pixel is within a tolerance.
    pub rays_for_tolerance: &'o dyn Fn(f32) -> u64,
}

/// The cost of a pass.
#[derive(Clone, Copy, Debug)]
pub struct PassStats {
    /// The wall-clock time, in seconds.
    pub seconds: f64,
    /// The number of camera rays.
    pub rays: u64,
}

/// Selects the passes of progressive rendering.
pub trait Scheduler {
    /// The next pass; `None` to end rendering.
    fn next(&mut self, outlook: &Outlook<'_>) -> Option<Pass>;

    /// Receives a completed pass and its picture, row by row.
    fn done(&mut self, pass: &Pass, stats: PassStats, picture: Vec<Color>);
}
