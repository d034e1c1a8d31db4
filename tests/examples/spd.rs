//! Compares the ray counts of the Standard Procedural Databases with the published ones (Eric Haines, "A
//! Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and the documentation of the
//! databases).
//!
//! ```text
//! cargo run --release -p strahl-tests --example spd -- FOLDER
//! ```
//!
//! `FOLDER` contains `balls.nff` to `tree.nff` at their standard sizes. Each is rendered at 512 x 512 with
//! five levels, no cutoff and rays through the shared corners of the pixels, with each accelerator, and with
//! grid and octree again without mailbox. Prints box and shape tests, visited leaves, the fraction of items
//! that a mailbox skipped, and the processor time.
//!
//! The exit status is 1 if a count differs by more than 1 % (gears: 3 %), if two accelerators make different
//! pictures, or if the choice of `--accel auto` needs more than 1.3 times the processor time of the best.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use strahl_core::Resolution;
use strahl_core::tally::{Counters, RayKind};
use strahl_engine::{NoProgress, RenderOptions};
use strahl_session::RenderOutput;
use strahl_settings::{AccelKind, AccelSettings, ResolvedAccel, SamplerSettings, Settings};

/// Camera rays that hit, reflected, refracted and shadow rays, and their tolerance.
///
/// The published counts of gears include reflected rays of weight zero, and their descendants, at glass that
/// does not reflect. These are the counts of an independent program without them.
const PUBLISHED: [(&str, [u64; 4], f64); 7] = [
    ("balls", [263_169, 175_095, 0, 954_368], 0.01),
    ("gears", [245_086, 88_800, 99_800, 1_551_000], 0.03),
    ("mount", [173_125, 354_769, 354_769, 412_922], 0.01),
    ("rings", [263_169, 315_236, 0, 1_085_002], 0.01),
    ("teapot", [161_120, 225_248, 0, 407_656], 0.01),
    ("tetra", [49_788, 0, 0, 46_112], 0.01),
    ("tree", [169_836, 0, 0, 1_097_419], 0.01),
];

fn counts(counters: &Counters) -> [u64; 4] {
    let rays = |kind| counters.rays[kind];
    [counters.camera_hits, rays(RayKind::Reflected), rays(RayKind::Transmitted), rays(RayKind::Shadow)]
}

/// Maximum time of the chosen accelerator, as a multiple of the best.
const MAX_RATIO: f64 = 1.3;

/// Tolerance for other load, in seconds.
const NOISE: f64 = 0.05;

/// All accelerators, and those with a mailbox also without it.
fn accelerators() -> Vec<AccelSettings> {
    let with_mailbox = AccelKind::ALL.map(AccelSettings::with_kind);
    let without = [AccelKind::Grid, AccelKind::Octree]
        .map(|kind| AccelSettings { mailbox: 0, ..AccelSettings::with_kind(kind) });
    [&with_mailbox[..], &without].concat()
}

/// Prints the ray counts. Returns whether they are within the tolerance of the published ones.
fn check_counts(name: &str, counters: &Counters, published: [u64; 4], limit: f64) -> bool {
    let ours = counts(counters);
    let off = |(ours, published): (&u64, &u64)| {
        let difference = ours.abs_diff(*published) as f64;
        if difference == 0.0 { 0.0 } else { difference / *published as f64 }
    };
    let worst = ours.iter().zip(&published).map(off).fold(0.0, f64::max);
    let [hits, reflected, refracted, shadow] = ours;
    println!(
        "\n{name}: {hits} camera rays hit, {reflected} reflected, {refracted} refracted, {shadow} shadow; \
         off by {:.3} % of {:.0} %",
        100.0 * worst,
        100.0 * limit,
    );
    worst <= limit && counters.rays[RayKind::Camera] == 513 * 513
}

/// Prints the work of one accelerator. Returns its processor seconds.
fn print_row(frame: &RenderOutput, counters: &Counters) -> f64 {
    let (shapes, skipped) = (counters.shape_tests.sum(), counters.mailbox_hits.sum());
    let skipped_percent = 100.0 * skipped as f64 / (shapes + skipped).max(1) as f64;
    let seconds = frame.trace_cpu.as_secs_f64();
    println!(
        "  {:28} {:>11} boxes {shapes:>10} shapes {:>9} regions {skipped_percent:>5.1} % skipped {seconds:>7.2} s",
        frame.accelerator.choice.to_string(),
        counters.box_tests.sum(),
        counters.leaf_visits.sum(),
    );
    seconds
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("usage: spd FOLDER")?);
    let size = Resolution::new(512, 512).ok_or("no size")?;
    let settings =
        Settings { size, levels: 5, cutoff: 0.0, sampler: SamplerSettings::CORNERS, ..Settings::default() };
    let mut passed = true;
    for (name, published, limit) in PUBLISHED {
        let description = strahl_scene::load(&folder.join(name).with_extension("nff"))?;
        let mut first: Option<(String, Counters)> = None;
        let mut seconds = Vec::new();
        for accel in accelerators() {
            let settings = settings.clone().with_acceleration(accel);
            let options = RenderOptions::COUNT_TESTS;
            let frame = strahl_session::render(&description, &settings, &options, &NoProgress)?;
            let counters = frame.counters;
            let digest = frame.picture.digest().to_string();
            let (same, rays) = first.get_or_insert_with(|| {
                passed &= check_counts(name, &counters, published, limit);
                (digest.clone(), counters)
            });
            seconds.push((frame.accelerator.choice, print_row(&frame, &counters)));
            if digest != *same || counts(&counters) != counts(rays) {
                println!("  a different picture: {digest}");
                passed = false;
            }
        }
        let taken = AccelSettings::DEFAULT.resolve(description.objects.len());
        let is_taken =
            |(choice, _): &&(ResolvedAccel, f64)| ResolvedAccel { reason: taken.reason, ..*choice } == taken;
        let by_auto = seconds.iter().find(is_taken).ok_or("auto chooses another accelerator")?.1;
        let best = seconds.iter().map(|(_, seconds)| *seconds).fold(f64::INFINITY, f64::min);
        println!("  auto chooses the {taken} ({}): {:.2} times the best", taken.reason, by_auto / best);
        passed &= by_auto <= MAX_RATIO * best + NOISE;
    }
    Ok(if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
