//! Instructions per counted event of tracing: the weights of `host/src/cost.rs`.
//!
//! ```text
//! cargo run --release -p strahl-tests --example weights [-- FOLDER_WITH_THE_NFF_FILES]
//! ```
//!
//! Every scene of `scenes/` (and of the folder) is traced with every accelerator under callgrind, as a small
//! and as a tiny picture. The difference excludes loading and building. Non-negative weights of the counts
//! are fitted to it by least squares of the relative errors. Needs valgrind. Prints the weights and the
//! errors of the fit.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use strahl_core::Resolution;
use strahl_engine::{NoProgress, RenderOptions};
use strahl_settings::{AccelKind, AccelSettings, Settings};
use strahl_study::cost_model::{EventCounts, event_counts};

/// Sizes of the small and of the tiny picture.
const SIZES: [&str; 2] = ["48x36", "2x2"];

/// Number of kinds of events: three kinds of rays, shape tests, mailbox hits, and for each accelerator box
/// tests and leaf viserrors.
const EVENTS: usize = 5 + 2 * AccelKind::ALL.len();

/// Counts in the order of [`EVENTS`].
fn events(counts: &EventCounts, kind: AccelKind) -> [f64; EVENTS] {
    let sum = |of: [u64; 4]| of.iter().sum::<u64>() as f64;
    let [camera, reflected, transmitted, shadow] = counts.rays.map(|count| count as f64);
    let mut events = [0.0; EVENTS];
    events[..5].copy_from_slice(&[
        camera,
        reflected + transmitted,
        shadow,
        sum(counts.shapes),
        sum(counts.skipped),
    ]);
    events[5 + 2 * kind as usize] = sum(counts.boxes);
    events[6 + 2 * kind as usize] = sum(counts.regions);
    events
}

/// Traces one picture and prints its counts; runs under callgrind.
fn trace(scene: &str, kind: &str, sampler: &str, size: &str) -> Result<(), Box<dyn Error>> {
    let kind = AccelKind::ALL.into_iter().find(|it| it.name() == kind).ok_or("no such accelerator")?;
    let (width, height) = size.split_once('x').ok_or("no size")?;
    let size = Resolution::new(width.parse()?, height.parse()?).ok_or("no size")?;
    let scene = strahl_scene::load(Path::new(scene))?;
    let default = Settings::default();
    let levels = scene.settings.levels.unwrap_or(default.levels);
    let settings = Settings { size, sampler: sampler.parse()?, levels, threads: 1, ..default };
    let settings = settings.with_acceleration(AccelSettings::with_kind(kind));
    let frame = strahl_session::render(&scene, &settings, &RenderOptions::COUNT_TESTS, &NoProgress)?;
    let counts = event_counts(&frame.counters);
    println!("{}", serde_json::to_string(&counts)?);
    Ok(())
}

/// Instructions and counts of tracing a picture.
fn measured(
    scene: &Path,
    kind: AccelKind,
    sampler: &str,
    size: &str,
) -> Result<(f64, EventCounts), Box<dyn Error>> {
    let done = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe()?)
        .arg("--trace")
        .arg(scene)
        .args([kind.name(), sampler, size])
        .output()?;
    let log = String::from_utf8(done.stderr)?;
    let collected = log.lines().find_map(|line| line.rsplit_once("Collected :")?.1.trim().parse().ok());
    Ok((collected.ok_or(log)?, serde_json::from_slice(&done.stdout)?))
}

/// Fits non-negative weights to the instructions by coordinate descent.
fn fit(rows: &[([f64; EVENTS], f64)]) -> [f64; EVENTS] {
    let mut weights = [0.0; EVENTS];
    for _ in 0..20_000 {
        for event in 0..EVENTS {
            let (mut up, mut across) = (0.0, 0.0);
            for (events, instructions) in rows {
                let predicted: f64 = events.iter().zip(&weights).map(|(count, weight)| count * weight).sum();
                let others = (predicted - events[event] * weights[event]) / instructions;
                let own = events[event] / instructions;
                up += own * (1.0 - others);
                across += own * own;
            }
            weights[event] = if across > 0.0 && up > 0.0 { up / across } else { 0.0 };
        }
    }
    weights
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let [flag, scene, kind, sampler, size] = &words[..]
        && flag == "--trace"
    {
        trace(scene, kind, sampler, size)?;
        return Ok(ExitCode::SUCCESS);
    }
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let folders = std::iter::once(own).chain(words.iter().map(PathBuf::from));
    let mut scenes = Vec::new();
    for folder in folders {
        let entries = std::fs::read_dir(folder)?.collect::<Result<Vec<_>, _>>()?;
        let is_scene = |path: &PathBuf| path.extension().is_some_and(|it| it == "toml" || it == "nff");
        scenes.extend(entries.into_iter().map(|entry| entry.path()).filter(is_scene));
    }
    scenes.sort();

    let mut rows = Vec::new();
    let mut names = Vec::new();
    for scene in &scenes {
        for kind in AccelKind::ALL {
            for sampler in ["single", "regular:2"] {
                // Four times the rays add no information, and a long list is slow.
                if sampler != "single" && kind != AccelKind::Bvh {
                    continue;
                }
                let [(small, counts), (tiny, few)] =
                    [measured(scene, kind, sampler, SIZES[0])?, measured(scene, kind, sampler, SIZES[1])?];
                let (counts, few) = (events(&counts, kind), events(&few, kind));
                rows.push((std::array::from_fn(|i| counts[i] - few[i]), small - tiny));
                names.push((
                    kind,
                    format!("{} {sampler}", scene.file_name().unwrap_or_default().to_string_lossy()),
                ));
                eprintln!("{} {kind} {sampler}: {:.0}", scene.display(), small - tiny);
            }
        }
    }
    let weights = fit(&rows);
    println!("camera, secondary, shadow, shape, skipped: {:.0?}", &weights[..5]);
    let mut off: BTreeMap<&str, Vec<(f64, &str)>> = BTreeMap::new();
    for ((events, instructions), (kind, name)) in rows.iter().zip(&names) {
        let predicted: f64 = events.iter().zip(&weights).map(|(count, weight)| count * weight).sum();
        off.entry(kind.name()).or_default().push((predicted / instructions - 1.0, name));
    }
    for kind in AccelKind::ALL {
        let mut errors = off.remove(kind.name()).unwrap_or_default();
        errors.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        let quantile = |fraction: f64| {
            errors.get(((errors.len() - 1) as f64 * fraction) as usize).copied().unwrap_or_default()
        };
        let event = 5 + 2 * kind as usize;
        println!(
            "{kind}: box {:.0}, region {:.0}; median error {:.1} %, 90th percentile {:.1} %, maximum {:+.1} % ({})",
            weights[event],
            weights[event + 1],
            100.0 * quantile(0.5).0.abs(),
            100.0 * quantile(0.9).0.abs(),
            100.0 * quantile(1.0).0,
            quantile(1.0).1,
        );
    }
    Ok(ExitCode::SUCCESS)
}
