//! A study of one scene: settings are chosen, measured and recorded.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime};

use strahl_core::Resolution;
use strahl_scene::description::LoadedScene;
use strahl_scene::effects;
use strahl_session::SceneStorage;
use strahl_settings::{DEFAULT_SIZE, Effect, Precision, Settings, SettingsOverrides};

use crate::cost_model::WEIGHTS;
use crate::error::StudyError;
use crate::measure::benchmark::{Benchmark, StudyProgress};
use crate::measure::measurements::Measurements;
use crate::measure::plan::StudyPlan;
use crate::measure::resolution::{self, scaled_down};
use crate::measure::{experiment, images};
use crate::record::{self, Study};

/// The time that a quick study takes.
const QUICK_TIME_LIMIT: Duration = Duration::from_secs(50);

/// A study is of at most so many pixels where nobody names a size: what a setting costs and what it
/// makes wrong is much the same for a larger picture.
const MAX_PIXELS: u32 = 1 << 16;

/// What is studied, and how thoroughly.
#[derive(Clone, Copy, Debug)]
pub struct StudySettings {
    /// Width and height; none is the scene's shape, with few pixels.
    pub size: Option<Resolution>,
    /// Whether more settings are measured, and more often.
    pub full: bool,
    /// How long it may take; none is the usual time.
    pub time_limit: Option<Duration>,
    /// Threads; none is one for each core.
    pub threads: Option<usize>,
    /// When it began: what loading takes is taken from the time, too.
    pub start: Instant,
}

/// Measures a scene, which is that of the file at `path`.
pub fn study(
    path: &Path,
    scene: &LoadedScene,
    settings: &StudySettings,
    progress: &dyn StudyProgress,
) -> Result<Study, StudyError> {
    let (load, date) = (load_average(), now());
    let facts = SceneStorage::new(scene, Precision::Single).scene_stats()?;
    let asks: Vec<Effect> = effects::plan(scene).iter().map(|it| it.effect).collect();

    let plan = if settings.full { StudyPlan::FULL } else { StudyPlan::QUICK };
    let limit = settings.time_limit.or((!settings.full).then_some(QUICK_TIME_LIMIT));
    let full =
        settings.size.unwrap_or_else(|| scaled_down(scene.settings.size.unwrap_or(DEFAULT_SIZE), MAX_PIXELS));
    let mut bench = Benchmark::new(scene, full, progress, limit);
    bench.start = settings.start;
    let own = scene_settings(scene, full, settings.threads)?;
    resolution::choose_size(&mut bench, &plan, &own, settings.size.is_none())?;
    let size = bench.size;
    let mut measured = Measurements::new(&bench, &plan);
    let reference = experiment::run(&mut measured, &own, &asks)?;
    let pictures = images::all(&measured, &reference)?;
    let seconds = bench.elapsed();
    let Measurements {
        measurements: taken,
        sweeps: knobs,
        techniques,
        threads,
        skipped: left_out,
        dominated: beaten,
        ..
    } = measured;
    let method = record::MeasurementMethod {
        program: format!("strahl {}", env!("CARGO_PKG_VERSION")),
        date,
        processor: processor(),
        system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
        cores: cores(),
        load,
        plan: plan.name.into(),
        time_limit: limit.map(|limit| limit.as_secs_f64()),
        size_with_more_time: (size != full).then(|| [full.width(), full.height()]),
        seconds,
        beaten,
        weights: WEIGHTS,
    };
    Ok(Study {
        format: record::FORMAT.into(),
        version: record::VERSION,
        scene: record::StudiedScene {
            name: stem(path),
            file: path.display().to_string(),
            width: size.width(),
            height: size.height(),
            objects: facts.objects,
            triangles: facts.triangles,
            lights: facts.lights,
            effects: asks.iter().map(|effect| effect.name().into()).collect(),
        },
        method,
        reference: reference.reference,
        runs: taken.into_iter().map(|taken| taken.run).collect(),
        knobs,
        techniques,
        threads,
        left_out,
        pictures,
    })
}

/// The scene's own settings, where it has none the defaults.
fn scene_settings(
    scene: &LoadedScene,
    size: Resolution,
    threads: Option<usize>,
) -> Result<Settings, StudyError> {
    let given = SettingsOverrides { size: Some(size), threads, ..SettingsOverrides::default() };
    Settings::resolve(&given, &scene.settings).map_err(StudyError::Settings)
}

/// The name of a scene.
pub fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or(OsStr::new("scene")).to_string_lossy().into_owned()
}

/// Now, UTC, as in RFC 3339, in whole seconds.
fn now() -> String {
    humantime::format_rfc3339_seconds(SystemTime::now()).to_string()
}

/// Threads that run at once.
fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// The processor, as it names itself where the system tells.
fn processor() -> String {
    let told = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = told.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| "not known".into(), |(_, name)| name.trim().into())
}

/// The mean number of threads that wanted to run in the last minute, where the system tells.
fn load_average() -> Option<f64> {
    let told = fs::read_to_string("/proc/loadavg").ok()?;
    told.split_whitespace().next()?.parse().ok()
}
