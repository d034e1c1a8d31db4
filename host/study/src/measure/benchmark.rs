//! Where settings are measured: one scene at one size, against a clock.

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

/// Told what a study measures and how much time is left; it may stop the study.
pub trait StudyProgress: Progress {
    /// This setting is measured now, in the words of the command line.
    fn measuring(&self, _setting: &str) {}

    /// So many seconds are over, and about so many are left.
    fn time(&self, _elapsed: f64, _left: f64) {}
}

impl StudyProgress for NoProgress {}

/// One scene at one size, and a clock.
pub struct Benchmark<'b> {
    /// The scene.
    pub scene: &'b LoadedScene,
    /// The size of all pictures.
    pub size: Resolution,
    /// Told how far it is.
    pub progress: &'b dyn StudyProgress,
    /// When it began.
    pub start: Instant,
    /// How long all of it may take.
    pub limit: Option<Duration>,
    /// Seconds that tables and accelerator take before anything is traced.
    build: Cell<f64>,
}

/// A setting that was traced.
pub struct Measurement {
    /// Which.
    pub settings: Settings,
    /// What it took; its errors are still to be measured.
    pub run: StudyRun,
    /// What came of it, until nobody needs it any more.
    pub picture: Option<Picture>,
}

impl<'b> Benchmark<'b> {
    /// Pictures of `size`, from now on and until `limit` is over.
    pub fn new(
        scene: &'b LoadedScene,
        size: Resolution,
        progress: &'b dyn StudyProgress,
        limit: Option<Duration>,
    ) -> Self {
        Benchmark { scene, size, progress, start: Instant::now(), limit, build: Cell::new(0.0) }
    }

    /// To make tables and accelerator takes so many seconds: no setting is charged for it.
    pub(super) fn set_build_time(&self, seconds: f64) {
        self.build.set(seconds);
    }

    /// Seconds since the study began.
    pub fn elapsed(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// About so many seconds are left.
    pub(super) fn report_seconds_left(&self, seconds: f64) {
        self.progress.time(self.elapsed(), seconds);
    }

    /// This share of the time that is given, in seconds.
    pub fn time_share(&self, share: f64) -> f64 {
        self.limit.map_or(f64::INFINITY, |limit| share * limit.as_secs_f64())
    }

    /// Traces it once; none where that takes more seconds than `most`, or than are left of all.
    pub fn trace(&self, options: &Settings, most: f64) -> Result<Option<RenderOutput>, RenderError> {
        self.trace_with_options(options, &RenderOptions::COUNT_TESTS, most)
    }

    /// What each pixel costs, row by row; none where no time is left for it.
    pub fn costs(&self, options: &Settings) -> Result<Option<Vec<PixelCost>>, RenderError> {
        let cost_map = CostMap::new(self.size);
        let counting = RenderOptions { cost_map: Some(&cost_map), ..RenderOptions::default() };
        Ok(self.trace_with_options(options, &counting, f64::INFINITY)?.map(|_| cost_map.costs()))
    }

    fn trace_with_options(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        most: f64,
    ) -> Result<Option<RenderOutput>, RenderError> {
        self.progress.measuring(&command_line(settings));
        // Nothing lasts longer than the study may, whatever it is allowed to.
        let (most, left) = (most + self.build.get(), self.time_share(time::TRACING_END) - self.elapsed());
        let most = if most < left { most } else { left };
        if most <= 0.0 {
            return Ok(None);
        }
        // What is longer than a clock can say has no end.
        let end = Duration::try_from_secs_f64(most).ok().and_then(|most| Instant::now().checked_add(most));
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

    /// Traces it for the first time.
    pub fn measure(
        &self,
        role: RunRole,
        options: &Settings,
        most: f64,
    ) -> Result<Option<Measurement>, RenderError> {
        let Some(frame) = self.trace(options, most)? else { return Ok(None) };
        let counts = event_counts(&frame.counters);
        let choice = &frame.accelerator.choice;
        let run = StudyRun {
            role,
            setting: RunSettings::new(options, choice),
            cpu: vec![frame.trace_cpu.as_secs_f64()],
            wall: vec![frame.trace.as_secs_f64()],
            build: frame.build.as_secs_f64(),
            work: WEIGHTS.instructions(&counts, choice.kind.name()),
            counts,
            error: ErrorMetrics::default(),
            cut: frame.counters.cut_fractions(),
            digest: frame.picture.digest().to_hex().to_string(),
        };
        Ok(Some(Measurement { settings: options.clone(), run, picture: Some(frame.picture) }))
    }

    /// Traces it once more.
    pub fn repeat(&self, taken: &mut Measurement) -> Result<(), RenderError> {
        if let Some(frame) = self.trace(&taken.settings, f64::INFINITY)? {
            taken.run.cpu.push(frame.trace_cpu.as_secs_f64());
            taken.run.wall.push(frame.trace.as_secs_f64());
        }
        Ok(())
    }
}

/// How far a picture is from another of the same size.
pub fn error_metrics(picture: &Picture, truth: &Picture) -> ErrorMetrics {
    let size = picture.size;
    let pair = picture_pair(picture, truth);
    let measures = pair.measure(size.width() as usize, Limit::Identical);
    let pixels = picture.colors.len().max(1) as f64;
    ErrorMetrics {
        rmse: (measures.squares / (3.0 * pixels)).sqrt(),
        largest: measures.peak.difference,
        beyond: measures.beyond as f64 / pixels,
        ssim: pair.ssim(size),
    }
}

/// Two pictures, to be held against each other.
pub fn picture_pair(picture: &Picture, truth: &Picture) -> Pair {
    Pair::of(PixelValues::Linear(picture.colors.clone()), PixelValues::Linear(truth.colors.clone()))
}

/// The mean of two pictures of the same size.
pub fn mean_picture(a: &Picture, b: &Picture) -> Picture {
    let half = |(a, b): (&Rgb, &Rgb)| (*a + *b) * 0.5;
    Picture { size: a.size, colors: a.colors.iter().zip(&b.colors).map(half).collect() }
}
