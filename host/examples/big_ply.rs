//! Writes a large PLY file and measures how fast it is read.
//!
//! ```text
//! cargo run --release -p strahl --example big_ply -- 500000 knot.ply [ascii] [normals]
//! ```
//!
//! The model is a torus knot, a tube along a curve that winds twice round and three times
//! through; as many triangles as asked for, or a few less.

use std::io::Write;
use std::path::Path;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [triangles, path, options @ ..] = args.as_slice() else {
        return Err("how many triangles, and the file to write?".into());
    };
    let has = |option: &str| options.iter().any(|o| o == option);
    let file = knot(triangles.parse()?, has("ascii"), has("normals"))?;
    std::fs::write(path, &file)?;

    let megabytes = file.len() as f64 / 1e6;
    let clock = Instant::now();
    let mesh = strahl_scene::mesh::read(Path::new(path))?;
    let seconds = clock.elapsed().as_secs_f64();
    println!(
        "{} triangles, {megabytes:.1} MB in {seconds:.3} s: {:.0} MB/s",
        mesh.triangles.len(),
        megabytes / seconds
    );
    Ok(())
}

/// The file of a torus knot of about so many triangles.
fn knot(triangles: usize, ascii: bool, normals: bool) -> std::io::Result<Vec<u8>> {
    // Rings of vertices around the tube, six times as many rings as vertices in a ring.
    let around = ((triangles / 2) as f64 / 6.0).sqrt().max(3.0) as usize;
    let along = (triangles / 2 / around).max(3);
    let mut file = Vec::new();
    writeln!(file, "ply\nformat {} 1.0", if ascii { "ascii" } else { "binary_little_endian" })?;
    writeln!(file, "comment a torus knot\nelement vertex {}", around * along)?;
    let names = ["x", "y", "z", "nx", "ny", "nz"];
    for name in &names[..if normals { 6 } else { 3 }] {
        writeln!(file, "property float {name}")?;
    }
    writeln!(
        file,
        "element face {}\nproperty list uchar int vertex_indices\nend_header",
        2 * around * along
    )?;

    for ring in 0..along {
        for vertex in 0..around {
            let u = std::f64::consts::TAU * ring as f64 / along as f64;
            let v = std::f64::consts::TAU * vertex as f64 / around as f64;
            let (center, side, up) = spine(u);
            let normal = [0, 1, 2].map(|i| v.cos() * side[i] + v.sin() * up[i]);
            let point = [0, 1, 2].map(|i| center[i] + 0.36 * normal[i]);
            let numbers = point.into_iter().chain(normal.into_iter().take(if normals { 3 } else { 0 }));
            for number in numbers.map(|x| x as f32) {
                if ascii { write!(file, "{number} ")? } else { file.write_all(&number.to_le_bytes())? }
            }
            if ascii {
                writeln!(file)?;
            }
        }
    }
    for ring in 0..along {
        for vertex in 0..around {
            let corner = |r: usize, p: usize| ((ring + r) % along * around + (vertex + p) % around) as i32;
            for face in
                [[corner(0, 0), corner(1, 0), corner(1, 1)], [corner(0, 0), corner(1, 1), corner(0, 1)]]
            {
                if ascii {
                    writeln!(file, "3 {} {} {}", face[0], face[1], face[2])?;
                } else {
                    file.push(3);
                    face.iter().try_for_each(|corner| file.write_all(&corner.to_le_bytes()))?;
                }
            }
        }
    }
    Ok(file)
}

/// The center of the tube at the parameter `u`, and two unit vectors perpendicular to the tube and to each other.
fn spine(u: f64) -> ([f64; 3], [f64; 3], [f64; 3]) {
    let at = |u: f64| {
        let r = 2.0 + (3.0 * u).cos();
        [r * (2.0 * u).cos(), r * (2.0 * u).sin(), 1.2 + (3.0 * u).sin()]
    };
    let (center, ahead) = (at(u), at(u + 1e-4));
    let along = unit([0, 1, 2].map(|i| ahead[i] - center[i]));
    let side = unit(cross(along, [0.0, 0.0, 1.0]));
    (center, side, cross(side, along))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}
