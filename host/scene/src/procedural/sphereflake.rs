//! The sphereflake: a sphere with nine spheres of a third of its size around it, recursively.
//!
//! Of the twelve contact points of the closest sphere packing nine are used: six around the equator and three above it.
//! "Above" is the direction outward from the parent sphere, so the nine directions are rotated from z to this direction by
//! the shortest rotation.
//!
//! Source: `balls` of the Standard Procedural Databases (Eric Haines, "A Proposal for Standard Graphics Environments",
//! IEEE CG&A 7(11), 1987), with its view, lights and materials.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{
    ProceduralMaterial, SceneHeader, SceneWriter, ellipse_point, rotate_from_z, turns_to_radians,
};

const GROUND: ProceduralMaterial = ProceduralMaterial::matte("ground", [1.0, 0.75, 0.33], 0.8);
const FLAKE: ProceduralMaterial = ProceduralMaterial {
    name: "flake",
    color: [1.0, 0.9, 0.7],
    kd: 0.5,
    ks: 0.5,
    shine: 3.0827,
    glass: None,
};

/// Writes the scene; size 0 is one sphere.
pub fn write_scene(size: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
    let up = dvec3(0.0, 0.0, 1.0);
    writer.header(&SceneHeader {
        from: dvec3(2.1, 1.3, 1.7),
        at: DVec3::ZERO,
        up,
        lights: &[dvec3(4.0, 3.0, 2.0), dvec3(1.0, -4.0, 4.0), dvec3(-3.0, 1.0, 5.0)],
    })?;
    writer.material(&GROUND)?;
    writer.polygon(
        &[(12.0, 12.0), (-12.0, 12.0), (-12.0, -12.0), (12.0, -12.0)].map(|(x, y)| dvec3(x, y, -0.5)),
    )?;
    writer.material(&FLAKE)?;
    flake(size, DVec3::ZERO, 0.5, up, &directions(), writer)
}

/// The directions of the nine children of a sphere whose parent is below it.
fn directions() -> [DVec3; 9] {
    // The three above are over the gaps of the six, at a height of sqrt(2/3).
    let (above, out) = ((2.0_f64 / 3.0).sqrt(), (1.0_f64 / 3.0).sqrt());
    let at = |twelfths: f64, out, above| {
        // Starts at 45 degrees, so that the flake faces the camera.
        ellipse_point(turns_to_radians(0.125 + twelfths / 12.0), dvec3(out, 0.0, 0.0), dvec3(0.0, out, 0.0))
            + dvec3(0.0, 0.0, above)
    };
    let third = |k: f64| [at(4.0 * k, out, above), at(4.0 * k - 1.0, 1.0, 0.0), at(4.0 * k + 1.0, 1.0, 0.0)];
    let [[a, b, c], [d, e, f], [g, h, i]] = [third(0.0), third(1.0), third(2.0)];
    [a, b, c, d, e, f, g, h, i]
}

/// A sphere in the direction `toward` from its parent, and all its descendants.
fn flake(
    size: u32,
    center: DVec3,
    radius: f64,
    toward: DVec3,
    directions: &[DVec3; 9],
    writer: &mut dyn SceneWriter,
) -> io::Result<()> {
    writer.sphere(center, radius)?;
    if size == 0 {
        return Ok(());
    }
    let smaller = radius / 3.0;
    for direction in directions {
        let outward = rotate_from_z(toward, *direction);
        flake(size - 1, center + outward * (radius + smaller), smaller, outward, directions, writer)?;
    }
    Ok(())
}
