//! Writes `tests/reports/hard-cases.md` and its picture.
//!
//! ```text
//! cargo run --release -p strahl-tests --example hard_cases
//! cargo run --release -p strahl-tests --example hard_cases -- --watertight 100000000
//! ```
//!
//! With `--watertight` nothing is written: that many rays are aimed from inside at edges and corners of closed
//! meshes, and those that get through are counted.

use strahl_tests::hard::{ClosedMesh, cases, escapes, panels, table};
use strahl_tests::{DVec3, SplitMix64, dvec3};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    match args.as_slice() {
        [] => write(),
        ["--watertight", rays] => {
            watertight(rays.parse()?);
            Ok(())
        }
        _ => Err("usage: hard_cases [--watertight RAYS]".into()),
    }
}

fn write() -> Result<(), Failure> {
    let (report, picture) = table::report();
    let outcomes: Vec<_> = cases().into_iter().map(|case| (case, case.run())).collect();
    std::fs::write(&report, table::text(&outcomes))?;

    let (width, pixels) = panels::picture();
    let height = pixels.len() / width;
    let bytes: Vec<u8> = pixels.into_iter().flatten().collect();
    let image =
        image::RgbImage::from_raw(width as u32, height as u32, bytes).ok_or("a picture of another size")?;
    image.save(&picture)?;
    println!("{} and {} written", report.display(), picture.display());
    Ok(())
}

/// Rays at edges and corners of closed meshes from inside: how many, and how many get out.
fn watertight(rays: usize) {
    let far = dvec3(2e5, -1.3e5, 0.7e5);
    let shares = [
        ("a sphere of 20,480 triangles", ClosedMesh::icosphere(5, DVec3::ZERO, 1.0), 30),
        ("the same, 2e5 from the origin", ClosedMesh::icosphere(5, far, 100.0), 30),
        ("a cube", ClosedMesh::cube(dvec3(0.1, 0.2, 0.3), 1.0), 10),
        ("the same, 2e5 from the origin", ClosedMesh::cube(far, 3.0), 10),
        ("a sheet of 5,000", ClosedMesh::sheet(50, DVec3::ZERO, 1.0), 9),
        ("the same, 2e5 from the origin", ClosedMesh::sheet(50, far, 100.0), 9),
        ("a cone of 1,000 slivers", ClosedMesh::fan(1000, DVec3::ZERO, 1.0), 1),
        ("the same, 2e5 from the origin", ClosedMesh::fan(1000, far, 100.0), 1),
    ];
    let (mut all, mut out) = (0, 0);
    for (seed, (name, mesh, share)) in shares.iter().enumerate() {
        let count = rays / 100 * share;
        let got_out = escapes(mesh, count, &mut SplitMix64::new(seed as u64));
        println!("{name}: {count} rays, {got_out} got through");
        all += count;
        out += got_out;
    }
    println!("all: {all} rays, {out} got through");
}
