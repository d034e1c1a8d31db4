//! Rings: a pyramid of groups of six interlocked rings, each of five cylinders and five spheres.
//!
//! The rings of a group are in the six planes through its center that are perpendicular to the diagonals of an
//! icosahedron; layer k of the pyramid has k x k groups.
//!
//! Source: `rings` of the Standard Procedural Databases (Eric Haines, 1987; after Kay and Kajiya's pyramid), with its
//! view, lights, materials and dimensions.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{ProceduralMaterial, SceneHeader, SceneWriter, ellipse_point, turns_to_radians};

/// The distance between layers, 1 / sin(22.5 degrees); groups in a layer are at a distance of 2.
const LAYER: f64 = 2.613_125_929_752_753;
/// The radius of a ring, from its center to its spheres.
const RING: f64 = 0.930_995;
/// The radius of cylinders and spheres.
const TUBE: f64 = 0.074_12;

const GROUND: ProceduralMaterial = ProceduralMaterial::matte("ground", [1.0; 3], 1.0);
const RINGS: [ProceduralMaterial; 6] = [
    ring("red", [1.0, 0.0, 0.0]),
    ring("green", [0.0, 1.0, 0.0]),
    ring("blue", [0.0, 0.0, 1.0]),
    ring("cyan", [0.0, 1.0, 1.0]),
    ring("magenta", [1.0, 0.0, 1.0]),
    ring("yellow", [1.0, 1.0, 0.0]),
];

const fn ring(name: &'static str, color: [f32; 3]) -> ProceduralMaterial {
    ProceduralMaterial { name, color, kd: 0.5, ks: 0.2, shine: 3.0827, glass: None }
}

/// Writes the scene; size 1 is one group.
pub fn write_scene(size: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
    let at = dvec3(-1.0, 1.0 - LAYER, 0.5);
    writer.header(&SceneHeader {
        from: dvec3(-1.0, -LAYER, 0.5),
        at,
        up: dvec3(0.0, 0.0, 1.0),
        lights: &[dvec3(3.0, -LAYER, 3.0), dvec3(-4.0, -LAYER, 1.0), dvec3(2.0, -LAYER, -4.0)],
    })?;
    let n = f64::from(size);
    // The wall is one layer behind the last, and as wide as that of the databases at their size.
    let (wall, reach) = (LAYER * (n + 1.0), 1.405_564 * n);
    writer.material(&GROUND)?;
    writer.polygon(&[
        dvec3(reach - 1.0, wall, reach + 0.5),
        dvec3(-reach - 1.0, wall, reach + 0.5),
        dvec3(-reach - 1.0, wall, 0.5 - reach),
        dvec3(reach - 1.0, wall, 0.5 - reach),
    ])?;
    for layer in 1..=size {
        let position = |k: u32| 2.0 * f64::from(k) - f64::from(layer - 1);
        for row in 0..layer {
            for column in 0..layer {
                group(dvec3(position(column), LAYER * f64::from(layer), position(row)), writer)?;
            }
        }
    }
    Ok(())
}

/// Six rings around a center.
fn group(center: DVec3, writer: &mut dyn SceneWriter) -> io::Result<()> {
    for (material, number) in RINGS.iter().zip(0..) {
        writer.material(material)?;
        let (first, second) = ring_axes(number);
        let ball =
            |k: u32| center + ellipse_point(turns_to_radians(f64::from(k) / 5.0), first, second) * RING;
        for k in 0..5 {
            writer.cone((ball(k), TUBE), (ball((k + 4) % 5), TUBE))?;
            writer.sphere(ball(k), TUBE)?;
        }
    }
    Ok(())
}

/// Two perpendicular directions in the plane of a ring: the first ring is horizontal, the others are tilted.
fn ring_axes(number: u32) -> (DVec3, DVec3) {
    if number == 0 {
        return (dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0));
    }
    let angle = turns_to_radians(0.1 + 0.2 * f64::from(number - 1));
    let first = ellipse_point(angle, dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0));
    // The six diagonals of an icosahedron meet at the cosine 1 / sqrt(5).
    let (up, out) = ((0.2_f64).sqrt(), (0.8_f64).sqrt());
    let normal = dvec3(first.y * out, -first.x * out, up);
    (first, normal.cross(first))
}
