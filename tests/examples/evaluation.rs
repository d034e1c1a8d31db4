//! The lecture's evaluation, part 6: every technique measured against doing without it, as the
//! tables of `tests/reports/evaluation.md`.
//!
//! ```text
//! cargo run --release -p strahl-tests --example evaluation -- FOLDER_WITH_THE_NFF_FILES > tables.md
//! ```
//!
//! What is between the tables and around them in that file is written by hand. Times are processor
//! seconds, the median of three; tests are counts, the same every time. A cell without a number
//! took longer than half a minute.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use strahl_core::Resolution;
use strahl_engine::NoProgress;
use strahl_scene::load;
use strahl_session::SceneStorage;
use strahl_settings::{Precision, Settings};
use strahl_study::measure::benchmark::Bench;
use strahl_study::measure::experiment;
use strahl_study::measure::measurements::Measurements;
use strahl_study::measure::plan::Plan;
use strahl_study::page::numbers;
use strahl_study::record::{Run, Technique};

/// The procedural databases, and what they are.
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
/// Seconds for all of a scene, of which a technique may take a twentieth.
const SECONDS: u64 = 600;

/// What the techniques do for one scene.
struct Evaluated {
    name: String,
    objects: usize,
    techniques: Vec<Technique>,
    runs: Vec<Run>,
}

fn evaluate(path: &Path) -> Result<Evaluated, Box<dyn Error>> {
    let scene = load(path)?;
    let size = Resolution::new(SIDE, SIDE).ok_or("no size")?;
    let plan = Plan { repeats: 3, ..Plan::QUICK };
    let limit = Some(Duration::from_secs(SECONDS));
    let bench = Bench::new(&scene, size, &NoProgress, limit);
    let default = Settings::default();
    let levels = scene.settings.levels.unwrap_or(default.levels);
    let settings = Settings { size, levels, threads: 1, ..default };
    let mut measured = Measurements::new(&bench, &plan);
    experiment::evaluate(&mut measured, &settings)?;
    let Measurements { taken, techniques, .. } = measured;
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let runs = taken.into_iter().map(|taken| taken.run).collect();
    let objects = SceneStorage::new(&scene, Precision::Single).scene_stats()?.objects;
    Ok(Evaluated { name, objects, techniques, runs })
}

/// Tests of boxes and shapes.
fn tests(run: &Run) -> f64 {
    (run.counts.boxes.iter().sum::<u64>() + run.counts.shapes.iter().sum::<u64>()) as f64
}

fn saved(without: f64, with: f64) -> String {
    let percent = 100.0 * (1.0 - with / without.max(1e-12));
    let text = if percent > 99.0 { format!("{percent:.1}") } else { format!("{percent:.0}") };
    if text == "-0" { "0".into() } else { text.replace('-', "−") }
}

impl Evaluated {
    fn run(&self, place: Option<usize>) -> Option<&Run> {
        self.runs.get(place?)
    }

    /// The tests in a ray, and the time, of one side of a technique.
    fn cost(&self, name: &str, side: fn(&Technique) -> Option<usize>) -> String {
        let it = self.techniques.iter().find(|it| it.name == name);
        let Some(run) = it.and_then(|it| self.run(side(it))) else { return "–".into() };
        let rays: u64 = run.counts.rays.iter().sum();
        format!("{:.1} / {}", tests(run) / (rays as f64).max(1.0), numbers::seconds(run.seconds()))
    }

    /// What a technique saves, in percent of the tests and of the time.
    fn savings(&self, name: &str) -> Option<[String; 2]> {
        let it = self.techniques.iter().find(|it| it.name == name)?;
        let (without, with) = (self.run(it.without)?, self.run(it.with)?);
        Some([saved(tests(without), tests(with)), saved(without.seconds(), with.seconds())])
    }

    fn error(&self, name: &str) -> Option<f64> {
        Some(self.techniques.iter().find(|it| it.name == name)?.error?.rmse)
    }
}

/// A table: a head, and a row for each scene.
fn table(head: &[&str], scenes: &[Evaluated], row: impl Fn(&Evaluated) -> Vec<String>) {
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

    println!("## Finding\n");
    let found = [
        "objects",
        "every item",
        "spheres (5.1)",
        "boxes (5.1)",
        "grid (5.2)",
        "octree (5.3)",
        "hierarchy, heap (5.4)",
        "hierarchy, stack",
    ];
    table(&found, &scenes, |it| {
        vec![
            it.objects.to_string(),
            it.cost("bounding volumes", |it| it.without),
            it.cost("bounding spheres", |it| it.with),
            it.cost("bounding volumes", |it| it.with),
            it.cost("regular grid", |it| it.with),
            it.cost("octree", |it| it.with),
            it.cost("hierarchy", |it| it.with),
            it.cost("hierarchy, by a stack", |it| it.with),
        ]
    });

    println!("## Remembering\n");
    let remembering = ["mailbox of the grid", "mailbox of the octree", "shadow cache", "room in the heap"];
    table(
        &remembering.map(|name| match name {
            "mailbox of the grid" => "mailbox, grid (5.5)",
            "mailbox of the octree" => "mailbox, octree (5.5)",
            "shadow cache" => "shadow cache (5.6)",
            _ => "heap of 64, not 0 (5.4)",
        }),
        &scenes,
        |it| {
            let cell =
                |name| it.savings(name).map_or("–".into(), |[tests, time]| format!("{tests} / {time}"));
            remembering.map(cell).to_vec()
        },
    );

    println!("## Guessing\n");
    let guessing =
        ["adaptive depth", "pixel selection", "adaptive supersampling", "samples until it is known"];
    table(
        &[
            "adaptive depth (5.7)",
            "pixel selection (5.8)",
            "adaptive supersampling (4.2)",
            "samples until it is known (4.3)",
        ],
        &scenes,
        |it| {
            let cell = |name| match (it.savings(name), it.error(name)) {
                (Some([_, time]), Some(error)) => format!("{time} / {}", numbers::error(error)),
                _ => "–".into(),
            };
            guessing.map(cell).to_vec()
        },
    );

    // What changes one bit of a picture where it must not is a fault.
    let mut holds = true;
    for scene in &scenes {
        for it in scene.techniques.iter().filter(|it| it.exact) {
            if let (Some(without), Some(with)) = (scene.run(it.without), scene.run(it.with))
                && without.digest != with.digest
            {
                eprintln!("{}: {} changes the picture", scene.name, it.name);
                holds = false;
            }
        }
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
