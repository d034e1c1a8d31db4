//! A small dense object in a large sparse scene: a torus knot of 20 cm on a stand in the center of a stadium.
//!
//! This is the worst case of a uniform grid, known as the teapot in a stadium (Eric Haines, Ray Tracing News 1(3), 1988):
//! if cells are small enough for the knot, there are too many of them; if they are not, all of the knot is in one cell.
//! Unit: meters.

use std::io;

use glam::{DVec3, dvec3};

use super::knot::TorusKnot;
use super::writer::{ProceduralMaterial, SceneHeader, SceneWriter, ellipse_point, turns_to_radians};

/// The number of rows of seats, and of segments in each row.
const ROWS: u32 = 24;
const PIECES: u32 = 96;
/// The number of stripes of the lawn.
const STRIPES: u32 = 18;

/// The number of objects without the triangles of the knot: each segment has a top and a front, the stand a cylinder and
/// a top.
pub const OBJECTS: u64 = (2 * ROWS * PIECES + STRIPES + 2) as u64;

/// The height of the stand, and its radius.
const STAND: (f64, f64) = (1.0, 0.12);
/// The distance from the center of the knot to its outermost point.
const KNOT_RADIUS: f64 = 0.1;

const LAWN: [ProceduralMaterial; 2] = [
    ProceduralMaterial::matte("lawn", [0.27, 0.45, 0.2], 1.0),
    ProceduralMaterial::matte("mown lawn", [0.33, 0.53, 0.25], 1.0),
];
const STEPS: [ProceduralMaterial; 2] = [
    ProceduralMaterial::matte("seats", [0.62, 0.66, 0.7], 0.9),
    ProceduralMaterial::matte("fronts", [0.45, 0.5, 0.58], 0.9),
];
const WOOD: ProceduralMaterial = ProceduralMaterial::matte("stand", [0.72, 0.6, 0.45], 0.9);
const GOLD: ProceduralMaterial =
    ProceduralMaterial { name: "knot", color: [1.0, 0.72, 0.3], kd: 0.6, ks: 0.3, shine: 60.0, glass: None };

/// The knot on the stand.
pub fn knot(size: u32) -> TorusKnot {
    let scale = KNOT_RADIUS / TorusKnot::OUTER_RADIUS;
    TorusKnot::of(size).transformed(dvec3(0.0, 0.0, STAND.0 + KNOT_RADIUS), scale)
}

/// Writes the scene, with a knot of at least `size` triangles.
pub fn write_scene(size: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
    writer.header(&SceneHeader {
        from: dvec3(0.35, -1.05, 1.3),
        at: dvec3(0.0, 0.0, 1.22),
        up: dvec3(0.0, 0.0, 1.0),
        lights: &[dvec3(-60.0, -80.0, 90.0), dvec3(90.0, -30.0, 70.0)],
    })?;
    lawn(writer)?;
    for row in 0..ROWS {
        steps(row, writer)?;
    }
    writer.material(&WOOD)?;
    let up = dvec3(0.0, 0.0, STAND.0);
    writer.cone((DVec3::ZERO, STAND.1), (up, STAND.1))?;
    let rim = |k: u32| {
        up + ellipse_point(
            turns_to_radians(f64::from(k) / 48.0),
            dvec3(STAND.1, 0.0, 0.0),
            dvec3(0.0, STAND.1, 0.0),
        )
    };
    writer.polygon(&(0..48).map(rim).collect::<Vec<_>>())?;
    writer.material(&GOLD)?;
    writer.mesh(&knot(size))
}

/// Alternating light and dark stripes over the whole field.
fn lawn(writer: &mut dyn SceneWriter) -> io::Result<()> {
    let (half, width) = (row_half_axes(0), 2.0 * row_half_axes(0).0 / f64::from(STRIPES));
    for stripe in 0..STRIPES {
        writer.material(&LAWN[(stripe % 2) as usize])?;
        let left = -half.0 + width * f64::from(stripe);
        let corner = |x: f64, y: f64| dvec3(x, y, 0.0);
        writer.polygon(&[
            corner(left, -half.1),
            corner(left + width, -half.1),
            corner(left + width, half.1),
            corner(left, half.1),
        ])?;
    }
    Ok(())
}

/// The half axes of the ellipse in front of a row.
fn row_half_axes(row: u32) -> (f64, f64) {
    let back = 0.9 * f64::from(row);
    (62.0 + back, 44.0 + back)
}

/// The fronts and the tops of one row.
fn steps(row: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
    let height = |row: u32| 1.2 + 0.55 * f64::from(row);
    let below = if row == 0 { 0.0 } else { height(row - 1) };
    let at = |piece: u32, (length, width): (f64, f64), height: f64| {
        let angle = turns_to_radians(f64::from(piece % PIECES) / f64::from(PIECES));
        ellipse_point(angle, dvec3(length, 0.0, 0.0), dvec3(0.0, width, 0.0)) + dvec3(0.0, 0.0, height)
    };
    for (material, (low, high), (near, far)) in [
        (&STEPS[1], (below, height(row)), (row_half_axes(row), row_half_axes(row))),
        (&STEPS[0], (height(row), height(row)), (row_half_axes(row), row_half_axes(row + 1))),
    ] {
        writer.material(material)?;
        for piece in 0..PIECES {
            writer.polygon(&[
                at(piece, near, low),
                at(piece + 1, near, low),
                at(piece + 1, far, high),
                at(piece, far, high),
            ])?;
        }
    }
    Ok(())
}
