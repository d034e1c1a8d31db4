//! Options whose values are times.

use std::time::Duration;

/// As long a time as anything here may take: more, added to the time of day, may be no time any more.
const LONGEST: Duration = Duration::from_secs(1000 * 24 * 60 * 60);

/// A time with its units.
pub(super) fn duration(text: &str) -> Result<Duration, String> {
    let time = humantime::parse_duration(text).map_err(|error| error.to_string())?;
    not_too_long(time)
}

/// A time that is not longer than anything here may take.
pub(super) fn not_too_long(time: Duration) -> Result<Duration, String> {
    if time <= LONGEST { Ok(time) } else { Err("at most 1000 days are expected".into()) }
}
