//! The accelerators on growing scenes: build time, memory and traversal.
//!
//! ```text
//! cargo run --release -p strahl-tests --example accelerators > tests/reports/accelerators.md
//! ```
//!
//! Procedural scenes: sphereflakes of 11 to 597,872 objects, knots of about 1,000 to 1,000,000 triangles, and a knot in a
//! stadium. Each is traced at 512 x 512 with one ray per pixel, five levels and no cutoff, on one thread, with each
//! accelerator. Times are processor time, the minimum of three repetitions; one more run counts tests. The list is left out
//! where it would take minutes.
//!
//! The exit status is 1 if two accelerators make different pictures.

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

/// Procedural scenes and their sizes.
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

/// Maximum number of objects for the list.
const MAX_LIST_OBJECTS: usize = 1_000;

/// Repetitions, of which the fastest counts: other load can only add time.
const REPETITIONS: usize = 3;

/// A row of the table.
struct AcceleratorsRow {
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
        "512 x 512, one ray per pixel, five levels, no cutoff, one thread; processor time on {}.\n",
        machine()
    );
    println!(
        "| scene | objects | accelerator | build, µs/object | bytes/object | regions | objects in each | \
         boxes/ray | shapes/ray | trace, s | Mrays/s |"
    );
    println!("|---|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|");
    let mut rows = Vec::new();
    let mut all_equal = true;
    for (what, size) in SCENES {
        let path = folder.path().join(format!("{what}-{size}.nff"));
        all_equal &= scene(what, size, &path, &mut rows)?;
        std::fs::remove_file(&path)?;
    }
    growth(&rows);
    Ok(if all_equal { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Adds the rows of one scene. Returns whether all of its pictures are equal.
fn scene(
    what: ProceduralScene,
    size: u32,
    path: &Path,
    rows: &mut Vec<AcceleratorsRow>,
) -> Result<bool, Box<dyn Error>> {
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
    for kind in
        AccelKind::ALL.into_iter().filter(|kind| *kind != AccelKind::List || objects <= MAX_LIST_OBJECTS)
    {
        let size = Resolution::new(512, 512).ok_or("no size")?;
        let settings = Settings { size, levels: 5, cutoff: 0.0, threads: 1, ..Settings::default() };
        let settings = settings.with_acceleration(AccelSettings::with_kind(kind));
        let trace = |options| strahl_session::render(&description, &settings, &options, &NoProgress);
        let (mut fastest, mut build): (Option<RenderOutput>, f64) = (None, f64::INFINITY);
        for _ in 0..REPETITIONS {
            let frame = trace(RenderOptions::default())?;
            build = build.min(frame.accelerator.build.as_secs_f64());
            if fastest.as_ref().is_none_or(|fastest| frame.trace_cpu < fastest.trace_cpu) {
                fastest = Some(frame);
            }
        }
        let frame = fastest.ok_or("no repetition")?;
        let counts = trace(RenderOptions::COUNT_TESTS)?.counters;
        let (per_object, stats) = (1.0 / objects as f64, &frame.accelerator);
        let (rays, seconds) = (counts.rays.sum() as f64, frame.trace_cpu.as_secs_f64());
        println!(
            "| {what} | {objects} | {} | {:.2} | {:.0} | {} | {:.1} | {:.1} | {:.1} | {seconds:.3} | {:.2} |",
            kind.name(),
            1e6 * build * per_object,
            stats.bytes as f64 * per_object,
            stats.regions,
            stats.items_per_region(),
            counts.box_tests.sum() as f64 / rays,
            counts.shape_tests.sum() as f64 / rays,
            1e-6 * rays / seconds,
        );
        digests.push(frame.picture.digest().to_string());
        rows.push(AcceleratorsRow { what, objects, kind, build, trace: seconds });
    }
    digests.dedup();
    if digests.len() > 1 {
        eprintln!("{what} of {objects} objects: the pictures differ");
    }
    Ok(digests.len() == 1)
}

/// Prints the growth of the times when a sphereflake has 81 times as many objects.
fn growth(rows: &[AcceleratorsRow]) {
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

/// Name of the processor.
fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or("an unknown processor".into(), |(_, name)| name.trim().to_owned())
}
