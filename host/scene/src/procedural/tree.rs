//! A binary tree: every branch ends in two shorter and thinner ones.
//!
//! Source: Aono and Kunii, "Botanical Tree Image Generation", IEEE CG&A 4(5), 1984, as used by `tree` of the Standard
//! Procedural Databases (Eric Haines, 1987), with its view, lights, materials and angles.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{ProceduralMaterial, SceneHeader, SceneWriter, ellipse_point, turns_to_radians};

const GROUND: ProceduralMaterial = ProceduralMaterial::matte("ground", [0.2, 0.7, 0.2], 1.0);
const WOOD: ProceduralMaterial = ProceduralMaterial::matte("wood", [0.55, 0.4, 0.2], 1.0);

/// The ratio of the radii at the end and at the base of a branch.
const TAPER: f64 = 0.67;

/// The two branches of a fork: relative length, tilt and azimuth in degrees.
const FORK: [(f64, f64, f64); 2] = [(0.65, 40.0, 0.0), (0.7, 25.0, 140.0)];

/// The axes of a branch: two perpendicular to it, and its direction.
type BranchAxes = [DVec3; 3];

/// Writes the scene; size 0 is a trunk.
pub fn write_scene(size: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
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
    writer.header(&SceneHeader {
        from: dvec3(4.5, 0.4, 2.0),
        at: dvec3(0.0, 0.0, 1.5),
        up,
        lights: &lights.map(|(x, y, z)| dvec3(x, y, z)),
    })?;
    writer.material(&GROUND)?;
    writer.polygon(
        &[(50.0, 50.0), (-50.0, 50.0), (-50.0, -50.0), (50.0, -50.0)].map(|(x, y)| dvec3(x, y, 0.0)),
    )?;
    writer.material(&WOOD)?;
    branch(size, (DVec3::ZERO, 0.15), 1.0, [dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0), up], writer)
}

/// A branch that starts at a point with a radius, and all its descendants.
fn branch(
    size: u32,
    base: (DVec3, f64),
    length: f64,
    axes: BranchAxes,
    writer: &mut dyn SceneWriter,
) -> io::Result<()> {
    let end = (base.0 + axes[2] * length, base.1 * TAPER);
    writer.cone(base, end)?;
    writer.sphere(end.0, end.1)?;
    if size == 0 {
        return Ok(());
    }
    for (ratio, lean, side) in FORK {
        branch(size - 1, end, length * ratio, child_axes(axes, lean, side), writer)?;
    }
    Ok(())
}

/// The axes of a branch that is tilted from its parent. The first one, along which the next fork is tilted, is
/// perpendicular to this tilt.
fn child_axes([x, y, z]: BranchAxes, lean: f64, side: f64) -> BranchAxes {
    let (lean, side) = (turns_to_radians(lean / 360.0), turns_to_radians(side / 360.0));
    let out = ellipse_point(side, x, y);
    let across = ellipse_point(side, y, -x);
    [across, ellipse_point(lean, -out, z), ellipse_point(lean, z, out)]
}
