//! A study of one scene: settings are planned, measured and recorded.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime};

use strahl_core::Resolution;
use strahl_scene::description::LoadedScene;
use strahl_scene::effects;
use strahl_session::SceneStorage;
use strahl_settings::{DEFAULT_SIZE, OptionalEffect, Precision, Settings, SettingsOverrides};

use crate::cost_model::WEIGHTS;
use crate::error::StudyError;
use crate::measure::benchmark::{Benchmark, StudyProgress};
use crate::measure::measurements::Measurements;
use crate::measure::plan::StudyPlan;
use crate::measure::resolution::{self, scaled_down};
use crate::measure::{experiment, images};
use crate::record::{self, Study};

/// Time limit of a quick study.
const QUICK_TIME_LIMIT: Duration = Duration::from_secs(50);

/// Maximum number of pixels if no size is given: relative costs and errors are similar for larger pictures.
const MAX_PIXELS: u32 = 1 << 16;

/// Size, thoroughness and time limit of a study.
#[derive(Clone, Copy, Debug)]
pub struct StudySettings {
    /// Size of the pictures; `None`: the aspect ratio of the scene with at most 65536 pixels.
    pub size: Option<Resolution>,
    /// Whether to use the full plan.
    pub full: bool,
    /// Time limit; `None`: 50 s, or no limit with the full plan.
    pub time_limit: Option<Duration>,
    /// Number of threads; `None`: one per core.
    pub threads: Option<usize>,
    /// Start of the program: loading counts against the time limit.
    pub start: Instant,
}

/// Measures the scene that was loaded from `path`.
pub fn study(
    path: &Path,
    scene: &LoadedScene,
    settings: &StudySettings,
    progress: &dyn StudyProgress,
) -> Result<Study, StudyError> {
    let (load, date) = (load_average(), now());
    let stats = SceneStorage::new(scene, Precision::Single).scene_stats()?;
    let required: Vec<OptionalEffect> = effects::plan(scene).iter().map(|it| it.effect).collect();

    let plan = if settings.full { StudyPlan::FULL } else { StudyPlan::QUICK };
    let limit = settings.time_limit.or((!settings.full).then_some(QUICK_TIME_LIMIT));
    let full =
        settings.size.unwrap_or_else(|| scaled_down(scene.settings.size.unwrap_or(DEFAULT_SIZE), MAX_PIXELS));
    let mut benchmark = Benchmark::new(scene, full, progress, limit);
    benchmark.start = settings.start;
    let own = scene_settings(scene, full, settings.threads)?;
    resolution::choose_size(&mut benchmark, &plan, &own, settings.size.is_none())?;
    let size = benchmark.size;
    let mut measured = Measurements::new(&benchmark, &plan);
    let reference = experiment::run(&mut measured, &own, &required)?;
    let pictures = images::all(&measured, &reference)?;
    let seconds = benchmark.elapsed();
    let Measurements {
        measurements: taken,
        sweeps: knobs,
        techniques,
        threads,
        skipped: left_out,
        dominated,
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
        beaten: dominated,
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
            objects: stats.objects,
            triangles: stats.triangles,
            lights: stats.lights,
            effects: required.iter().map(|effect| effect.name().into()).collect(),
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

/// The settings of the scene, completed by defaults.
fn scene_settings(
    scene: &LoadedScene,
    size: Resolution,
    threads: Option<usize>,
) -> Result<Settings, StudyError> {
    let given = SettingsOverrides { size: Some(size), threads, ..SettingsOverrides::default() };
    Settings::resolve(&given, &scene.settings).map_err(StudyError::Settings)
}

/// The name of a scene: its file name without extension.
pub fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or(OsStr::new("scene")).to_string_lossy().into_owned()
}

/// The current UTC time in RFC 3339 format, in whole seconds.
fn now() -> String {
    humantime::format_rfc3339_seconds(SystemTime::now()).to_string()
}

/// Number of hardware threads.
fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// The name of the processor, if known.
fn processor() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| "not known".into(), |(_, name)| name.trim().into())
}

/// The load average of the last minute, if known.
fn load_average() -> Option<f64> {
    let text = fs::read_to_string("/proc/loadavg").ok()?;
    text.split_whitespace().next()?.parse().ok()
}
