//! Writes `tests/HARD-CASES.md` and its picture from the figures of the tests.
//!
//! ```text
//! cargo run --release -p strahl-tests --example hard_cases              # the table and the picture
//! cargo run --release -p strahl-tests --example hard_cases -- --measure # what remedies cost, too
//! cargo run --release -p strahl-tests --example hard_cases -- --watertight 100000000
//! ```
//!
//! Instructions are counted by callgrind, which is a part of valgrind; where that is not at hand, and
//! without `--measure`, the costs that stand in the file are kept. All of it takes a minute; 10^8 rays
//! take about half a minute.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use strahl_tests::hard::cost::{Work, works};
use strahl_tests::hard::remedies::{Remedy, Tried, remedies};
use strahl_tests::hard::{Mesh, cases, escapes, panels, table};
use strahl_tests::{Random, Vector, vector};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    match args.as_slice() {
        [] => write(false),
        ["--measure"] => write(true),
        ["--count"] => {
            let works = all_works();
            works.iter().for_each(measured);
            // Callgrind writes down what came before a call: one more.
            works.iter().take(1).for_each(measured);
            Ok(())
        }
        ["--watertight", rays] => {
            watertight(rays.parse()?);
            Ok(())
        }
        _ => Err("usage: hard_cases [--measure | --watertight RAYS]".into()),
    }
}

/// All rays of a piece of work. Its name is what callgrind looks for.
#[inline(never)]
fn measured(work: &Work) {
    std::hint::black_box(work.run());
}

/// Everything that is counted, in one order: the families' works, then the remedies' on ordinary
/// rays.
fn all_works() -> Vec<Work> {
    let families = works().into_iter().flat_map(|(_, works)| works);
    let remedies = remedies().into_iter().flat_map(|remedy| remedy.trial().ordinary);
    families.chain(remedies).collect()
}

fn write(measure: bool) -> Result<(), Failure> {
    let (page, picture) = table::page();
    let outcomes: Vec<_> = cases().into_iter().map(|case| (case, case.run())).collect();
    let (all, hard): (Vec<(Remedy, Tried)>, Vec<[Work; 2]>) = remedies()
        .into_iter()
        .map(|remedy| {
            let (tried, works) = remedy.tried();
            ((remedy, tried), works)
        })
        .unzip();
    let kept = std::fs::read_to_string(&page).unwrap_or_default();
    let measured = if measure { figures(&all, &hard) } else { Ok(table::Figures::kept(&kept)) };
    let (figures, failure) = match measured {
        Ok(figures) => (figures, None),
        Err(failure) => (table::Figures::kept(&kept), Some(failure)),
    };
    std::fs::write(&page, table::text(&outcomes, &all, &figures))?;

    let (width, pixels) = panels::picture();
    let height = pixels.len() / width;
    let bytes: Vec<u8> = pixels.into_iter().flatten().collect();
    let image =
        image::RgbImage::from_raw(width as u32, height as u32, bytes).ok_or("a picture of another size")?;
    image.save(&picture)?;
    println!("{} and {} written", page.display(), picture.display());
    match failure {
        None => Ok(()),
        Some(failure) => Err(format!("{failure}; the figures of the costs stay as they were").into()),
    }
}

/// What the families and the remedies cost; `hard` are the rays that take the time of each.
fn figures(remedies: &[(Remedy, Tried)], hard: &[[Work; 2]]) -> Result<table::Figures, Failure> {
    let families = works();
    let counts = instructions(3 * families.len() + 2 * remedies.len())?;
    let (of_families, of_remedies) = counts.split_at(3 * families.len());
    let mut figures = table::Figures::default();
    for ((family, works), counts) in families.iter().zip(of_families.chunks(3)) {
        let per_ray: Vec<f64> =
            works.iter().zip(counts).map(|(work, count)| count / work.rays as f64).collect();
        let times: Vec<f64> = works.iter().map(time).collect();
        figures.family(family, &per_ray, &times);
    }
    for (((remedy, _), hard), counts) in remedies.iter().zip(hard).zip(of_remedies.chunks(2)) {
        let ordinary = remedy.trial().ordinary;
        let per_ray: Vec<f64> =
            ordinary.iter().zip(counts).map(|(work, count)| count / work.rays as f64).collect();
        let times: Vec<f64> = hard.iter().map(time).collect();
        figures.remedy(remedy, &per_ray, &times);
    }
    Ok(figures)
}

/// Nanoseconds for each ray: the least of some runs.
fn time(work: &Work) -> f64 {
    let once = || {
        let start = Instant::now();
        measured(work);
        start.elapsed().as_secs_f64() * 1e9 / work.rays as f64
    };
    // Each is short, so that among many some were not interrupted.
    let end = Instant::now() + Duration::from_millis(400);
    (0..1000).map_while(|i| (i < 10 || Instant::now() < end).then(once)).fold(f64::INFINITY, f64::min)
}

/// The instructions of each call of [`measured`], counted in a process of its own.
fn instructions(calls: usize) -> Result<Vec<f64>, Failure> {
    let folder = std::env::temp_dir().join(format!("hard-cases-{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    let status = Command::new("valgrind")
        .args(["--tool=callgrind", "--dump-before=*measured*"])
        .arg(format!("--callgrind-out-file={}", folder.join("out").display()))
        .arg(std::env::current_exe()?)
        .arg("--count")
        .output()
        .map(|output| output.status);
    // The first file has what came before the first call.
    let counts = (2..calls + 2).map(|file| counted(&folder.join(format!("out.{file}")))).collect();
    std::fs::remove_dir_all(&folder)?;
    match status {
        Err(error) => Err(format!("valgrind, which counts instructions, cannot be run: {error}").into()),
        Ok(status) if !status.success() => Err(format!("valgrind failed: {status}").into()),
        Ok(_) => counts,
    }
}

/// The sum in one of callgrind's files.
fn counted(file: &Path) -> Result<f64, Failure> {
    let text = std::fs::read_to_string(file)?;
    let sum = text.lines().find_map(|line| line.strip_prefix("totals: "));
    Ok(sum.ok_or("callgrind has counted nothing")?.trim().parse()?)
}

/// Rays at edges and corners of closed meshes from inside: how many, and how many get out.
fn watertight(rays: usize) {
    let far = vector(2e5, -1.3e5, 0.7e5);
    let shares = [
        ("a sphere of 20,480 triangles", Mesh::icosphere(5, Vector::ZERO, 1.0), 30),
        ("the same, 2e5 from the origin", Mesh::icosphere(5, far, 100.0), 30),
        ("a cube", Mesh::cube(vector(0.1, 0.2, 0.3), 1.0), 10),
        ("the same, 2e5 from the origin", Mesh::cube(far, 3.0), 10),
        ("a sheet of 5,000", Mesh::sheet(50, Vector::ZERO, 1.0), 9),
        ("the same, 2e5 from the origin", Mesh::sheet(50, far, 100.0), 9),
        ("a cone of 1,000 slivers", Mesh::fan(1000, Vector::ZERO, 1.0), 1),
        ("the same, 2e5 from the origin", Mesh::fan(1000, far, 100.0), 1),
    ];
    let (mut all, mut out) = (0, 0);
    for (seed, (name, mesh, share)) in shares.iter().enumerate() {
        let count = rays / 100 * share;
        let got_out = escapes(mesh, count, &mut Random::new(seed as u64));
        println!("{name}: {count} rays, {got_out} got through");
        all += count;
        out += got_out;
    }
    println!("all: {all} rays, {out} got through");
}
