//! Holds the counts of rays of the Standard Procedural Databases against the published ones
//! (Eric Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and the
//! documentation of the databases).
//!
//! ```text
//! cargo run --release -p strahl-tests --example spd -- FOLDER
//! ```
//!
//! `FOLDER` holds `balls.nff` ... `tree.nff` at their standard sizes. Each is rendered at
//! 512 x 512 with five levels, no cutoff and rays through the shared corners of the pixels. The
//! exit status is 1 when a count is off by more than 1 % (gears: 3 %).

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use strahl::counts::Counts;
use strahl::progress::Watch;
use strahl::signals::Signals;
use strahl::wanted::{Sampling, Wanted};
use strahl_core::{Limits, RayKind, Size};

/// Camera rays that hit, reflected, refracted and shadow rays, and how far off they may be.
///
/// The figures of gears are not the published ones, which contain the reflected rays of glass
/// that does not reflect, of weight zero, and all that those hit; they are those of an
/// independent count without them.
const PUBLISHED: [(&str, [u64; 4], f64); 7] = [
    ("balls", [263_169, 175_095, 0, 954_368], 0.01),
    ("gears", [245_086, 88_800, 99_800, 1_551_000], 0.03),
    ("mount", [173_125, 354_769, 354_769, 412_922], 0.01),
    ("rings", [263_169, 315_236, 0, 1_085_002], 0.01),
    ("teapot", [161_120, 225_248, 0, 407_656], 0.01),
    ("tetra", [49_788, 0, 0, 46_112], 0.01),
    ("tree", [169_836, 0, 0, 1_097_419], 0.01),
];

fn counts(counters: &Counts) -> [u64; 4] {
    let rays = |kind| counters.rays(kind);
    [counters.camera_hits(), rays(RayKind::Reflected), rays(RayKind::Transmitted), rays(RayKind::Shadow)]
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("usage: spd FOLDER")?);
    let wanted = Wanted {
        limits: Limits { levels: 5, cutoff: 0.0 },
        sampling: Sampling::CORNERS,
        ..Wanted::of(Size::new(512, 512).ok_or("no size")?)
    };
    println!("scene      camera hits    reflected    refracted       shadow  largest deviation  cpu seconds");
    let mut within = true;
    for (name, published, limit) in PUBLISHED {
        let description = strahl::load::load(&folder.join(name).with_extension("nff"))?;
        let frame = strahl::frame::trace(&description, &wanted, &Watch::silent(Signals::default()))?;
        let counters = frame.counters.ok_or("nothing was counted")?;
        if counters.rays(RayKind::Camera) != 513 * 513 {
            return Err(format!("{name}: {} camera rays", counters.rays(RayKind::Camera)).into());
        }
        let ours = counts(&counters);
        let off = |(ours, published): (&u64, &u64)| {
            let difference = ours.abs_diff(*published) as f64;
            if difference == 0.0 { 0.0 } else { difference / *published as f64 }
        };
        let worst = ours.iter().zip(&published).map(off).fold(0.0, f64::max);
        within &= worst <= limit;
        let [hits, reflected, refracted, shadow] = ours;
        println!(
            "{name:8} {hits:>13} {reflected:>12} {refracted:>12} {shadow:>12} {:>10.3} % of {:.0} % {:>12.2}",
            100.0 * worst,
            100.0 * limit,
            frame.trace_cpu.as_secs_f64(),
        );
    }
    Ok(if within { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
