//! Writes `tests/reports/hard-cases.md` and its picture.
//!
//! ```text
//! cargo run --release -p strahl-tests --example hard_cases
//! cargo run --release -p strahl-tests --example hard_cases -- --watertight 100000000
//! ```
//!
//! With `--watertight` nothing is written: this number of rays is aimed from inside at edges and vertices of
//! closed meshes, and those that escape are counted.

use strahl_test_scene::{DVec3, SplitMix64, dvec3};
use strahl_tests::hard::{ClosedMesh, cases, escapes, panels, table};

type ExampleError = Box<dyn std::error::Error>;

fn main() -> Result<(), ExampleError> {
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

fn write() -> Result<(), ExampleError> {
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

/// Prints the numbers of rays from inside at edges and vertices of closed meshes, and of those that escape.
fn watertight(rays: usize) {
    let far = dvec3(2e5, -1.3e5, 0.7e5);
    let meshes = [
        ("a sphere of 20,480 triangles", ClosedMesh::icosphere(5, DVec3::ZERO, 1.0), 30),
        ("the same, 2e5 from the origin", ClosedMesh::icosphere(5, far, 100.0), 30),
        ("a cube", ClosedMesh::cube(dvec3(0.1, 0.2, 0.3), 1.0), 10),
        ("the same, 2e5 from the origin", ClosedMesh::cube(far, 3.0), 10),
        ("a sheet of 5,000", ClosedMesh::sheet(50, DVec3::ZERO, 1.0), 9),
        ("the same, 2e5 from the origin", ClosedMesh::sheet(50, far, 100.0), 9),
        ("a cone of 1,000 slivers", ClosedMesh::fan(1000, DVec3::ZERO, 1.0), 1),
        ("the same, 2e5 from the origin", ClosedMesh::fan(1000, far, 100.0), 1),
    ];
    let (mut all, mut escaped) = (0, 0);
    for (seed, (name, mesh, percent)) in meshes.iter().enumerate() {
        let count = rays / 100 * percent;
        let count_escaped = escapes(mesh, count, &mut SplitMix64::new(seed as u64));
        println!("{name}: {count} rays, {count_escaped} escaped");
        all += count;
        escaped += count_escaped;
    }
    println!("all: {all} rays, {escaped} escaped");
}
