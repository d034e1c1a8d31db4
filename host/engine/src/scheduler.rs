//! What comes next in a picture that becomes better pass by pass.

use std::time::Instant;

use strahl_settings::{SamplerSettings, SelectionSettings};

use crate::output::Color;

/// One pass: a whole picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// Which rays make a pixel: one, or as many as a stochastic rule asks for.
    pub sampler: SamplerSettings,
    /// Which pixels are traced, where not all are.
    pub select: Option<SelectionSettings>,
    /// When it is given up; with the first pass, all is.
    pub until: Option<Instant>,
}

/// What is ahead.
pub struct Outlook<'o> {
    /// Pixels through whose center no ray has been sent yet.
    pub missing: u64,
    /// All pixels.
    pub pixels: u64,
    /// How many more rays it takes until the mean of every pixel is known to this tolerance.
    pub needs: &'o dyn Fn(f32) -> u64,
}

/// What a pass took.
#[derive(Clone, Copy, Debug)]
pub struct PassStats {
    /// Seconds of the clock.
    pub seconds: f64,
    /// Rays through the picture.
    pub rays: u64,
}

/// Decides what comes next.
pub trait Scheduler {
    /// The next pass; none when it is enough.
    fn next(&mut self, outlook: &Outlook<'_>) -> Option<Pass>;

    /// A pass was completed, and this is its picture, row by row.
    fn done(&mut self, pass: &Pass, stats: PassStats, picture: Vec<Color>);
}
