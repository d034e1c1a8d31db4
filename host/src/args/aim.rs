//! What settings are to keep, and what is told of the work: options of `render` alone.

use std::path::PathBuf;
use std::time::Duration;

use strahl_settings::domain::parse_fraction;

use super::times::not_too_long;

/// What settings are to keep, and what is told of the work.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct AimArgs {
    /// Show what each pixel costs: rays, tests and levels, as a picture with a legend, or with the
    /// extension .exr as channels of numbers.
    #[arg(long, value_name = "FILE")]
    pub cost: Option<PathBuf>,

    /// Take the cheapest levels, cutoff, sampler and selection whose error is estimated below E: the root
    /// of the mean square of sRGB-encoded differences (0 to 1, as in 0.01 or 2/255) to a picture of high
    /// quality. The estimate is made on a sparse sample of pixels. What the command line sets stays as it
    /// is; what the scene sets does not. The exit status is 1 when no setting is good enough.
    #[arg(long, value_name = "E", value_parser = error, allow_negative_numbers = true)]
    pub target_error: Option<f64>,

    /// Trace the picture of high quality too, with other random numbers, and tell the true error; the
    /// exit status is 1 when it is more than E. Takes long.
    #[arg(long, requires = "target_error")]
    pub verify: bool,

    /// Make the best picture that is written when this time is over, as in 2s or 1m 30s, counted from the
    /// start of the program: a coarse raster of pixels first, then all of them, then more samples where
    /// the error is estimated largest. What is written is always complete. Levels and cutoff stay as
    /// they are.
    #[arg(long, value_name = "T", value_parser = duration, allow_hyphen_values = true,
        conflicts_with_all = ["target_error", "select", "sampler", "cost"])]
    pub time_limit: Option<Duration>,
}

fn error(text: &str) -> Result<f64, String> {
    parse_fraction(text)
        .ok()
        .filter(|error| *error > 0.0)
        .ok_or_else(|| "a number more than 0 and at most 1 is expected, as in 0.01 or 2/255".into())
}

fn duration(text: &str) -> Result<Duration, String> {
    // A number alone is one of seconds.
    let seconds = text.parse::<f64>().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    let time = seconds.or_else(|| humantime::parse_duration(text).ok()).filter(|time| !time.is_zero());
    time.ok_or("a time is expected, as in 2s, 500ms or 1m 30s".into()).and_then(not_too_long)
}
