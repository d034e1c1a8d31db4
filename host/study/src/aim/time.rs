//! The best picture that is there in time.
//!
//! A coarse raster of pixels is traced at once, though it take a few times as long, so that there is a
//! picture. Then come finer rasters, until the speed that was measured says that all pixels can be traced;
//! then more samples in each, and after that in those whose mean is least certain: the tolerance of
//! the stochastic rule goes down as far as the rays that are needed fit into the time that is left. A
//! pass that is not complete in time is given up, and the picture is that of the last that was.

use std::time::{Duration, Instant};

use strahl_core::Rgb;
use strahl_engine::scheduler::{Outlook, Pass, PassStats};
use strahl_engine::{Progress, RenderError, RenderOptions, Scheduler};
use strahl_picture::{Picture, PictureFormat};
use strahl_scene::description::LoadedScene;
use strahl_settings::{ConfidenceSettings, ContrastSettings, SamplerSettings, SelectionSettings, Settings};

use super::{AimResult, AimTarget};
use strahl_session::{RenderOutput, SceneStorage, Session};

/// When the picture must be written.
#[derive(Clone, Copy, Debug)]
pub struct TimeLimit {
    /// When the program began.
    pub start: Instant,
    /// The time that there is.
    pub duration: Duration,
    /// As what it is written.
    pub format: PictureFormat,
}

/// Traces as good a picture as is written in time.
pub fn render_in_time(
    description: &LoadedScene,
    settings: &Settings,
    options: &RenderOptions<'_>,
    limit: TimeLimit,
    progress: &dyn Progress,
) -> Result<(RenderOutput, AimResult), RenderError> {
    let mut clock = DeadlineScheduler::new(limit, settings);
    let mut storage = SceneStorage::new(description, settings.precision);
    let session = Session::new(&mut storage, &settings.acceleration())?;
    let output = session.refine(settings, options, progress, &mut clock)?;
    let pass = clock.last.unwrap_or(COARSEST_PASS);
    let taken = Settings { sampler: pass.sampler, select: pass.select, ..settings.clone() };
    let why = clock.why(&taken);
    let target = AimTarget::Time {
        asked: limit.duration.as_secs_f64(),
        passes: clock.completed_passes,
        given_up: clock.started_passes > clock.completed_passes,
    };
    Ok((output, AimResult { settings: taken, kept: true, target, why }))
}

/// Everything between two pixels that are this far apart is guessed.
const fn coarse_pass(step: u32, threshold: f32) -> Pass {
    let agreement = ContrastSettings { threshold, items: false };
    let select = Some(SelectionSettings { step, contrast: agreement });
    Pass { sampler: SamplerSettings::Single, select, until: None }
}

/// Takes no time at all, but where the tree of a single ray does.
const COARSEST_PASS: Pass = coarse_pass(64, 1.0);

/// How many times the time that there is the coarsest pass may take, and the least time that it has. A
/// picture that is late is better than none; but one that never comes is not.
const FIRST_MAY_TAKE: u32 = 4;
/// See [`FIRST_MAY_TAKE`].
const FIRST_HAS: Duration = Duration::from_secs(1);

/// Before all pixels are traced, the finer the later.
const RASTERS: [Pass; 5] = [
    coarse_pass(16, 1.0),
    coarse_pass(8, 1.0),
    coarse_pass(8, 0.1),
    coarse_pass(4, 0.05),
    coarse_pass(2, 0.02),
];

/// The least samples of a pixel, where there is time for more than one: the largest of these that
/// leaves time for more where it is needed.
const LEAST: [u32; 5] = [8, 6, 4, 3, 2];

/// The most.
const MOST: u32 = strahl_core::image::StochasticSampler::MAX_SAMPLES;

/// How sure the rule is of the mean of a pixel.
const LEVEL: f64 = 0.9;

/// An eighth of a step of eight bits: less cannot be seen by anybody.
const FINEST: f32 = 0.0005;

/// Which part of the time that is left a pass is planned to take.
const PLANNED: f64 = 0.85;

/// A pass of more samples asks for at most this many times the rays that there were, for of few
/// samples little is known of how many it takes.
const GROWTH: f64 = 3.0;

/// A time that is left, as a part of all time, in which nothing more is begun.
const NOTHING: f64 = 0.03;

struct DeadlineScheduler {
    limit: TimeLimit,
    size: strahl_core::Resolution,
    last: Option<Pass>,
    completed_passes: usize,
    /// Passes that were begun.
    started_passes: usize,
    /// Rays through the picture in a second.
    rays_per_second: f64,
    /// Rays of samples.
    rays: u64,
    /// Seconds that it takes to write the picture.
    write_seconds: f64,
    rasters: std::slice::Iter<'static, Pass>,
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
            rasters: RASTERS.iter(),
            is_finest: false,
        }
    }

    /// When tracing must end, so that the picture is written in time.
    fn end(&self) -> Instant {
        let time = self.limit.duration.as_secs_f64();
        let tracing = (time - 1.3 * self.write_seconds - 0.005 - 0.01 * time).max(0.0);
        self.limit.start + Duration::from_secs_f64(tracing)
    }

    /// Seconds until then.
    fn left(&self) -> f64 {
        self.end().saturating_duration_since(Instant::now()).as_secs_f64()
    }

    /// Rays for which there is time.
    fn affordable(&self) -> f64 {
        self.rays_per_second * self.left()
    }

    /// What comes after all pixels have been traced once.
    fn samples(&mut self, outlook: &Outlook<'_>) -> Option<Pass> {
        let affordable = PLANNED * self.affordable();
        let (least, before) = match self.last.map(|pass| pass.sampler) {
            Some(SamplerSettings::Stochastic { min_samples: least, confidence, .. }) => {
                (least, confidence.tolerance)
            }
            _ => {
                let fits = |least: &u32| f64::from(*least) * outlook.pixels as f64 <= 0.5 * affordable;
                let least = LEAST.into_iter().find(fits).unwrap_or(LEAST[LEAST.len() - 1]);
                return Some(stochastic(least, 1.0));
            }
        };
        if before <= 1.01 * FINEST {
            self.is_finest = true;
            return None;
        }
        // The needed rays grow as the tolerance falls, so that halving finds the finest that fits.
        let most = affordable.min(GROWTH * self.rays as f64);
        let (mut low, mut high) = (f64::from(FINEST), f64::from(before));
        if (outlook.needs)(FINEST) as f64 <= most {
            high = low;
        }
        for _ in 0..14 {
            let middle = (low * high).sqrt();
            if (outlook.needs)(middle as f32) as f64 <= most { high = middle } else { low = middle }
        }
        let tolerance = rounded(high);
        // No better than before: whatever is left, is too little for a pass.
        let tolerance = if tolerance < before { tolerance } else { rounded(0.98 * f64::from(before)) };
        Some(stochastic(least, tolerance))
    }

    fn why(&self, taken: &Settings) -> String {
        let what = match taken.select {
            Some(select) => format!("selection {select}, {}", taken.sampler),
            None => taken.sampler.to_string(),
        };
        match self.last {
            Some(pass) if pass == COARSEST_PASS => {
                format!("{what}: the coarsest, there was no time for more")
            }
            _ if self.is_finest => format!("{what}: finer makes no difference that can be seen"),
            _ => format!("{what}: the finest that was complete in time"),
        }
    }
}

fn stochastic(least: u32, tolerance: f32) -> Pass {
    let confidence = ConfidenceSettings { confidence: LEVEL, tolerance };
    let sampler = SamplerSettings::Stochastic { min_samples: least, max_samples: MOST, confidence };
    Pass { sampler, select: None, until: None }
}

/// With three digits, which can be typed.
fn rounded(tolerance: f64) -> f32 {
    let step = libm::pow(10.0, libm::floor(libm::log10(tolerance)) - 2.0);
    format!("{:.7}", libm::ceil(tolerance / step) * step).parse().unwrap_or(1.0)
}

impl Scheduler for DeadlineScheduler {
    fn next(&mut self, outlook: &Outlook<'_>) -> Option<Pass> {
        self.started_passes += 1;
        let Some(last) = self.last else {
            let latest = self.limit.start + (FIRST_MAY_TAKE * self.limit.duration).max(FIRST_HAS);
            return Some(Pass { until: Some(latest), ..COARSEST_PASS });
        };
        let until = Some(self.end());
        if self.left() <= NOTHING * self.limit.duration.as_secs_f64() {
            self.started_passes -= 1;
            return None;
        }
        if outlook.missing > 0 && last.select.is_some() {
            let fits = outlook.missing as f64 <= 0.5 * self.affordable();
            let raster = if fits { None } else { self.rasters.next().copied() };
            let all = Pass { sampler: SamplerSettings::Single, select: None, until };
            return Some(raster.map_or(all, |raster| Pass { until, ..raster }));
        }
        match self.samples(outlook) {
            Some(pass) => Some(Pass { until, ..pass }),
            None => {
                self.started_passes -= 1;
                None
            }
        }
    }

    fn done(&mut self, pass: &Pass, stats: PassStats, picture: Vec<Rgb>) {
        self.completed_passes += 1;
        // A few rays tell no speed.
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
        self.last = Some(Pass { until: None, ..*pass });
        // How long it takes to write such a picture, where there is time to find out.
        if is_new && self.left() > 4.0 * self.write_seconds {
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
            assert_eq!(rounded(given).to_string(), rounded_to);
        }
    }
}
