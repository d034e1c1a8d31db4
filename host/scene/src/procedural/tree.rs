//! A tree: every branch ends in two shorter and thinner ones.
//!
//! Source: Aono and Kunii, "Botanical Tree Image Generation", IEEE CG&A 4(5), 1984, as the
//! procedural databases' `tree` (Eric Haines, 1987) uses it, with its view, lights, surfaces and
//! angles.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{ProceduralMaterial, SceneHeader, SceneWriter, ellipse_point, turns_to_radians};

const GROUND: ProceduralMaterial = ProceduralMaterial::matte("ground", [0.2, 0.7, 0.2], 1.0);
const WOOD: ProceduralMaterial = ProceduralMaterial::matte("wood", [0.55, 0.4, 0.2], 1.0);

/// How much thinner a branch is at its end.
const TAPER: f64 = 0.67;

/// A branch: how long it is to the one before it, how far it leans, and to which side, in degrees.
const FORK: [(f64, f64, f64); 2] = [(0.65, 40.0, 0.0), (0.7, 25.0, 140.0)];

/// The directions of a branch: to one side, to another, and along it.
type BranchAxes = [DVec3; 3];

/// Draws it; a size of 0 is a trunk.
pub fn write_scene(size: u32, pen: &mut dyn SceneWriter) -> io::Result<()> {
    let lights = [
        (-5.0, 5.0, 50.0),
        (30.0, -30.0, 30.0),
        (-40.0, -30.0, 20.0),
        (10.0, 30.0, 40.0),
        (-30.0, 40.0, 10.0),
        (50.0, 25.0, 20.0),
        (-10.0, -60.0, 30.0),
    ];
    let up = dvec3(0.0, 0.0, 1.0);
    pen.header(&SceneHeader {
        from: dvec3(4.5, 0.4, 2.0),
        at: dvec3(0.0, 0.0, 1.5),
        up,
        lights: &lights.map(|(x, y, z)| dvec3(x, y, z)),
    })?;
    pen.material(&GROUND)?;
    pen.polygon(
        &[(50.0, 50.0), (-50.0, 50.0), (-50.0, -50.0), (50.0, -50.0)].map(|(x, y)| dvec3(x, y, 0.0)),
    )?;
    pen.material(&WOOD)?;
    branch(size, (DVec3::ZERO, 0.15), 1.0, [dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0), up], pen)
}

/// A branch from a place and a radius, and all that grow on it.
fn branch(
    size: u32,
    base: (DVec3, f64),
    length: f64,
    axes: BranchAxes,
    pen: &mut dyn SceneWriter,
) -> io::Result<()> {
    let end = (base.0 + axes[2] * length, base.1 * TAPER);
    pen.cone(base, end)?;
    pen.sphere(end.0, end.1)?;
    if size == 0 {
        return Ok(());
    }
    for (ratio, lean, side) in FORK {
        branch(size - 1, end, length * ratio, child_axes(axes, lean, side), pen)?;
    }
    Ok(())
}

/// The axes of a branch that leans away from another; its own two will fork upright on that.
fn child_axes([x, y, z]: BranchAxes, lean: f64, side: f64) -> BranchAxes {
    let (lean, side) = (turns_to_radians(lean / 360.0), turns_to_radians(side / 360.0));
    let out = ellipse_point(side, x, y);
    let across = ellipse_point(side, y, -x);
    [across, ellipse_point(lean, -out, z), ellipse_point(lean, z, out)]
}
