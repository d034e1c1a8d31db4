//! A setting that was measured: everything that decides about a picture and its time, what tracing
//! it took, and how far the picture is from the reference.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::settings::RunSettings;
use crate::cost_model::EventCounts;
use crate::statistics::median;

/// What a run was made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RunRole {
    /// The scene's own settings, or the defaults.
    Own,
    /// One knob turned, the others being as good as they get.
    Knob,
    /// Several knobs turned.
    Mix,
    /// A technique on or off, by the loop that all accelerators and both precisions have.
    Technique,
    /// Another number of threads.
    Threads,
}

/// A setting that was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyRun {
    /// What it was made for.
    pub role: RunRole,
    /// The setting.
    pub setting: RunSettings,
    /// Processor seconds of tracing, the sum over all threads, once for each repetition.
    pub cpu: Vec<f64>,
    /// Wall-clock seconds of tracing, once for each repetition.
    pub wall: Vec<f64>,
    /// Wall-clock seconds of making the tables and the accelerator, the first time.
    pub build: f64,
    /// The work in instructions, as the counts and the weights have it: the same on every machine.
    pub work: f64,
    /// What was counted.
    pub counts: EventCounts,
    /// How far the picture is from the reference.
    pub error: ErrorMetrics,
    /// Which share of the light the last level and the cutoff cut.
    pub cut: [f64; 2],
    /// BLAKE3 of the linear picture.
    pub digest: String,
}

/// How far a picture is from another: differences of sRGB-encoded values, 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ErrorMetrics {
    /// The root of the mean square.
    pub rmse: f64,
    /// The largest.
    pub largest: f64,
    /// The share of pixels with a channel more than 1/255 off.
    pub beyond: f64,
    /// Structural similarity; 1 is equal.
    pub ssim: f64,
}

impl StudyRun {
    /// The median of the processor seconds.
    pub fn median_cpu_seconds(&self) -> f64 {
        median(&self.cpu)
    }

    /// Whether it tells what accuracy costs, rather than how a picture is found.
    pub fn measures_accuracy(&self) -> bool {
        matches!(self.role, RunRole::Own | RunRole::Knob | RunRole::Mix)
    }
}
