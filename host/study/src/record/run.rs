//! A measured setting: the settings of the picture, the cost of tracing it, and its error.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::settings::RunSettings;
use crate::cost_model::EventCounts;
use crate::statistics::median;

/// The purpose of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RunRole {
    /// The settings of the scene, completed by defaults.
    Own,
    /// One setting varied; the others are at their most accurate value.
    Knob,
    /// Several settings varied.
    Mix,
    /// A technique, on or off.
    Technique,
    /// Another number of threads.
    Threads,
}

/// A measured setting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyRun {
    /// Its purpose.
    pub role: RunRole,
    /// The settings.
    pub setting: RunSettings,
    /// Processor seconds of tracing, summed over all threads, one value per repetition.
    #[serde(rename = "cpu")]
    pub cpu_seconds: Vec<f64>,
    /// Wall-clock seconds of tracing, one value per repetition.
    #[serde(rename = "wall")]
    pub elapsed_seconds: Vec<f64>,
    /// Wall-clock seconds to build the tables and the accelerator, in the first repetition.
    pub build: f64,
    /// The work in instructions, from counts and weights: the same on every machine.
    pub work: f64,
    /// Event counts.
    pub counts: EventCounts,
    /// The error of the picture, relative to the reference.
    pub error: ErrorMetrics,
    /// Shares of the light that the level limit and the cutoff discard.
    pub cut: [f64; 2],
    /// BLAKE3 digest of the linear picture.
    pub digest: String,
}

/// The error of a picture: differences of sRGB-encoded values, 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ErrorMetrics {
    /// Root mean square.
    pub rmse: f64,
    /// Maximum.
    pub largest: f64,
    /// Share of pixels with a channel that differs by more than 1/255.
    pub beyond: f64,
    /// Structural similarity; 1 means equal.
    pub ssim: f64,
}

impl StudyRun {
    /// The median of the processor seconds.
    pub fn median_cpu_seconds(&self) -> f64 {
        median(&self.cpu_seconds)
    }

    /// Whether it measures the cost of accuracy, rather than that of an accelerator or of threads.
    pub fn measures_accuracy(&self) -> bool {
        matches!(self.role, RunRole::Own | RunRole::Knob | RunRole::Mix)
    }
}
