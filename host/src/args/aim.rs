//! Options of `render` only: target error, time limit and cost map.

use std::path::PathBuf;
use std::time::Duration;

use strahl_settings::domain::parse_fraction;

use super::times::checked_duration;

/// Target error, time limit and cost map.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct AimArgs {
    /// Write the cost of each pixel (rays, tests, levels) as a heat map, or with .exr as float channels.
    #[arg(long, value_name = "FILE")]
    pub cost: Option<PathBuf>,

    /// Choose the cheapest --levels, --cutoff, --sampler and --select whose estimated error is at most E:
    /// the root mean square of sRGB-encoded differences (0 to 1, as in 0.01 or 2/255) from a high-quality
    /// reference, estimated on a sparse sample of pixels. Settings given on the command line are kept;
    /// those of the scene are not. The exit status is 1 if no setting reaches E.
    #[arg(long, value_name = "E", value_parser = target_error, allow_negative_numbers = true)]
    pub target_error: Option<f64>,

    /// Render the reference too, with other random numbers, and print the measured error; the exit status
    /// is 1 if it is more than E. Slow.
    #[arg(long, requires = "target_error")]
    pub verify: bool,

    /// Write the best picture possible within this time, as in 2s or 1m 30s, counted from program start: a
    /// coarse grid of pixels first, then all pixels, then more samples where the estimated error is
    /// largest. The written picture is always complete. --levels and --cutoff are not changed.
    #[arg(long, value_name = "T", value_parser = duration, allow_hyphen_values = true,
        conflicts_with_all = ["target_error", "select", "sampler", "cost"])]
    pub time_limit: Option<Duration>,
}

fn target_error(text: &str) -> Result<f64, String> {
    parse_fraction(text)
        .ok()
        .filter(|error| *error > 0.0)
        .ok_or_else(|| "must be more than 0 and at most 1, as in 0.01 or 2/255".into())
}

fn duration(text: &str) -> Result<Duration, String> {
    // A number without a unit is in seconds.
    let seconds = text.parse::<f64>().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    let time = seconds.or_else(|| humantime::parse_duration(text).ok()).filter(|time| !time.is_zero());
    time.ok_or("must be a duration, as in 2s, 500ms or 1m 30s".into()).and_then(checked_duration)
}
