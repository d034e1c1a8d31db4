//! Measurement of one setting: one scene, one size, and a time limit.

use std::cell::Cell;
use std::time::{Duration, Instant};

use strahl_core::{Resolution, Rgb};
use strahl_engine::cost_map::PixelCost;
use strahl_engine::progress::Deadline;
use strahl_engine::{CostMap, Interrupt, NoProgress, Progress, RenderError, RenderOptions};
use strahl_picture::difference::{Limit, Pair};
use strahl_picture::{Picture, PixelValues};
use strahl_scene::description::LoadedScene;
use strahl_scene::effects::disable;
use strahl_settings::Settings;

use super::plan::time;
use crate::cost_model::{WEIGHTS, event_counts};
use crate::record::command_line;
use crate::record::{ErrorMetrics, RunRole, RunSettings, StudyRun};
use strahl_session::RenderOutput;

/// Progress and cancellation of a study.
pub trait StudyProgress: Progress {
    /// Measurement of a setting starts; its command-line options.
    fn measuring(&self, _setting: &str) {}

    /// Elapsed seconds, and an estimate of the remaining seconds.
    fn time(&self, _elapsed: f64, _left: f64) {}
}

impl StudyProgress for NoProgress {}

/// A scene to be measured at one size within a time limit.
pub struct Benchmark<'b> {
    /// The scene.
    pub scene: &'b LoadedScene,
    /// The size of all pictures.
    pub size: Resolution,
    /// Receives the progress.
    pub progress: &'b dyn StudyProgress,
    /// Start of the study.
    pub start: Instant,
    /// Time limit of the study.
    pub limit: Option<Duration>,
    /// Seconds to build tables and accelerator.
    build: Cell<f64>,
}

/// A measured setting.
pub struct Measurement {
    /// The settings.
    pub settings: Settings,
    /// Time, counts and error; the error is set once the reference exists.
    pub run: StudyRun,
    /// The picture, until it is not needed any more.
    pub picture: Option<Picture>,
}

impl<'b> Benchmark<'b> {
    /// A benchmark of pictures of `size` that starts now and ends after `limit`.
    pub fn new(
        scene: &'b LoadedScene,
        size: Resolution,
        progress: &'b dyn StudyProgress,
        limit: Option<Duration>,
    ) -> Self {
        Benchmark { scene, size, progress, start: Instant::now(), limit, build: Cell::new(0.0) }
    }

    /// Sets the seconds to build tables and accelerator, which do not count against the limit of a setting.
    pub(super) fn set_build_time(&self, seconds: f64) {
        self.build.set(seconds);
    }

    /// Seconds since the study began.
    pub fn elapsed(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// Reports the remaining seconds.
    pub(super) fn report_seconds_left(&self, seconds: f64) {
        self.progress.time(self.elapsed(), seconds);
    }

    /// A share of the time limit, in seconds; infinite without a limit.
    pub fn time_share(&self, share: f64) -> f64 {
        self.limit.map_or(f64::INFINITY, |limit| share * limit.as_secs_f64())
    }

    /// Renders once. `None` if it takes more than `max_seconds`, or more than the study has left.
    pub fn trace(&self, settings: &Settings, max_seconds: f64) -> Result<Option<RenderOutput>, RenderError> {
        self.trace_with_options(settings, &RenderOptions::COUNT_TESTS, max_seconds)
    }

    /// The cost of each pixel, row by row. `None` if no time is left.
    pub fn costs(&self, options: &Settings) -> Result<Option<Vec<PixelCost>>, RenderError> {
        let cost_map = CostMap::new(self.size);
        let counting = RenderOptions { cost_map: Some(&cost_map), ..RenderOptions::default() };
        Ok(self.trace_with_options(options, &counting, f64::INFINITY)?.map(|_| cost_map.costs()))
    }

    fn trace_with_options(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        max_seconds: f64,
    ) -> Result<Option<RenderOutput>, RenderError> {
        self.progress.measuring(&command_line(settings));
        // At most the remaining time of the study.
        let (max_seconds, left) =
            (max_seconds + self.build.get(), self.time_share(time::TRACING_END) - self.elapsed());
        let max_seconds = if max_seconds < left { max_seconds } else { left };
        if max_seconds <= 0.0 {
            return Ok(None);
        }
        // A duration beyond the range of the clock means no deadline.
        let end =
            Duration::try_from_secs_f64(max_seconds).ok().and_then(|max| Instant::now().checked_add(max));
        let progress = Deadline::new(self.progress, end);
        let settings = &Settings { size: self.size, ..settings.clone() };
        let traced = if settings.without.is_empty() {
            strahl_session::render(self.scene, settings, options, &progress)
        } else {
            let mut scene = self.scene.clone();
            disable(&mut scene, &settings.without);
            strahl_session::render(&scene, settings, options, &progress)
        };
        match traced {
            Ok(output) => Ok(Some(output)),
            Err(RenderError::Interrupted(Interrupt::TimeLimit)) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Renders and measures for the first time.
    pub fn measure(
        &self,
        role: RunRole,
        settings: &Settings,
        max_seconds: f64,
    ) -> Result<Option<Measurement>, RenderError> {
        let Some(output) = self.trace(settings, max_seconds)? else { return Ok(None) };
        let counts = event_counts(&output.counters);
        let choice = &output.accelerator.choice;
        let run = StudyRun {
            role,
            setting: RunSettings::new(settings, choice),
            cpu_seconds: vec![output.trace_cpu.as_secs_f64()],
            elapsed_seconds: vec![output.trace.as_secs_f64()],
            build: output.build.as_secs_f64(),
            work: WEIGHTS.instructions(&counts, choice.kind.name()),
            counts,
            error: ErrorMetrics::default(),
            cut: output.counters.cut_fractions(),
            digest: output.picture.digest().to_hex().to_string(),
        };
        Ok(Some(Measurement { settings: settings.clone(), run, picture: Some(output.picture) }))
    }

    /// Renders again and adds the times.
    pub fn repeat(&self, measurement: &mut Measurement) -> Result<(), RenderError> {
        if let Some(output) = self.trace(&measurement.settings, f64::INFINITY)? {
            measurement.run.cpu_seconds.push(output.trace_cpu.as_secs_f64());
            measurement.run.elapsed_seconds.push(output.trace.as_secs_f64());
        }
        Ok(())
    }
}

/// The error of a picture, compared with a reference of the same size.
pub fn error_metrics(picture: &Picture, reference: &Picture) -> ErrorMetrics {
    let size = picture.size;
    let pair = picture_pair(picture, reference);
    let measures = pair.measure(size.width() as usize, Limit::Identical);
    let pixels = picture.colors.len().max(1) as f64;
    ErrorMetrics {
        rmse: (measures.squares / (3.0 * pixels)).sqrt(),
        largest: measures.peak.difference,
        beyond: measures.beyond as f64 / pixels,
        ssim: pair.ssim(size),
    }
}

/// Two pictures to be compared.
pub fn picture_pair(picture: &Picture, reference: &Picture) -> Pair {
    Pair::of(PixelValues::Linear(picture.colors.clone()), PixelValues::Linear(reference.colors.clone()))
}

/// The mean of two pictures of the same size.
pub fn mean_picture(a: &Picture, b: &Picture) -> Picture {
    let half = |(a, b): (&Rgb, &Rgb)| (*a + *b) * 0.5;
    Picture { size: a.size, colors: a.colors.iter().zip(&b.colors).map(half).collect() }
}
