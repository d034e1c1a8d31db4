//! The lecture's evaluation, part 6: each technique compared with doing without it, as the tables of
//! `tests/reports/evaluation.md`.
//!
//! ```text
//! cargo run --release -p strahl-tests --example evaluation -- FOLDER_WITH_THE_NFF_FILES > tables.md
//! ```
//!
//! The text between the tables is written by hand. Times are processor seconds, the median of three; tests
//! are counts and reproducible. A cell without a number took longer than half a minute.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use strahl_core::Resolution;
use strahl_engine::NoProgress;
use strahl_scene::load;
use strahl_session::SceneStorage;
use strahl_settings::{Precision, Settings};
use strahl_study::measure::benchmark::Benchmark;
use strahl_study::measure::experiment;
use strahl_study::measure::measurements::Measurements;
use strahl_study::measure::plan::StudyPlan;
use strahl_study::page::numbers;
use strahl_study::record::{StudyRun, Technique};

/// Names of the procedural databases.
const DATABASES: [&str; 7] = ["balls", "gears", "mount", "rings", "teapot", "tetra", "tree"];
/// Scenes of this project.
const OWN: [&str; 8] = [
    "classic.toml",
    "glass.toml",
    "shapes.toml",
    "sphereflake.toml",
    "knot.toml",
    "pyramid.toml",
    "rotunda.nff",
    "penumbra.toml",
];
/// Pixels along one side.
const SIDE: u32 = 96;
/// Time limit per scene, in seconds; a technique may take a twentieth of it.
const SECONDS: u64 = 600;

/// Results of the techniques for one scene.
struct SceneEvaluation {
    name: String,
    objects: usize,
    techniques: Vec<Technique>,
    runs: Vec<StudyRun>,
}

fn evaluate(path: &Path) -> Result<SceneEvaluation, Box<dyn Error>> {
    let scene = load(path)?;
    let size = Resolution::new(SIDE, SIDE).ok_or("no size")?;
    let plan = StudyPlan { repeats: 3, ..StudyPlan::QUICK };
    let limit = Some(Duration::from_secs(SECONDS));
    let bench = Benchmark::new(&scene, size, &NoProgress, limit);
    let default = Settings::default();
    let levels = scene.settings.levels.unwrap_or(default.levels);
    let settings = Settings { size, levels, threads: 1, ..default };
    let mut measured = Measurements::new(&bench, &plan);
    experiment::evaluate(&mut measured, &settings)?;
    let Measurements { measurements: taken, techniques, .. } = measured;
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let runs = taken.into_iter().map(|taken| taken.run).collect();
    let objects = SceneStorage::new(&scene, Precision::Single).scene_stats()?.objects;
    Ok(SceneEvaluation { name, objects, techniques, runs })
}

/// Number of box and shape tests.
fn tests(run: &StudyRun) -> f64 {
    (run.counts.boxes.iter().sum::<u64>() + run.counts.shapes.iter().sum::<u64>()) as f64
}

fn saved(without: f64, with: f64) -> String {
    let percent = 100.0 * (1.0 - with / without.max(1e-12));
    let text = if percent > 99.0 { format!("{percent:.1}") } else { format!("{percent:.0}") };
    if text == "-0" { "0".into() } else { text.replace('-', "−") }
}

impl SceneEvaluation {
    fn run(&self, index: Option<usize>) -> Option<&StudyRun> {
        self.runs.get(index?)
    }

    /// Tests per ray and time, with or without a technique.
    fn cost(&self, name: &str, side: fn(&Technique) -> Option<usize>) -> String {
        let it = self.techniques.iter().find(|it| it.name == name);
        let Some(run) = it.and_then(|it| self.run(side(it))) else { return "–".into() };
        let rays: u64 = run.counts.rays.iter().sum();
        format!("{:.1} / {}", tests(run) / (rays as f64).max(1.0), numbers::seconds(run.median_cpu_seconds()))
    }

    /// Savings of a technique, in percent of the tests and of the time.
    fn savings(&self, name: &str) -> Option<[String; 2]> {
        let it = self.techniques.iter().find(|it| it.name == name)?;
        let (without, with) = (self.run(it.without)?, self.run(it.with)?);
        Some([
            saved(tests(without), tests(with)),
            saved(without.median_cpu_seconds(), with.median_cpu_seconds()),
        ])
    }

    fn error(&self, name: &str) -> Option<f64> {
        Some(self.techniques.iter().find(|it| it.name == name)?.error?.rmse)
    }
}

/// Prints a table with a row for each scene.
fn table(head: &[&str], scenes: &[SceneEvaluation], row: impl Fn(&SceneEvaluation) -> Vec<String>) {
    println!("| scene | {} |", head.join(" | "));
    println!("|---|{}", "--:|".repeat(head.len()));
    for scene in scenes {
        println!("| {} | {} |", scene.name, row(scene).join(" | "));
    }
    println!();
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("usage: evaluation FOLDER")?);
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let databases = DATABASES.iter().map(|name| folder.join(name).with_extension("nff"));
    let paths: Vec<PathBuf> = databases.chain(OWN.iter().map(|name| own.join(name))).collect();
    let mut scenes = Vec::new();
    for path in &paths {
        eprintln!("{}", path.display());
        scenes.push(evaluate(path)?);
    }

    println!("## Acceleration structures\n");
    let columns = [
        "objects",
        "every item",
        "spheres (5.1)",
        "boxes (5.1)",
        "grid (5.2)",
        "octree (5.3)",
        "BVH, heap (5.4)",
        "BVH, stack",
    ];
    table(&columns, &scenes, |it| {
        vec![
            it.objects.to_string(),
            it.cost("bounding volumes", |it| it.without),
            it.cost("bounding spheres", |it| it.with),
            it.cost("bounding volumes", |it| it.with),
            it.cost("regular grid", |it| it.with),
            it.cost("octree", |it| it.with),
            it.cost("BVH", |it| it.with),
            it.cost("BVH with a stack", |it| it.with),
        ]
    });

    println!("## Caches\n");
    let caches = ["mailbox of the grid", "mailbox of the octree", "shadow cache", "heap capacity"];
    table(
        &caches.map(|name| match name {
            "mailbox of the grid" => "mailbox, grid (5.5)",
            "mailbox of the octree" => "mailbox, octree (5.5)",
            "shadow cache" => "shadow cache (5.6)",
            _ => "heap of 64, not 0 (5.4)",
        }),
        &scenes,
        |it| {
            let cell =
                |name| it.savings(name).map_or("–".into(), |[tests, time]| format!("{tests} / {time}"));
            caches.map(cell).to_vec()
        },
    );

    println!("## Approximations\n");
    let approximations =
        ["adaptive depth", "pixel selection", "adaptive supersampling", "adaptive sample count"];
    table(
        &[
            "adaptive depth (5.7)",
            "pixel selection (5.8)",
            "adaptive supersampling (4.2)",
            "stopping rule (4.3)",
        ],
        &scenes,
        |it| {
            let cell = |name| match (it.savings(name), it.error(name)) {
                (Some([_, time]), Some(error)) => format!("{time} / {}", numbers::error(error)),
                _ => "–".into(),
            };
            approximations.map(cell).to_vec()
        },
    );

    // A technique that must not change the picture, and does, is an error.
    let mut all_equal = true;
    for scene in &scenes {
        for it in scene.techniques.iter().filter(|it| it.exact) {
            if let (Some(without), Some(with)) = (scene.run(it.without), scene.run(it.with))
                && without.digest != with.digest
            {
                eprintln!("{}: {} changes the picture", scene.name, it.name);
                all_equal = false;
            }
        }
    }
    Ok(if all_equal { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
