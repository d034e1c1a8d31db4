//! Words become numbers and sizes, by rules that options of several commands share.

use std::time::Duration;

use clap::builder::RangedI64ValueParser;
use strahl_core::Size;

use crate::wanted::LEVELS;

/// The most pixels of a picture: its linear colours take 12 bytes each.
pub const MOST_PIXELS: u64 = 1 << 28;

/// Width and height of a picture.
pub(super) fn size(text: &str) -> Result<Size, String> {
    let parts = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let Some((width, height)) = parts else {
        return Err("two whole numbers with an x between them are expected, as in 640x480".into());
    };
    match Size::new(width, height) {
        Some(size) if u64::from(width) * u64::from(height) <= MOST_PIXELS => Ok(size),
        Some(_) => Err(format!("a picture has at most {MOST_PIXELS} pixels")),
        None => Err(format!("each side must be between 1 and {}", Size::MOST)),
    }
}

/// A number of levels of rays.
pub(super) fn levels() -> RangedI64ValueParser<u8> {
    clap::value_parser!(u8).range(1..=LEVELS as i64)
}

/// A number from 0 to 1 in the precision of the tracer, or a fraction.
pub(super) fn cutoff(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(cutoff) if cutoff >= 0.0 && cutoff <= 1.0 => Ok(cutoff),
        _ => share(text).map(|share| share as f32),
    }
}

/// A number from 0 to 1, or a fraction.
pub(super) fn share(text: &str) -> Result<f64, String> {
    let value = match text.split_once('/') {
        Some((part, whole)) => part.parse::<f64>().and_then(|part| Ok(part / whole.parse::<f64>()?)),
        None => text.parse::<f64>(),
    };
    match value {
        Ok(share) if share >= 0.0 && share <= 1.0 => Ok(share),
        _ => Err("a number between 0 and 1 is expected, as in 0.01 or 1/255".into()),
    }
}

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

/// A number of threads.
pub(super) fn threads(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(threads) if (1..=1024).contains(&threads) => Ok(threads),
        _ => Err("a whole number between 1 and 1024 is expected".into()),
    }
}

/// One of some sizes for which the program was built.
pub(super) fn one_of(sizes: &[usize], text: &str) -> Result<usize, String> {
    let is_text = |size: &&usize| text.parse() == Ok(**size);
    sizes.iter().find(is_text).copied().ok_or_else(|| {
        let names: Vec<_> = sizes.iter().map(usize::to_string).collect();
        let (last, others) =
            names.split_last().map_or(("", &[][..]), |(last, others)| (last.as_str(), others));
        format!("{} or {last} is expected", others.join(", "))
    })
}
