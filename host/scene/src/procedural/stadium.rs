//! A small dense thing in a large sparse one: a knot as wide as a hand on a stand in the middle of
//! a stadium.
//!
//! It is the case that a regular grid finds hardest, known as the teapot in the stadium (Eric
//! Haines, Ray Tracing News 1(3), 1988): where cells are small enough for the knot there are too
//! many of them, and where they are not, all of it lies in one. Unit: metres.

use std::io;

use glam::{DVec3, dvec3};

use super::knot::TorusKnot;
use super::writer::{ProceduralMaterial, SceneHeader, SceneWriter, ellipse_point, turns_to_radians};

/// Rows of seats, and how many pieces go round in each.
const ROWS: u32 = 24;
const PIECES: u32 = 96;
/// Stripes of the lawn.
const STRIPES: u32 = 18;

/// All objects but the triangles of the knot: steps have a top and a front, the stand a tube and
/// a top.
pub const OBJECTS: u64 = (2 * ROWS * PIECES + STRIPES + 2) as u64;

/// How high the stand is, and its radius.
const STAND: (f64, f64) = (1.0, 0.12);
/// From the middle of the knot to its outermost point.
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

/// Draws it, with a knot of at least as many triangles as its size.
pub fn write_scene(size: u32, pen: &mut dyn SceneWriter) -> io::Result<()> {
    pen.header(&SceneHeader {
        from: dvec3(0.35, -1.05, 1.3),
        at: dvec3(0.0, 0.0, 1.22),
        up: dvec3(0.0, 0.0, 1.0),
        lights: &[dvec3(-60.0, -80.0, 90.0), dvec3(90.0, -30.0, 70.0)],
    })?;
    lawn(pen)?;
    for row in 0..ROWS {
        steps(row, pen)?;
    }
    pen.material(&WOOD)?;
    let up = dvec3(0.0, 0.0, STAND.0);
    pen.cone((DVec3::ZERO, STAND.1), (up, STAND.1))?;
    let rim = |k: u32| {
        up + ellipse_point(
            turns_to_radians(f64::from(k) / 48.0),
            dvec3(STAND.1, 0.0, 0.0),
            dvec3(0.0, STAND.1, 0.0),
        )
    };
    pen.polygon(&(0..48).map(rim).collect::<Vec<_>>())?;
    pen.material(&GOLD)?;
    pen.mesh(&knot(size))
}

/// Stripes over the whole field, light and dark in turn.
fn lawn(pen: &mut dyn SceneWriter) -> io::Result<()> {
    let (half, width) = (row_half_axes(0), 2.0 * row_half_axes(0).0 / f64::from(STRIPES));
    for stripe in 0..STRIPES {
        pen.material(&LAWN[(stripe % 2) as usize])?;
        let left = -half.0 + width * f64::from(stripe);
        let corner = |x: f64, y: f64| dvec3(x, y, 0.0);
        pen.polygon(&[
            corner(left, -half.1),
            corner(left + width, -half.1),
            corner(left + width, half.1),
            corner(left, half.1),
        ])?;
    }
    Ok(())
}

/// Half of the length and of the width of the oval before a row.
fn row_half_axes(row: u32) -> (f64, f64) {
    let back = 0.9 * f64::from(row);
    (62.0 + back, 44.0 + back)
}

/// The fronts and the tops of one row.
fn steps(row: u32, pen: &mut dyn SceneWriter) -> io::Result<()> {
    let height = |row: u32| 1.2 + 0.55 * f64::from(row);
    let below = if row == 0 { 0.0 } else { height(row - 1) };
    let at = |piece: u32, (length, width): (f64, f64), height: f64| {
        let angle = turns_to_radians(f64::from(piece % PIECES) / f64::from(PIECES));
        ellipse_point(angle, dvec3(length, 0.0, 0.0), dvec3(0.0, width, 0.0)) + dvec3(0.0, 0.0, height)
    };
    for (surface, (low, high), (near, far)) in [
        (&STEPS[1], (below, height(row)), (row_half_axes(row), row_half_axes(row))),
        (&STEPS[0], (height(row), height(row)), (row_half_axes(row), row_half_axes(row + 1))),
    ] {
        pen.material(surface)?;
        for piece in 0..PIECES {
            pen.polygon(&[
                at(piece, near, low),
                at(piece + 1, near, low),
                at(piece + 1, far, high),
                at(piece, far, high),
            ])?;
        }
    }
    Ok(())
}
