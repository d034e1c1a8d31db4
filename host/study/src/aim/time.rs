//! The best picture within a time limit, by progressive rendering.
//!
//! The first pass traces a coarse grid of pixels and may exceed the limit a few times, so that there is a picture. Finer
//! grids follow until the measured speed allows to trace all pixels, then more samples per pixel. After that the tolerance
//! of stochastic sampling is lowered as far as the required rays fit into the remaining time. A pass that does not finish
//! in time is aborted; the result is the picture of the last complete pass.

use std::time::{Duration, Instant};

use strahl_core::Rgb;
use strahl_engine::scheduler::{Outlook, Pass, PassStats};
use strahl_engine::{Progress, RenderError, RenderOptions, Scheduler};
use strahl_picture::{Picture, PictureFormat};
use strahl_scene::description::LoadedScene;
use strahl_session::{RenderOutput, SceneStorage, Session};
use strahl_settings::{ConfidenceSettings, ContrastSettings, SamplerSettings, SelectionSettings, Settings};

use super::{AimResult, AimTarget};

/// When the picture file must be complete.
#[derive(Clone, Copy, Debug)]
pub struct TimeLimit {
    /// Start of the program.
    pub start: Instant,
    /// The limit.
    pub duration: Duration,
    /// Format of the picture file.
    pub format: PictureFormat,
}

/// Renders the best picture that can be written in time.
pub fn render_in_time(
    description: &LoadedScene,
    settings: &Settings,
    options: &RenderOptions<'_>,
    limit: TimeLimit,
    progress: &dyn Progress,
) -> Result<(RenderOutput, AimResult), RenderError> {
    let mut scheduler = DeadlineScheduler::new(limit, settings);
    let mut storage = SceneStorage::new(description, settings.precision);
    let session = Session::new(&mut storage, &settings.acceleration())?;
    let output = session.refine(settings, options, progress, &mut scheduler)?;
    let pass = scheduler.last.unwrap_or(COARSEST_PASS);
    let chosen = Settings { sampler: pass.sampler, select: pass.select, ..settings.clone() };
    let why = scheduler.explanation(&chosen);
    let target = AimTarget::Time {
        requested: limit.duration.as_secs_f64(),
        passes: scheduler.completed_passes,
        aborted_a_pass: scheduler.started_passes > scheduler.completed_passes,
    };
    Ok((output, AimResult { settings: chosen, is_met: true, target, why }))
}

/// A pass that traces a grid of pixels and interpolates between them.
const fn coarse_pass(step: u32, threshold: f32) -> Pass {
    let contrast = ContrastSettings { threshold, items: false };
    let select = Some(SelectionSettings { step, contrast });
    Pass { sampler: SamplerSettings::Single, select, deadline: None }
}

/// The cheapest pass.
const COARSEST_PASS: Pass = coarse_pass(64, 1.0);

/// The time for the coarsest pass, relative to the limit: a late picture is better than none.
const FIRST_PASS_FACTOR: u32 = 4;
/// The minimum time for the coarsest pass.
const FIRST_PASS_MIN: Duration = Duration::from_secs(1);

/// Passes before all pixels are traced, from coarse to fine.
const COARSE_PASSES: [Pass; 5] = [
    coarse_pass(16, 1.0),
    coarse_pass(8, 1.0),
    coarse_pass(8, 0.1),
    coarse_pass(4, 0.05),
    coarse_pass(2, 0.02),
];

/// Candidates for the minimum samples per pixel: the largest one that leaves time for more is used.
const MIN_SAMPLES: [u32; 5] = [8, 6, 4, 3, 2];

/// Maximum samples per pixel.
const MAX_SAMPLES: u32 = strahl_core::image::StochasticSampler::MAX_SAMPLES;

/// Confidence of the mean of a pixel.
const CONFIDENCE_LEVEL: f64 = 0.9;

/// The finest tolerance, an eighth of a step of 8 bits: less is invisible.
const FINEST_TOLERANCE: f32 = 0.0005;

/// Planned duration of a pass, relative to the remaining time.
const PLANNED_SHARE: f64 = 0.85;

/// Maximum growth of the number of rays from pass to pass: predictions from few samples are uncertain.
const MAX_GROWTH: f64 = 3.0;

/// Remaining time, relative to the limit, in which no pass is started.
const MIN_REMAINING_SHARE: f64 = 0.03;

struct DeadlineScheduler {
    limit: TimeLimit,
    size: strahl_core::Resolution,
    last: Option<Pass>,
    completed_passes: usize,
    /// Number of started passes.
    started_passes: usize,
    /// Camera rays per second.
    rays_per_second: f64,
    /// Number of rays of the sampling passes.
    rays: u64,
    /// Duration of encoding the picture.
    write_seconds: f64,
    coarse_passes: std::slice::Iter<'static, Pass>,
    is_finest: bool,
}

impl DeadlineScheduler {
    fn new(limit: TimeLimit, settings: &Settings) -> Self {
        DeadlineScheduler {
            limit,
            size: settings.picture_size(),
            last: None,
            completed_passes: 0,
            started_passes: 0,
            rays_per_second: 0.0,
            rays: 0,
            write_seconds: 0.0,
            coarse_passes: COARSE_PASSES.iter(),
            is_finest: false,
        }
    }

    /// When tracing must end, so that the picture is written in time.
    fn deadline(&self) -> Instant {
        let time = self.limit.duration.as_secs_f64();
        let tracing = (time - 1.3 * self.write_seconds - 0.005 - 0.01 * time).max(0.0);
        self.limit.start + Duration::from_secs_f64(tracing)
    }

    /// Seconds until the deadline.
    fn seconds_left(&self) -> f64 {
        self.deadline().saturating_duration_since(Instant::now()).as_secs_f64()
    }

    /// Number of rays that can be traced before the deadline.
    fn affordable_rays(&self) -> f64 {
        self.rays_per_second * self.seconds_left()
    }

    /// The next pass after all pixels have been traced once.
    fn next_sampling_pass(&mut self, outlook: &Outlook<'_>) -> Option<Pass> {
        let affordable = PLANNED_SHARE * self.affordable_rays();
        let (least, before) = match self.last.map(|pass| pass.sampler) {
            Some(SamplerSettings::Stochastic { min_samples: least, confidence, .. }) => {
                (least, confidence.tolerance)
            }
            _ => {
                let fits = |least: &u32| f64::from(*least) * outlook.pixels as f64 <= 0.5 * affordable;
                let least = MIN_SAMPLES.into_iter().find(fits).unwrap_or(MIN_SAMPLES[MIN_SAMPLES.len() - 1]);
                return Some(stochastic_pass(least, 1.0));
            }
        };
        if before <= 1.01 * FINEST_TOLERANCE {
            self.is_finest = true;
            return None;
        }
        // The required rays grow as the tolerance falls: bisection finds the finest tolerance that fits.
        let most = affordable.min(MAX_GROWTH * self.rays as f64);
        let (mut low, mut high) = (f64::from(FINEST_TOLERANCE), f64::from(before));
        if (outlook.rays_for_tolerance)(FINEST_TOLERANCE) as f64 <= most {
            high = low;
        }
        for _ in 0..14 {
            let center = (low * high).sqrt();
            if (outlook.rays_for_tolerance)(center as f32) as f64 <= most {
                high = center
            } else {
                low = center
            }
        }
        let tolerance = round_up_to_three_digits(high);
        // The tolerance must decrease.
        let tolerance =
            if tolerance < before { tolerance } else { round_up_to_three_digits(0.98 * f64::from(before)) };
        Some(stochastic_pass(least, tolerance))
    }

    fn explanation(&self, settings: &Settings) -> String {
        let what = match settings.select {
            Some(select) => format!("selection {select}, {}", settings.sampler),
            None => settings.sampler.to_string(),
        };
        match self.last {
            Some(pass) if pass == COARSEST_PASS => {
                format!("{what}: the coarsest; no time for more")
            }
            _ if self.is_finest => format!("{what}: finer settings make no visible difference"),
            _ => format!("{what}: the finest that finished in time"),
        }
    }
}

fn stochastic_pass(min_samples: u32, tolerance: f32) -> Pass {
    let confidence = ConfidenceSettings { confidence: CONFIDENCE_LEVEL, tolerance };
    let sampler = SamplerSettings::Stochastic { min_samples, max_samples: MAX_SAMPLES, confidence };
    Pass { sampler, select: None, deadline: None }
}

/// Rounds up to three significant digits, which are easy to type.
fn round_up_to_three_digits(tolerance: f64) -> f32 {
    let step = libm::pow(10.0, libm::floor(libm::log10(tolerance)) - 2.0);
    format!("{:.7}", libm::ceil(tolerance / step) * step).parse().unwrap_or(1.0)
}

impl Scheduler for DeadlineScheduler {
    fn next(&mut self, outlook: &Outlook<'_>) -> Option<Pass> {
        self.started_passes += 1;
        let Some(last) = self.last else {
            let latest = self.limit.start + (FIRST_PASS_FACTOR * self.limit.duration).max(FIRST_PASS_MIN);
            return Some(Pass { deadline: Some(latest), ..COARSEST_PASS });
        };
        let deadline = Some(self.deadline());
        if self.seconds_left() <= MIN_REMAINING_SHARE * self.limit.duration.as_secs_f64() {
            self.started_passes -= 1;
            return None;
        }
        if outlook.untraced_pixels > 0 && last.select.is_some() {
            let fits = outlook.untraced_pixels as f64 <= 0.5 * self.affordable_rays();
            let grid = if fits { None } else { self.coarse_passes.next().copied() };
            let all = Pass { sampler: SamplerSettings::Single, select: None, deadline };
            return Some(grid.map_or(all, |grid| Pass { deadline, ..grid }));
        }
        match self.next_sampling_pass(outlook) {
            Some(pass) => Some(Pass { deadline, ..pass }),
            None => {
                self.started_passes -= 1;
                None
            }
        }
    }

    fn done(&mut self, pass: &Pass, stats: PassStats, picture: Vec<Rgb>) {
        self.completed_passes += 1;
        // Without rays there is no speed.
        if stats.rays > 0 && stats.seconds > 0.0 {
            self.rays_per_second = stats.rays as f64 / stats.seconds;
        }
        let is_new = match (self.last, pass.sampler) {
            (None, _) | (_, SamplerSettings::Single) => true,
            (Some(last), SamplerSettings::Stochastic { .. }) => {
                self.rays += stats.rays;
                last.sampler == SamplerSettings::Single
            }
            _ => false,
        };
        self.last = Some(Pass { deadline: None, ..*pass });
        // Measure the encoding time, if there is time for it.
        if is_new && self.seconds_left() > 4.0 * self.write_seconds {
            let clock = Instant::now();
            let written = self.limit.format.encode(&Picture { size: self.size, colors: picture });
            debug_assert!(written.is_ok());
            self.write_seconds = clock.elapsed().as_secs_f64();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_rounded_up_to_three_digits() {
        for (given, rounded_to) in [(0.123_41, "0.124"), (0.5, "0.5"), (0.000_488_28, "0.000489"), (1.0, "1")]
        {
            assert_eq!(round_up_to_three_digits(given).to_string(), rounded_to);
        }
    }
}
