//! The accelerators on growing scenes: what they take to build, to hold and to walk.
//!
//! ```text
//! cargo run --release -p strahl-tests --example accelerators > tests/reports/accelerators.md
//! ```
//!
//! Scenes of the generator: sphereflakes of 11 to 597,872 objects, knots of about 1,000 to
//! 1,000,000 triangles, and a knot in a stadium. Each is traced at 512 x 512 with one ray for each
//! pixel, five levels, no cutoff, on one thread and uncounted, once by each accelerator; processor
//! time, of three turns the least. Then once more to count. The list is left out where it would
//! take minutes.
//!
//! The exit status is 1 when two accelerators make different pictures.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use strahl::args::GenerateArgs;
use strahl::generate;
use strahl_core::Resolution;
use strahl_engine::{NoProgress, RenderOptions};
use strahl_scene::procedural::ProceduralScene;
use strahl_session::RenderOutput;
use strahl_settings::{AccelKind, AccelSettings, Settings};

/// ProceduralScene is made, and how large.
const SCENES: [(ProceduralScene, u32); 10] = [
    (ProceduralScene::Sphereflake, 1),
    (ProceduralScene::Sphereflake, 2),
    (ProceduralScene::Sphereflake, 3),
    (ProceduralScene::Sphereflake, 4),
    (ProceduralScene::Sphereflake, 5),
    (ProceduralScene::Sphereflake, 6),
    (ProceduralScene::Knot, 1_000),
    (ProceduralScene::Knot, 100_000),
    (ProceduralScene::Knot, 1_000_000),
    (ProceduralScene::Stadium, 10_000),
];

/// The most objects that are held against every ray.
const LISTED: usize = 1_000;

/// Turns, of which the quickest counts: whatever else a machine does can only add to it.
const TURNS: usize = 3;

/// One row of the table.
struct Row {
    what: ProceduralScene,
    objects: usize,
    kind: AccelKind,
    build: f64,
    trace: f64,
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    println!("# Accelerators on growing scenes\n");
    println!("Made by\n");
    println!(
        "    cargo run --release -p strahl-tests --example accelerators > tests/reports/accelerators.md\n"
    );
    println!(
        "512 x 512, one ray for each pixel, five levels, no cutoff, one thread; processor time on {}.\n",
        machine()
    );
    println!(
        "| scene | objects | accelerator | build, µs/object | bytes/object | regions | objects in each | \
         boxes/ray | shapes/ray | trace, s | Mrays/s |"
    );
    println!("|---|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|");
    let mut rows = Vec::new();
    let mut all_same = true;
    for (what, size) in SCENES {
        let path = folder.path().join(format!("{what}-{size}.nff"));
        all_same &= scene(what, size, &path, &mut rows)?;
        std::fs::remove_file(&path)?;
    }
    growth(&rows);
    Ok(if all_same { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Adds the rows of one scene; whether all of its pictures are the same.
fn scene(what: ProceduralScene, size: u32, path: &Path, rows: &mut Vec<Row>) -> Result<bool, Box<dyn Error>> {
    generate::run(&GenerateArgs {
        what,
        size: Some(size),
        output: Some(path.to_owned()),
        format: None,
        bare: false,
        quiet: true,
    })?;
    let description = strahl_scene::load(path)?;
    let objects = description.objects.len();
    let mut digests = Vec::new();
    for kind in AccelKind::ALL.into_iter().filter(|kind| *kind != AccelKind::List || objects <= LISTED) {
        let size = Resolution::new(512, 512).ok_or("no size")?;
        let settings = Settings { size, levels: 5, cutoff: 0.0, threads: 1, ..Settings::default() };
        let settings = settings.with_acceleration(AccelSettings::with_kind(kind));
        let trace = |options| strahl_session::render(&description, &settings, &options, &NoProgress);
        let (mut quickest, mut build): (Option<RenderOutput>, f64) = (None, f64::INFINITY);
        for _ in 0..TURNS {
            let frame = trace(RenderOptions::default())?;
            build = build.min(frame.accelerator.build.as_secs_f64());
            if quickest.as_ref().is_none_or(|quickest| frame.trace_cpu < quickest.trace_cpu) {
                quickest = Some(frame);
            }
        }
        let frame = quickest.ok_or("no turn")?;
        let counts = trace(RenderOptions::COUNT_TESTS)?.counters;
        let (each, facts) = (1.0 / objects as f64, &frame.accelerator);
        let (rays, seconds) = (counts.rays.sum() as f64, frame.trace_cpu.as_secs_f64());
        println!(
            "| {what} | {objects} | {} | {:.2} | {:.0} | {} | {:.1} | {:.1} | {:.1} | {seconds:.3} | {:.2} |",
            kind.name(),
            1e6 * build * each,
            facts.bytes as f64 * each,
            facts.regions,
            facts.items_per_region(),
            counts.box_tests.sum() as f64 / rays,
            counts.shape_tests.sum() as f64 / rays,
            1e-6 * rays / seconds,
        );
        digests.push(frame.picture.digest().to_string());
        rows.push(Row { what, objects, kind, build, trace: seconds });
    }
    digests.dedup();
    if digests.len() > 1 {
        eprintln!("{what} of {objects} objects: not all pictures are the same");
    }
    Ok(digests.len() == 1)
}

/// ProceduralScene becomes of the times when a sphereflake has 81 times the objects.
fn growth(rows: &[Row]) {
    println!("\nFrom the sphereflake of 7,382 objects to that of 597,872, 81 times as many:\n");
    println!("| accelerator | trace | build |\n|---|---:|---:|");
    let of = |kind, objects| {
        rows.iter().find(|row| {
            row.what == ProceduralScene::Sphereflake && row.kind == kind && row.objects == objects
        })
    };
    for kind in AccelKind::ALL {
        if let (Some(few), Some(many)) = (of(kind, 7_382), of(kind, 597_872)) {
            let [trace, build] = [many.trace / few.trace, many.build / few.build];
            println!("| {} | {trace:.2} times | {build:.0} times |", kind.name());
        }
    }
}

/// ProceduralScene the system says of its processor.
fn machine() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = told.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or("an unnamed machine".into(), |(_, name)| name.trim().to_owned())
}
