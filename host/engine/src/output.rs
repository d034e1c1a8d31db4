//! What comes of rendering, or why nothing does.

use std::error::Error;
use std::fmt;
use std::time::Duration;

use strahl_core::scene::EffectSet;
use strahl_core::tally::Counters;
use strahl_settings::ResolvedAccel;

use crate::progress::Interrupt;

/// A linear colour in single precision, whatever precision computes it.
pub type Color = strahl_core::Rgb;

/// What an engine has rendered.
#[derive(Debug)]
pub struct Rendered {
    /// Linear colours, row by row.
    pub colors: Vec<Color>,
    /// The work.
    pub counters: Counters,
    /// Wall-clock time.
    pub trace: Duration,
    /// Processor time, the sum over all threads.
    pub trace_cpu: Duration,
}

/// What is in a scene.
#[derive(Clone, Copy, Debug)]
pub struct SceneStats {
    /// All items.
    pub objects: usize,
    /// Those that are triangles.
    pub triangles: usize,
    /// All lights.
    pub lights: usize,
    /// The effects that it asks for.
    pub effects: EffectSet,
}

/// What an accelerator is like.
#[derive(Clone, Copy, Debug)]
pub struct AccelStats {
    /// Which it is.
    pub choice: ResolvedAccel,
    /// The memory it uses.
    pub bytes: usize,
    /// Its regions: groups, cells, leaves with items.
    pub regions: usize,
    /// The items of all regions, each counted in each.
    pub entries: usize,
    /// Steps from the root to the deepest region.
    pub depth: Option<u32>,
    /// How long it took to build, with the boxes round all items.
    pub build: Duration,
}

impl AccelStats {
    /// How many items a region has, in the mean.
    pub fn items_per_region(&self) -> f64 {
        if self.regions == 0 { 0.0 } else { self.entries as f64 / self.regions as f64 }
    }
}

/// Why there is no picture.
#[derive(Debug)]
#[non_exhaustive]
pub enum RenderError {
    /// The scene, or what is requested of it, is refused by the core.
    Invalid(Box<dyn Error + Send + Sync>),
    /// The work was stopped before it was done.
    Interrupted(Interrupt),
}

impl RenderError {
    /// Because of an error of the core.
    pub fn invalid(error: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        RenderError::Invalid(error.into())
    }
}

impl From<Interrupt> for RenderError {
    fn from(interrupt: Interrupt) -> Self {
        RenderError::Interrupted(interrupt)
    }
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RenderError::Invalid(error) => error.fmt(f),
            RenderError::Interrupted(interrupt) => interrupt.fmt(f),
        }
    }
}

impl Error for RenderError {}
