//! A setting that was measured: everything that decides about a picture and its time, what tracing
//! it took, and how far the picture is from the reference.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cost::Counts;
use crate::study::statistics::median;

/// Everything that decides about a picture and its time, in the words of the command line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Setting {
    /// `--levels`
    pub levels: u8,
    /// `--cutoff`
    pub cutoff: f32,
    /// `--sampler`
    pub sampler: String,
    /// `--filter`
    pub filter: String,
    /// `--select`; null: every pixel is traced.
    pub select: Option<String>,
    /// `--without`
    pub without: Vec<String>,
    /// `--precision`
    pub precision: String,
    /// How items were found, in words.
    pub accelerator: String,
    /// Whether who stood last in a light was asked first.
    pub shadow_cache: bool,
    /// `--threads`
    pub threads: usize,
    /// `--seed`
    pub seed: u32,
    /// What the command line says for all of it.
    pub options: String,
}

/// What a run was made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Role {
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
pub struct Run {
    /// What it was made for.
    pub role: Role,
    /// The setting.
    pub setting: Setting,
    /// Processor seconds of tracing, the sum over all threads, once for each repetition.
    pub cpu: Vec<f64>,
    /// Wall-clock seconds of tracing, once for each repetition.
    pub wall: Vec<f64>,
    /// Wall-clock seconds of making the tables and the accelerator, the first time.
    pub build: f64,
    /// The work in instructions, as the counts and the weights have it: the same on every machine.
    pub work: f64,
    /// What was counted.
    pub counts: Counts,
    /// How far the picture is from the reference.
    pub error: Errors,
    /// Which share of the light the last level and the cutoff cut.
    pub cut: [f64; 2],
    /// BLAKE3 of the linear picture.
    pub digest: String,
}

/// How far a picture is from another: differences of sRGB-encoded values, 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Errors {
    /// The root of the mean square.
    pub rmse: f64,
    /// The largest.
    pub largest: f64,
    /// The share of pixels with a channel more than 1/255 off.
    pub beyond: f64,
    /// Structural similarity; 1 is equal.
    pub ssim: f64,
}

impl Setting {
    /// The kind of accelerator: the first of the words about it.
    pub fn kind(&self) -> &str {
        self.accelerator.split(' ').next().unwrap_or_default()
    }
}

impl Run {
    /// The median of the processor seconds.
    pub fn seconds(&self) -> f64 {
        median(&self.cpu)
    }

    /// Whether it tells what accuracy costs, rather than how a picture is found.
    pub fn is_about_accuracy(&self) -> bool {
        matches!(self.role, Role::Own | Role::Knob | Role::Mix)
    }
}
