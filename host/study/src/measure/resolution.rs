//! How large a picture there is time to study.
//!
//! A study stands and falls with its reference, which must be no coarser than the scene's own
//! setting. So that setting is traced once at a small size, with one ray in each pixel, and what
//! it takes tells how many pixels there is time for. Where the user has named a size there is
//! nothing to choose, but what cannot be done is told before the time is gone.

use std::time::Duration;

use strahl_core::Resolution;
use strahl_settings::Settings;

use super::benchmark::Benchmark;
use super::plan::one_ray_per_pixel;
use super::plan::{StudyPlan, time};
use crate::error::StudyError;
use crate::record::{RunRole, StudyRun};

/// The probe has at most so many pixels.
const PROBE_PIXELS: u32 = 1 << 10;

/// It is traced so many times, if there is time.
const PROBE_COUNT: usize = 3;

/// Pictures are not made smaller than this, only so that more settings can be measured.
const PREFERRED_PIXELS: u32 = 1 << 14;

/// Nor smaller than this at all: less has nothing to look at.
const MIN_PIXELS: u32 = 1 << 11;

/// A size is chosen so that its reference takes this share of the time that it may take: the probe is a small one,
/// and the same study must be possible again.
const MARGIN: f64 = 0.7;

/// What the reference of a size asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
struct ReferenceCost {
    /// Seconds for one ray through a pixel, at the scene's own levels and cutoff.
    pixel: f64,
    /// Rays in a pixel that the reference has at least.
    reference: f64,
    /// Rays in a pixel of all that is measured.
    all: f64,
}

/// How many pixels there is time for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum AffordableSize {
    /// So many of them.
    Pixels(f64),
    /// Not enough; so many seconds would be.
    TooShort(f64),
}

impl ReferenceCost {
    /// How many of `most` pixels can be studied in `limit` seconds; fewer only where `is_free`.
    fn afforded(&self, limit: f64, most: f64, is_free: bool) -> AffordableSize {
        let least = if is_free && f64::from(MIN_PIXELS) < most { f64::from(MIN_PIXELS) } else { most };
        // Pixels whose reference ends in its share of the time, and those for which everything ends.
        let for_reference = time::REFERENCE * limit / (self.reference * self.pixel).max(1e-12);
        if for_reference < least {
            // Machines are not as fast at all times: half as much again.
            return AffordableSize::TooShort(1.5 * limit * least / for_reference.max(1e-12));
        }
        let for_all = limit / (self.all * self.pixel).max(1e-12);
        let comfortable = f64::from(PREFERRED_PIXELS);
        let wanted = if for_all > comfortable { for_all } else { comfortable };
        let sure = MARGIN * for_reference;
        let pixels = if wanted < sure { wanted } else { sure };
        let pixels = if pixels > least { pixels } else { least };
        AffordableSize::Pixels(if is_free && pixels < most { pixels } else { most })
    }
}

/// Chooses the size of the bench's pictures: that which it has, or a smaller one of the same shape where
/// `is_free` and the time asks for it.
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
        // The quickest: other work on the machine makes it slower only.
        probe = Some(match probe {
            Some(probe) if probe.wall[0] <= taken.run.wall[0] => probe,
            _ => taken.run,
        });
    }
    bench.size = size;

    let Some(probe) = probe else { return Err(too_short_error(bench, None)) };
    bench.set_build_time(probe.build);
    let reference = f64::from(plan.min_reference_samples(own));
    let all = reference + plan.total_rays_per_pixel(own.filter, plan.reference[1]);
    let cost = ReferenceCost { pixel: probe.wall[0] / probed, reference, all };
    match cost.afforded(limit, pixels, is_free) {
        AffordableSize::Pixels(pixels) => bench.size = scaled_down(size, pixels as u32),
        AffordableSize::TooShort(enough) => return Err(too_short_error(bench, Some(enough))),
    }
    Ok(())
}

/// That the time does not suffice, and how many seconds would, where that is known.
pub(super) fn too_short_error(bench: &Benchmark<'_>, enough: Option<f64>) -> StudyError {
    let limit = bench.limit.unwrap_or_default();
    // As one word of the command line.
    let told = |seconds| humantime::format_duration(round_up_duration(seconds)).to_string().replace(' ', "");
    let enough = match enough {
        Some(seconds) => format!("--time-limit {} would be enough", told(seconds)),
        None => {
            format!(
                "how much it takes is not known yet, --time-limit {} may do",
                told(10.0 * limit.as_secs_f64())
            )
        }
    };
    StudyError::TooShort(format!(
        "{} is too short to make a reference that is no coarser than the scene's own setting: {enough}, or a \
         smaller --size",
        humantime::format_duration(limit),
    ))
}

/// Up to a time that people would say.
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

/// A size of the same shape with at most about so many pixels.
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
    fn a_size_is_a_smaller_one_of_the_same_shape() {
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
    fn pictures_are_smaller_where_time_is_shorter() {
        let pixels = |limit| match COST.afforded(limit, 65536.0, true) {
            AffordableSize::Pixels(pixels) => pixels,
            AffordableSize::TooShort(enough) => panic!("{limit} s are too short, {enough} would be enough"),
        };
        assert_eq!(pixels(1000.0), 65536.0);
        // Everything can be measured of so many.
        assert!((pixels(200.0) - 40_000.0).abs() < 1.0);
        // Not everything, but the reference can be made.
        assert_eq!(pixels(50.0), f64::from(PREFERRED_PIXELS));
        assert!((pixels(5.0) - MARGIN * time::REFERENCE * 5.0 / (32.0 * 1e-5)).abs() < 1.0);
    }

    #[test]
    fn what_would_be_enough_is_enough_and_not_much_more() {
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
    fn a_size_that_was_named_is_kept() {
        assert_eq!(COST.afforded(100.0, 65536.0, false), AffordableSize::Pixels(65536.0));
        assert!(matches!(COST.afforded(20.0, 65536.0, false), AffordableSize::TooShort(_)));
    }

    #[test]
    fn limits_are_told_as_people_say_them() {
        let told = [3.2, 47.0, 130.0, 4000.0]
            .map(|it| humantime::format_duration(round_up_duration(it)).to_string());
        assert_eq!(told, ["4s", "50s", "3m", "2h"]);
    }
}
