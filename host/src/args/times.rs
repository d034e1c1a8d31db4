//! Options with durations.

use std::time::Duration;

/// Longest duration of an option, so that adding it to the current time cannot overflow.
const MAX_DURATION: Duration = Duration::from_secs(1000 * 24 * 60 * 60);

/// A duration with its units.
pub(super) fn duration(text: &str) -> Result<Duration, String> {
    let time = humantime::parse_duration(text).map_err(|error| error.to_string())?;
    checked_duration(time)
}

/// The duration, or an error if it is longer than [`MAX_DURATION`].
pub(super) fn checked_duration(time: Duration) -> Result<Duration, String> {
    if time <= MAX_DURATION { Ok(time) } else { Err("must be at most 1000 days".into()) }
}
