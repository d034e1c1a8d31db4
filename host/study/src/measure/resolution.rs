//! Size of the pictures of a study, from its time limit.
//!
//! The reference must be at least as fine as the settings of the scene, and needs most of the time. These settings are
//! rendered at a small size with one ray per pixel (the probe); its time gives the number of pixels that the limit allows. A
//! size given by the user is kept; if it is too large, the study fails at once.

use std::time::Duration;

use strahl_core::Resolution;
use strahl_settings::Settings;

use super::benchmark::Benchmark;
use super::plan::one_ray_per_pixel;
use super::plan::{StudyPlan, time};
use crate::error::StudyError;
use crate::record::{RunRole, StudyRun};

/// Maximum number of pixels of the probe.
const PROBE_PIXELS: u32 = 1 << 10;

/// Number of probes, if there is time.
const PROBE_COUNT: usize = 3;

/// Pictures are not reduced below this number of pixels only to measure more settings.
const PREFERRED_PIXELS: u32 = 1 << 14;

/// Minimum number of pixels.
const MIN_PIXELS: u32 = 1 << 11;

/// The reference is planned to take this share of its time: the probe is small, and a second study must succeed too.
const MARGIN: f64 = 0.7;

/// Cost of the reference and of the whole study.
#[derive(Clone, Copy, Debug, PartialEq)]
struct ReferenceCost {
    /// Seconds per camera ray with the levels and cutoff of the scene.
    pixel: f64,
    /// Minimum rays per pixel of the reference.
    reference: f64,
    /// Rays per pixel of all measurements.
    all: f64,
}

/// Number of pixels that the time limit allows.
#[derive(Clone, Copy, Debug, PartialEq)]
enum AffordableSize {
    /// This number of pixels.
    Pixels(f64),
    /// The limit is too short; this number of seconds is long enough.
    TooShort(f64),
}

impl ReferenceCost {
    /// Number of pixels, at most `most`, for `limit` seconds. Less than `most` only if the size `is_free`.
    fn afforded(&self, limit: f64, most: f64, is_free: bool) -> AffordableSize {
        let least = if is_free && f64::from(MIN_PIXELS) < most { f64::from(MIN_PIXELS) } else { most };
        // Pixels whose reference fits into its share of the time; below, those for which everything fits.
        let for_reference = time::REFERENCE * limit / (self.reference * self.pixel).max(1e-12);
        if for_reference < least {
            // Half as much again, because the speed of a machine varies.
            return AffordableSize::TooShort(1.5 * limit * least / for_reference.max(1e-12));
        }
        let for_all = limit / (self.all * self.pixel).max(1e-12);
        let comfortable = f64::from(PREFERRED_PIXELS);
        let preferred = if for_all > comfortable { for_all } else { comfortable };
        let sure = MARGIN * for_reference;
        let pixels = if preferred < sure { preferred } else { sure };
        let pixels = if pixels > least { pixels } else { least };
        AffordableSize::Pixels(if is_free && pixels < most { pixels } else { most })
    }
}

/// Chooses the size of the pictures: the current one, or a smaller one with the same aspect ratio if the size `is_free`.
pub(crate) fn choose_size(
    bench: &mut Benchmark<'_>,
    plan: &StudyPlan,
    own: &Settings,
    is_free: bool,
) -> Result<(), StudyError> {
    let Some(limit) = bench.limit.map(|limit| limit.as_secs_f64()) else { return Ok(()) };
    let size = bench.size;
    let pixels = f64::from(size.width()) * f64::from(size.height());
    bench.size = scaled_down(size, PROBE_PIXELS);
    let probed = f64::from(bench.size.width()) * f64::from(bench.size.height());
    let begun = bench.elapsed();
    let mut probe: Option<StudyRun> = None;
    for _ in 0..PROBE_COUNT {
        let left = bench.time_share(time::PROBE) - (bench.elapsed() - begun);
        let Some(taken) = bench.measure(RunRole::Knob, &one_ray_per_pixel(own), left)? else { break };
        // The fastest: other load only makes a probe slower.
        probe = Some(match probe {
            Some(probe) if probe.elapsed_seconds[0] <= taken.run.elapsed_seconds[0] => probe,
            _ => taken.run,
        });
    }
    bench.size = size;

    let Some(probe) = probe else { return Err(too_short_error(bench, None)) };
    bench.set_build_time(probe.build);
    let reference = f64::from(plan.min_reference_samples(own));
    let all = reference + plan.total_rays_per_pixel(own.filter, plan.reference[1]);
    let cost = ReferenceCost { pixel: probe.elapsed_seconds[0] / probed, reference, all };
    match cost.afforded(limit, pixels, is_free) {
        AffordableSize::Pixels(pixels) => bench.size = scaled_down(size, pixels as u32),
        AffordableSize::TooShort(enough) => return Err(too_short_error(bench, Some(enough))),
    }
    Ok(())
}

/// The error for a time limit that is too short; it names a sufficient one, if known.
pub(super) fn too_short_error(bench: &Benchmark<'_>, enough: Option<f64>) -> StudyError {
    let limit = bench.limit.unwrap_or_default();
    // Without spaces, as one command-line argument.
    let text = |seconds| humantime::format_duration(round_up_duration(seconds)).to_string().replace(' ', "");
    let enough = match enough {
        Some(seconds) => format!("use --time-limit {} or a smaller --size", text(seconds)),
        None => {
            format!(
                "the time needed is not known yet; try --time-limit {} or a smaller --size",
                text(10.0 * limit.as_secs_f64())
            )
        }
    };
    StudyError::TooShort(format!(
        "{} is too short for a reference at least as fine as the scene's settings; {enough}",
        humantime::format_duration(limit),
    ))
}

/// Rounds up to whole seconds, tens of seconds, minutes or hours.
fn round_up_duration(seconds: f64) -> Duration {
    let step = if seconds <= 20.0 {
        1.0
    } else if seconds <= 120.0 {
        10.0
    } else if seconds <= 3600.0 {
        60.0
    } else {
        3600.0
    };
    Duration::try_from_secs_f64((seconds / step).ceil() * step).unwrap_or(Duration::MAX)
}

/// A size with the same aspect ratio and at most about `pixels` pixels.
pub(crate) fn scaled_down(size: Resolution, pixels: u32) -> Resolution {
    let (width, height) = (f64::from(size.width()), f64::from(size.height()));
    let scale = (f64::from(pixels) / (width * height)).sqrt();
    let scaled = |side: f64| (side * scale).round().max(1.0) as u32;
    if scale < 1.0 { Resolution::new(scaled(width), scaled(height)).unwrap_or(size) } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COST: ReferenceCost = ReferenceCost { pixel: 1e-5, reference: 32.0, all: 500.0 };

    #[test]
    fn a_reduced_size_keeps_the_aspect_ratio() {
        let smaller = |width, height| {
            let size = scaled_down(Resolution::new(width, height).unwrap(), 1 << 16);
            (size.width(), size.height())
        };
        assert_eq!(smaller(640, 480), (296, 222));
        assert_eq!(smaller(512, 512), (256, 256));
        assert_eq!([smaller(256, 256), smaller(40, 30)], [(256, 256), (40, 30)]);
        assert_eq!(smaller(60_000, 4), (31_353, 2));
    }

    #[test]
    fn a_shorter_limit_gives_smaller_pictures() {
        let pixels = |limit| match COST.afforded(limit, 65536.0, true) {
            AffordableSize::Pixels(pixels) => pixels,
            AffordableSize::TooShort(enough) => panic!("{limit} s are too short, {enough} would be enough"),
        };
        assert_eq!(pixels(1000.0), 65536.0);
        // Everything can be measured.
        assert!((pixels(200.0) - 40_000.0).abs() < 1.0);
        // Not everything can be measured, but the reference can be rendered.
        assert_eq!(pixels(50.0), f64::from(PREFERRED_PIXELS));
        assert!((pixels(5.0) - MARGIN * time::REFERENCE * 5.0 / (32.0 * 1e-5)).abs() < 1.0);
    }

    #[test]
    fn the_sufficient_limit_is_sufficient_and_not_much_too_long() {
        for (limit, most, is_free) in [(0.5, 65536.0, true), (5.0, 65536.0, false), (0.01, 100.0, true)] {
            let AffordableSize::TooShort(enough) = COST.afforded(limit, most, is_free) else {
                panic!("{limit} s are said to be enough")
            };
            assert!(enough > limit);
            assert!(matches!(COST.afforded(enough, most, is_free), AffordableSize::Pixels(_)));
            assert!(matches!(COST.afforded(0.5 * enough, most, is_free), AffordableSize::TooShort(_)));
        }
    }

    #[test]
    fn a_given_size_is_not_reduced() {
        assert_eq!(COST.afforded(100.0, 65536.0, false), AffordableSize::Pixels(65536.0));
        assert!(matches!(COST.afforded(20.0, 65536.0, false), AffordableSize::TooShort(_)));
    }

    #[test]
    fn limits_are_rounded_to_usual_durations() {
        let durations = [3.2, 47.0, 130.0, 4000.0]
            .map(|it| humantime::format_duration(round_up_duration(it)).to_string());
        assert_eq!(durations, ["4s", "50s", "3m", "2h"]);
    }
}
