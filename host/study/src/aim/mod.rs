//! Settings for a target error or a time limit.
//!
//! | module | contents |
//! |---|---|
//! | [`error`] | the cheapest settings that reach a target error |
//! | [`time`] | the best picture within a time limit |
//! | [`limits`] | candidates for levels and cutoff, with error and cost |
//! | [`candidates`] | candidates for samplers and pixel selection |
//! | [`search`] | evaluation of settings on a sample of pixels, and the reference |
//! | [`sparse`] | a sample of pixels that represents the picture |

use serde::Serialize;
use strahl_settings::Settings;

pub mod candidates;
pub mod error;
pub mod limits;
pub mod search;
pub mod sparse;
pub mod time;

/// The result of a target: the chosen settings and what they reach.
#[derive(Clone, Debug, Serialize)]
pub struct AimResult {
    /// The chosen settings.
    #[serde(skip)]
    pub settings: Settings,
    /// Whether the target is reached, as far as known.
    #[serde(rename = "kept")]
    pub is_met: bool,
    /// The target, and the values found.
    #[serde(flatten)]
    pub target: AimTarget,
    /// Why these settings were chosen.
    pub why: String,
}

/// A target, and the values found.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "target", rename_all = "snake_case")]
pub enum AimTarget {
    /// A maximum error.
    Error {
        /// The requested error.
        #[serde(rename = "asked")]
        requested: f64,
        /// The error of the settings on the sampled pixels.
        estimate: f64,
        /// Upper bound of the error of the whole picture, with 95 % confidence.
        at_most: f64,
        /// Number of sampled pixels.
        pixels: usize,
        /// Number of settings that were evaluated.
        tried: usize,
        /// The settings of the reference.
        #[serde(rename = "truth")]
        reference: String,
        /// The measured error of the picture, with `--verify`.
        measured: Option<f64>,
        /// Duration of the search, in seconds.
        seconds: f64,
    },
    /// A time limit.
    Time {
        /// The limit, in seconds.
        #[serde(rename = "asked")]
        requested: f64,
        /// Number of completed passes.
        passes: usize,
        /// Whether another pass was started and aborted.
        #[serde(rename = "given_up")]
        aborted_a_pass: bool,
    },
}
