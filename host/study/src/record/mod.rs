//! The results of a study, as in `study.json`.
//!
//! Only measurements are stored. Derived values (the Pareto front, recommended settings) are computed whenever a report is
//! written, so that they always agree with the numbers. `strahl schema study` prints the schema, whose version is
//! [`VERSION`].

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cost_model::EventWeights;

pub use run::{ErrorMetrics, RunRole, StudyRun};
pub use settings::{RunSettings, command_line};

pub mod file;
mod run;
mod settings;
pub mod table;

/// The name of the format, the first field of the file.
pub const FORMAT: &str = "strahl-study";

/// The version of the format. It increases when a field is renamed, removed, or changes its meaning.
pub const VERSION: u32 = 1;

/// A study: the cost of each setting of a scene, and the error of its picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// Always `strahl-study`.
    pub format: String,
    /// The version of this format: 1.
    pub version: u32,
    /// The scene.
    pub scene: StudiedScene,
    /// How it was measured.
    pub method: MeasurementMethod,
    /// The reference picture.
    pub reference: ReferenceRecord,
    /// All measured settings. `run` in other fields is an index into this list, from 0.
    pub runs: Vec<StudyRun>,
    /// One-parameter sweeps; all other settings are at their most accurate value.
    pub knobs: Vec<ParameterSweep>,
    /// Techniques, on and off.
    pub techniques: Vec<Technique>,
    /// The same setting with 1, 2, 4 ... threads: indices into `runs`.
    pub threads: Vec<usize>,
    /// Settings that were not measured, or aborted.
    pub left_out: Vec<SkippedSetting>,
    /// Pictures, as PNG files in base64.
    pub pictures: Vec<StudyImage>,
}

/// The scene of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudiedScene {
    /// File name without extension.
    pub name: String,
    /// The path on the command line.
    pub file: String,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Number of objects; every triangle of a mesh counts as one.
    pub objects: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Number of lights.
    pub lights: usize,
    /// The required effects.
    pub effects: Vec<String>,
}

/// How a study was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasurementMethod {
    /// The program and its version.
    pub program: String,
    /// Start time, UTC, in RFC 3339 format.
    pub date: String,
    /// The name of the processor.
    pub processor: String,
    /// Operating system and architecture.
    pub system: String,
    /// Number of hardware threads.
    pub cores: usize,
    /// Load average (one minute) before the study; null: not known.
    pub load: Option<f64>,
    /// `quick` or `full`.
    pub plan: String,
    /// Time limit in seconds; null: none.
    pub time_limit: Option<f64>,
    /// Width and height of the pictures without the time limit; null: the same.
    #[serde(default)]
    pub size_with_more_time: Option<[u32; 2]>,
    /// Duration in seconds.
    pub seconds: f64,
    /// Combinations that were skipped because a measured setting would dominate them even if they were much better than
    /// predicted.
    pub beaten: usize,
    /// Instructions per event; `work` is the weighted sum of the counts.
    pub weights: EventWeights,
}

/// The reference picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReferenceRecord {
    /// The reference is the mean of two pictures with this setting and different seeds. It is at least as fine as the
    /// settings of the scene.
    pub setting: RunSettings,
    /// Remaining noise (RMSE): half of the difference of the two. Errors below it are not significant.
    pub noise: f64,
    /// Share of the light that the level limit and the cutoff discard.
    pub cut: f64,
    /// Duration in seconds.
    pub seconds: f64,
}

/// A sweep of one setting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterSweep {
    /// The option.
    pub name: String,
    /// A description in one sentence.
    pub about: String,
    /// The common settings of all steps.
    pub fixed: String,
    /// What the errors of the steps are relative to.
    pub against: String,
    /// The values, from coarse to fine.
    pub steps: Vec<SweepPoint>,
    /// Number of values that were not measured, see `left_out` of the study. With fewer than two steps and none left out, the
    /// setting has no effect in this scene.
    #[serde(default)]
    pub left_out: usize,
}

/// One value of the swept setting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SweepPoint {
    /// The value.
    pub value: String,
    /// The index of its run.
    pub run: usize,
    /// Error caused by this setting alone.
    pub alone: ErrorMetrics,
}

/// A technique, on and off.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Technique {
    /// The name of the technique.
    pub name: String,
    /// Section of the lecture on ray tracing that strahl implements, as in 5.3.
    pub part: String,
    /// The setting without it.
    pub off: String,
    /// The setting with it.
    pub on: String,
    /// The run without it; null: it was aborted, see `left_out`.
    pub without: Option<usize>,
    /// Wall-clock seconds after which the run without it was aborted; null: it was not aborted, or not started.
    #[serde(default)]
    pub given_up: Option<f64>,
    /// The run with it; null: it was aborted.
    pub with: Option<usize>,
    /// Whether both pictures must be the same, bit for bit.
    pub exact: bool,
    /// The error between the two pictures; null if one is missing.
    pub error: Option<ErrorMetrics>,
}

/// A setting that was not measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SkippedSetting {
    /// The setting.
    pub setting: String,
    /// The reason.
    pub why: String,
}

/// The content of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ImageContent {
    /// The reference.
    Reference,
    /// The picture of a run.
    Picture,
    /// The error of each pixel of the picture of a run.
    Error,
    /// The cost of each pixel with the settings of the scene.
    Cost,
}

/// A picture of the report.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyImage {
    /// The content.
    pub shows: ImageContent,
    /// The index of its run.
    pub run: Option<usize>,
    /// A short title.
    pub title: String,
    /// Minimum and maximum of the color scale, if the colors represent numbers.
    pub range: Option<[f64; 2]>,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The PNG file, in base64.
    pub png: String,
}
