//! Settings that keep what is aimed at: an error, or a time.
//!
//! | module | what it does |
//! |---|---|
//! | [`error`] | the cheapest settings whose error is below a limit |
//! | [`limits`] | levels and cutoffs, what they lose and what they cost |
//! | [`search`] | settings are tried on a sample of pixels, and what they are compared with |
//! | [`candidates`] | which settings are looked at |
//! | [`sparse`] | some pixels that stand for all |
//! | [`time`] | the best picture that is there in time |

use serde::Serialize;
use strahl_settings::Settings;

pub mod candidates;
pub mod error;
pub mod limits;
pub mod search;
pub mod sparse;
pub mod time;

/// What was aimed at, and what came of it.
#[derive(Clone, Debug, Serialize)]
pub struct AimResult {
    /// The settings that were taken.
    #[serde(skip)]
    pub settings: Settings,
    /// Whether it is kept, as far as that is known.
    pub kept: bool,
    /// What was asked for, estimated and found.
    #[serde(flatten)]
    pub target: AimTarget,
    /// Why these settings.
    pub why: String,
}

/// What was asked for, and what was found.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "target", rename_all = "snake_case")]
pub enum AimTarget {
    /// A largest error.
    Error {
        /// It.
        asked: f64,
        /// The error of these settings on the pixels that were looked at.
        estimate: f64,
        /// What the error of the whole picture is at most, with a confidence of 95 %.
        at_most: f64,
        /// How many pixels were looked at.
        pixels: usize,
        /// How many settings were tried on them.
        tried: usize,
        /// What they were held against.
        truth: String,
        /// The error of the picture, where it was measured.
        measured: Option<f64>,
        /// Seconds that the search took.
        seconds: f64,
    },
    /// A time.
    Time {
        /// It, in seconds.
        asked: f64,
        /// Passes that were completed.
        passes: usize,
        /// Whether one more was begun and given up.
        given_up: bool,
    },
}
