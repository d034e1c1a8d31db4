//! Results of rendering: pictures, statistics and errors.

use std::error::Error;
use std::fmt;
use std::time::Duration;

use strahl_core::scene::EffectSet;
use strahl_core::tally::Counters;
use strahl_settings::ResolvedAccel;

use crate::progress::Interrupt;

/// A linear color in single precision, also in double-precision engines.
pub type Color = strahl_core::Rgb;

/// A rendered picture with its counters and times.
#[derive(Debug)]
pub struct Rendered {
    /// Linear colors, row by row.
    pub colors: Vec<Color>,
    /// Counters of rays and, if requested, of tests.
    pub counters: Counters,
    /// The wall-clock time of tracing.
    pub trace: Duration,
    /// The processor time of tracing, summed over all threads.
    pub trace_cpu: Duration,
}

/// Statistics of a scene.
#[derive(Clone, Copy, Debug)]
pub struct SceneStats {
    /// The number of items.
    pub objects: usize,
    /// The number of triangles among them.
    pub triangles: usize,
    /// The number of lights.
    pub lights: usize,
    /// The effects that the scene and its camera require.
    pub effects: EffectSet,
}

/// Statistics of an acceleration structure.
#[derive(Clone, Copy, Debug)]
pub struct AccelStats {
    /// The selected structure.
    pub choice: ResolvedAccel,
    /// The size in bytes.
    pub bytes: usize,
    /// The number of regions: groups of the list, cells of the grid, occupied leaves of a tree.
    pub regions: usize,
    /// The number of entries: items, counted once for each region that contains them.
    pub entries: usize,
    /// The number of edges from the root to the deepest leaf; `None` for list and grid.
    pub depth: Option<u32>,
    /// The construction time, including that of the bounding boxes of items.
    pub build: Duration,
}

impl AccelStats {
    /// The mean number of items per region; 0 without regions.
    pub fn items_per_region(&self) -> f64 {
        if self.regions == 0 { 0.0 } else { self.entries as f64 / self.regions as f64 }
    }
}

/// Why rendering failed.
#[derive(Debug)]
#[non_exhaustive]
pub enum RenderError {
    /// The core rejected the scene or a setting.
    Invalid(Box<dyn Error + Send + Sync>),
    /// Rendering was cancelled.
    Interrupted(Interrupt),
}

impl RenderError {
    /// An error of the core.
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
