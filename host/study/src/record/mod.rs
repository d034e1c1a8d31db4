//! What a study has found, as `study.json` holds it.
//!
//! Only what was measured is in it. What follows from that (the Pareto front, steps of knobs,
//! recommended settings) is found anew whenever a page is made, so that a page always agrees with
//! the numbers beside it. `strahl schema study` prints the schema, whose version is [`VERSION`].

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cost_model::EventWeights;

pub use run::{ErrorMetrics, RunRole, StudyRun};
pub use settings::{RunSettings, command_line};

pub mod file;
mod run;
mod settings;
pub mod table;

/// The format's name, the first thing in the file.
pub const FORMAT: &str = "strahl-study";

/// The format's version. It is raised when a field is renamed, goes, or means something else.
pub const VERSION: u32 = 1;

/// A study: what every setting of a scene costs, and how far its picture is from the truth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// Always `strahl-study`.
    pub format: String,
    /// The version of this format: 1.
    pub version: u32,
    /// What was rendered.
    pub scene: StudiedScene,
    /// How it was measured.
    pub method: MeasurementMethod,
    /// What everything was held against.
    pub reference: ReferenceRecord,
    /// Every setting that was measured. `run` elsewhere is a place in this list, from 0.
    pub runs: Vec<StudyRun>,
    /// Settings changed one by one, everything else being as good as it gets.
    pub knobs: Vec<ParameterSweep>,
    /// Techniques on and off.
    pub techniques: Vec<Technique>,
    /// The same setting with one thread, and twice as many each time: places of runs.
    pub threads: Vec<usize>,
    /// Settings that were not measured, or not to the end.
    pub left_out: Vec<SkippedSetting>,
    /// Pictures, as PNG files in base64.
    pub pictures: Vec<StudyImage>,
}

/// What was rendered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudiedScene {
    /// The file's name without its extension.
    pub name: String,
    /// The file as it was named on the command line.
    pub file: String,
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Every triangle of a mesh counts as one.
    pub objects: usize,
    /// Those that are triangles.
    pub triangles: usize,
    /// Lights.
    pub lights: usize,
    /// The effects that it asks for.
    pub effects: Vec<String>,
}

/// How it was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasurementMethod {
    /// The program and its version.
    pub program: String,
    /// When it began, UTC, as in RFC 3339.
    pub date: String,
    /// The processor, as it names itself.
    pub processor: String,
    /// Operating system and architecture.
    pub system: String,
    /// Threads that the machine runs at once.
    pub cores: usize,
    /// The machine's load (the mean over one minute) before the study began; null: not known.
    pub load: Option<f64>,
    /// `quick` or `full`.
    pub plan: String,
    /// Seconds that it was allowed to take; null: as many as the plan takes.
    pub time_limit: Option<f64>,
    /// Width and height that its pictures would have had with more time; null: those that they have.
    #[serde(default)]
    pub size_with_more_time: Option<[u32; 2]>,
    /// Seconds that it took.
    pub seconds: f64,
    /// Mixtures that were not measured, because a measured setting would beat them even if they were a good
    /// deal better than foretold.
    pub beaten: usize,
    /// What one event costs, in instructions; `work` is their sum.
    pub weights: EventWeights,
}

/// What everything was held against.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReferenceRecord {
    /// Two pictures of this setting with seeds of their own; the reference is their mean. It is never coarser
    /// than the scene's own setting.
    pub setting: RunSettings,
    /// The root of the mean square of what is left of chance in it: half of the difference of the
    /// two. Errors below it cannot be told from none.
    pub noise: f64,
    /// Which share of the light the last level and the cutoff cut in it.
    pub cut: f64,
    /// Seconds that it took.
    pub seconds: f64,
}

/// Settings that differ in one thing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterSweep {
    /// The option.
    pub name: String,
    /// What it is about, in a sentence.
    pub about: String,
    /// What all of its steps have in common.
    pub fixed: String,
    /// What errors of its steps are held against.
    pub against: String,
    /// From coarse to fine.
    pub steps: Vec<SweepPoint>,
    /// Steps that were not measured, see `left_out` of the study: with fewer than two steps and none left out
    /// there is nothing to turn in this scene.
    #[serde(default)]
    pub left_out: usize,
}

/// One notch of a knob.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SweepPoint {
    /// The value.
    pub value: String,
    /// Its run.
    pub run: usize,
    /// The error that this knob alone makes.
    pub alone: ErrorMetrics,
}

/// A technique, on and off.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Technique {
    /// Its name.
    pub name: String,
    /// Its section, as in 5.3, in the lecture on ray tracing that strahl began with.
    pub part: String,
    /// What is done without it.
    pub off: String,
    /// What is done with it.
    pub on: String,
    /// The run without it; null: it was given up, see `left_out`.
    pub without: Option<usize>,
    /// After how many seconds of wall-clock time the run without it was given up; null: it was not, or
    /// not begun.
    #[serde(default)]
    pub given_up: Option<f64>,
    /// The run with it; null: it was given up.
    pub with: Option<usize>,
    /// Whether it must not change one bit of the picture.
    pub exact: bool,
    /// How far the two pictures are from each other; null where one is missing.
    pub error: Option<ErrorMetrics>,
}

/// A setting that was not measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SkippedSetting {
    /// Which.
    pub setting: String,
    /// Why.
    pub why: String,
}

/// What is to be seen in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ImageContent {
    /// The reference.
    Reference,
    /// The picture of a run.
    Picture,
    /// How far the picture of a run is from the reference, in every pixel.
    Error,
    /// What every pixel of the scene's own setting costs.
    Cost,
}

/// A picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyImage {
    /// What is to be seen.
    pub shows: ImageContent,
    /// In which run.
    pub run: Option<usize>,
    /// Of what, in a few words.
    pub title: String,
    /// The least and the most of what colours show, where they show a number.
    pub range: Option<[f64; 2]>,
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// The file, in base64.
    pub png: String,
}
