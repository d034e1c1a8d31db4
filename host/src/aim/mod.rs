//! Settings that keep what is aimed at: an error, or a time.
//!
//! | room | what it does |
//! |---|---|
//! | [`error`] | the cheapest settings whose error is below a limit |
//! | [`notches`] | levels and cutoffs, what they lose and what they cost |
//! | [`plan`] | which settings are looked at |
//! | [`sparse`] | some pixels that stand for all |
//! | [`truth`] | what a picture is held against |
//! | [`time`] | the best picture that is there in time |

use std::path::Path;

use serde::Serialize;

use crate::amount::amount;
use crate::args::RenderArgs;
use crate::settings::{self, Source};
use crate::wanted::Wanted;

pub mod error;
pub mod notches;
pub mod plan;
pub mod sparse;
pub mod time;
pub mod truth;

/// What was aimed at, and what came of it.
#[derive(Clone, Debug, Serialize)]
pub struct Aimed {
    /// The settings that were taken.
    #[serde(skip)]
    pub taken: Wanted,
    /// Whether it is kept, as far as that is known.
    pub kept: bool,
    /// What was asked for, estimated and found.
    #[serde(flatten)]
    pub target: Target,
    /// Why these settings.
    pub why: String,
    /// The plain command that makes the same bytes, without search and clock.
    pub command: String,
}

/// What was asked for, and what was found.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "target", rename_all = "snake_case")]
pub enum Target {
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

impl Aimed {
    /// Lines for a person, each with its label.
    pub fn lines(&self) -> Vec<(&'static str, String)> {
        let mut lines = Vec::new();
        match &self.target {
            Target::Error { asked, estimate, at_most, pixels, tried, truth, measured, seconds } => {
                let kept = match (self.kept, measured) {
                    (true, _) => "",
                    (false, Some(_)) => ": not kept",
                    (false, None) => ": no setting keeps it",
                };
                lines.push(("aim", format!("an error of at most {asked}{kept}")));
                lines.push((
                    "error",
                    format!(
                        "estimated {estimate:.5}, with 95 % confidence at most {at_most:.5}, on {pixels} \
                         pixels against {truth}"
                    ),
                ));
                if let Some(measured) = measured {
                    lines.push((
                        "",
                        format!("true {measured:.5}, on all pixels and with other random numbers"),
                    ));
                }
                lines.push(("taken", format!("{} ({tried} tried in {seconds:.2} s)", self.why)));
            }
            Target::Time { asked, passes, given_up } => {
                lines.push(("aim", format!("a picture in {asked} s")));
                let more = if *given_up { ", and one that was given up" } else { "" };
                lines.push(("taken", format!("{}, after {}{more}", self.why, amount(*passes, "pass"))));
            }
        }
        lines.push(("same as", self.command.clone()));
        lines
    }
}

/// The plain command that makes the picture with these settings.
pub fn command(args: &RenderArgs, taken: &Wanted, output: &Path) -> String {
    let mut all = settings::settings(args, taken, output, &Default::default());
    // What nobody has set is the same without being named.
    let is_taken = |name: &str| ["levels", "cutoff", "sampler", "select", "output"].contains(&name);
    all.retain(|setting| setting.source == Source::CommandLine || is_taken(setting.name));
    settings::command(&args.scene, &all)
}
