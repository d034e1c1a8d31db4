//! What accuracy costs in time.
//!
//! A scene is rendered over a plan of settings, each held against a reference of high quality.
//! What comes of it is a page to look at (`report.html`), the runs as a table (`study.csv`) and everything as it was
//! measured (`study.json`), of which the page can be made again.
//!
//! | module | what it does |
//! |---|---|
//! | [`record`] | what was found, as `study.json` holds it |
//! | [`mod@file`] | `study.json`, written and read |
//! | [`plan`] | what is measured, and how much time each part may take |
//! | [`options`] | what is turned |
//! | `afford` | how large a picture there is time for |
//! | [`bench`](mod@bench) | one setting is measured |
//! | [`conduct`] | a study from its beginning to its end |
//! | [`measurements`] | what was measured so far |
//! | `knobs` | knobs turned one by one |
//! | [`mix`] | which mixtures are worth a measurement |
//! | `mixtures` | they are measured |
//! | `techniques` | techniques on and off |
//! | [`statistics`] | medians and spreads |
//! | [`front`](mod@front) | the Pareto front, and what it recommends |
//! | [`progress`] | how far it is |
//! | [`error`] | why there is no study |
//! | [`machine`] | where it was measured |
//! | [`images`] | pictures of it |
//! | [`table`] | `study.csv` |
//! | [`device`] | what firmware has measured |
//! | [`page`] | `report.html` |

use std::ffi::OsStr;
use std::path::Path;
use std::time::{Duration, Instant};

use strahl_core::Resolution;
use strahl_scene::description::LoadedScene;
use strahl_scene::effects;
use strahl_settings::{DEFAULT_SIZE, Effect, Precision, Settings, SettingsOverrides};

use crate::cost::WEIGHTS;
use crate::session::SceneStorage;
use afford::smaller;
use bench::Bench;
use error::StudyError;
use measurements::Measurements;
use plan::Plan;
use progress::StudyProgress;
use record::Study;

mod afford;
pub mod bench;
pub mod conduct;
pub mod device;
pub mod error;
pub mod file;
pub mod front;
pub mod images;
mod knobs;
pub mod machine;
pub mod measurements;
pub mod mix;
mod mixtures;
pub mod options;
pub mod page;
pub mod plan;
pub mod progress;
pub mod record;
pub mod statistics;
pub mod table;
mod techniques;

/// The time that a quick study takes.
const QUICK: Duration = Duration::from_secs(50);

/// A study is of at most so many pixels where nobody names a size: what a setting costs and what it
/// makes wrong is much the same for a larger picture.
const PIXELS: u32 = 1 << 16;

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
    pub begun: Instant,
}

/// Measures a scene, which is that of the file at `path`.
pub fn study(
    path: &Path,
    scene: &LoadedScene,
    settings: &StudySettings,
    progress: &dyn StudyProgress,
) -> Result<Study, StudyError> {
    let (load, date) = (machine::load(), machine::now());
    let facts = SceneStorage::new(scene, Precision::Single).scene_stats()?;
    let asks: Vec<Effect> = effects::plan(scene).iter().map(|it| it.effect).collect();

    let plan = if settings.full { Plan::FULL } else { Plan::QUICK };
    let limit = settings.time_limit.or((!settings.full).then_some(QUICK));
    let full = settings.size.unwrap_or_else(|| smaller(scene.settings.size.unwrap_or(DEFAULT_SIZE), PIXELS));
    let mut bench = Bench::new(scene, full, progress, limit);
    bench.begun = settings.begun;
    let own = own(scene, full, settings.threads)?;
    afford::choose(&mut bench, &plan, &own, settings.size.is_none())?;
    let size = bench.size;
    let mut measured = Measurements::new(&bench, &plan);
    let reference = conduct::run(&mut measured, &own, &asks)?;
    let pictures = images::all(&measured, &reference)?;
    let seconds = bench.elapsed();
    let Measurements { taken, knobs, techniques, threads, left_out, beaten, .. } = measured;
    let method = record::Method {
        program: format!("strahl {}", env!("CARGO_PKG_VERSION")),
        date,
        processor: machine::processor(),
        system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
        cores: machine::cores(),
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
        scene: record::Scene {
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
fn own(scene: &LoadedScene, size: Resolution, threads: Option<usize>) -> Result<Settings, StudyError> {
    let given = SettingsOverrides { size: Some(size), threads, ..SettingsOverrides::default() };
    Settings::resolve(&given, &scene.settings).map_err(StudyError::Settings)
}

/// The name of a scene.
pub fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or(OsStr::new("scene")).to_string_lossy().into_owned()
}
