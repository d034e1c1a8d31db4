//! The sphereflake: a sphere with nine of a third of its size round it, each with nine more.
//!
//! Of the twelve places where equal balls touch one in the closest packing the nine are used that
//! do not look back: six round the equator and three above it. Above is away from the sphere
//! before, so each sphere turns the same nine places on the shortest way to where it looks.
//!
//! Source: the procedural databases' `balls` (Eric Haines, "A Proposal for Standard Graphics
//! Environments", IEEE CG&A 7(11), 1987), with its view, lights and surfaces.

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

/// Draws it; a size of 0 is one sphere.
pub fn write_scene(size: u32, pen: &mut dyn SceneWriter) -> io::Result<()> {
    let up = dvec3(0.0, 0.0, 1.0);
    pen.header(&SceneHeader {
        from: dvec3(2.1, 1.3, 1.7),
        at: DVec3::ZERO,
        up,
        lights: &[dvec3(4.0, 3.0, 2.0), dvec3(1.0, -4.0, 4.0), dvec3(-3.0, 1.0, 5.0)],
    })?;
    pen.material(&GROUND)?;
    pen.polygon(
        &[(12.0, 12.0), (-12.0, 12.0), (-12.0, -12.0), (12.0, -12.0)].map(|(x, y)| dvec3(x, y, -0.5)),
    )?;
    pen.material(&FLAKE)?;
    flake(size, DVec3::ZERO, 0.5, up, &places(), pen)
}

/// The directions of the nine round a sphere that looks up.
fn places() -> [DVec3; 9] {
    // The three above stand over the gaps of the six, with a height of sqrt(2/3).
    let (above, out) = ((2.0_f64 / 3.0).sqrt(), (1.0_f64 / 3.0).sqrt());
    let at = |twelfths: f64, out, above| {
        // Begins at 45 degrees, so that the flake looks at the eye.
        ellipse_point(turns_to_radians(0.125 + twelfths / 12.0), dvec3(out, 0.0, 0.0), dvec3(0.0, out, 0.0))
            + dvec3(0.0, 0.0, above)
    };
    let third = |k: f64| [at(4.0 * k, out, above), at(4.0 * k - 1.0, 1.0, 0.0), at(4.0 * k + 1.0, 1.0, 0.0)];
    let [[a, b, c], [d, e, f], [g, h, i]] = [third(0.0), third(1.0), third(2.0)];
    [a, b, c, d, e, f, g, h, i]
}

/// A sphere that looks `toward`, and all that grow on it.
fn flake(
    size: u32,
    center: DVec3,
    radius: f64,
    toward: DVec3,
    places: &[DVec3; 9],
    pen: &mut dyn SceneWriter,
) -> io::Result<()> {
    pen.sphere(center, radius)?;
    if size == 0 {
        return Ok(());
    }
    let smaller = radius / 3.0;
    for place in places {
        let away = rotate_from_z(toward, *place);
        flake(size - 1, center + away * (radius + smaller), smaller, away, places, pen)?;
    }
    Ok(())
}
