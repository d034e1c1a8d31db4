//! Boxes and rays that are hard for accelerators that divide space into cells.

use super::case::{as_f32, towards};
use strahl_test_scene::{DVec3, SplitMix64, TestRay, TestShape, dvec3};

/// Axis-aligned boxes, and rays.
pub(super) type BoxesAndRays = (Vec<TestShape>, Vec<TestRay>);

const RAYS: usize = 250;

/// Boxes with integer corners, which lie on the cell planes of subdivisions of the scene.
pub(super) fn at_integers(rng: &mut SplitMix64) -> BoxesAndRays {
    const SIDE: u32 = 8;
    let cube = |low: DVec3, size: DVec3| TestShape::Cuboid { min: low, max: low + size };
    // Two boxes in opposite corners fix the size of the scene.
    let mut shapes = vec![cube(DVec3::ZERO, DVec3::ONE), cube(DVec3::splat(7.0), DVec3::ONE)];
    for _ in 0..60 {
        let mut coordinate = || f64::from(rng.below(SIDE));
        let low = dvec3(coordinate(), coordinate(), coordinate());
        let mut size = || f64::from(rng.below(3)) * 0.5;
        let size = dvec3(size(), size(), size());
        shapes.push(cube(low, size));
    }
    let rays = (0..RAYS).map(|_| cell_plane_ray(f64::from(SIDE), rng)).collect();
    (shapes, rays)
}

/// A ray in a cell plane, along an edge, through corners or from one of them, or a random ray.
fn cell_plane_ray(side: f64, rng: &mut SplitMix64) -> TestRay {
    let half_integer = |rng: &mut SplitMix64| f64::from(rng.below(2 * side as u32 + 1)) * 0.5;
    let any = |rng: &mut SplitMix64| rng.between(-0.5 * side, 1.5 * side);
    let sign = |rng: &mut SplitMix64| if rng.below(2) == 0 { 1.0 } else { -1.0 };
    let corner = dvec3(half_integer(rng), half_integer(rng), half_integer(rng));
    let diagonal = dvec3(sign(rng), sign(rng), sign(rng));
    match rng.below(5) {
        // Through corners of cells, where three planes meet.
        0 => TestRay { origin: corner - diagonal * 20.0, direction: diagonal * rng.log_between(0.25, 4.0) },
        // From a corner, an edge or a plane.
        1 => {
            let mut origin = corner;
            for _ in 0..rng.below(3) {
                origin[rng.below(3) as usize] = any(rng);
            }
            TestRay { origin, direction: as_f32(rng.direction()) }
        }
        // In a plane or along an edge.
        2 | 3 => {
            let (mut origin, mut direction) = (corner - diagonal * 20.0, as_f32(rng.direction()));
            for axis in 0..3 {
                if rng.below(2) == 0 {
                    origin[axis] = corner[axis];
                    direction[axis] = if rng.below(2) == 0 { 0.0 } else { -0.0 };
                }
            }
            if direction == DVec3::ZERO {
                direction = DVec3::X;
            }
            TestRay { origin, direction }
        }
        _ => {
            let (from, to) = (dvec3(any(rng), any(rng), any(rng)), dvec3(any(rng), any(rng), any(rng)));
            TestRay { origin: from, direction: as_f32(to - from) }
        }
    }
}

/// A flat scene, a single box, many coincident boxes, or a scene with a distant outlier.
pub(super) fn degenerate(rng: &mut SplitMix64) -> BoxesAndRays {
    let (shapes, rays) = at_integers(rng);
    let bounds = |shape: &TestShape| match shape {
        TestShape::Cuboid { min, max } => (*min, *max),
        _ => (DVec3::ZERO, DVec3::ZERO),
    };
    let boxes = shapes.iter().map(bounds);
    let shapes = match rng.below(4) {
        0 => {
            let axis = rng.below(3) as usize;
            let level = |v: DVec3| {
                let mut v = v;
                v[axis] = 3.0;
                v
            };
            boxes.map(|(min, max)| TestShape::Cuboid { min: level(min), max: level(max) }).collect()
        }
        1 => vec![shapes[2 + rng.below(60) as usize].clone()],
        2 => {
            let (min, _) = bounds(&shapes[2 + rng.below(60) as usize]);
            (0..100).map(|_| TestShape::Cuboid { min, max: min + DVec3::splat(1.5) }).collect()
        }
        _ => {
            let far = as_f32(rng.direction() * rng.log_between(1e3, 1e6));
            let mut shapes: Vec<TestShape> = boxes.map(|(min, max)| TestShape::Cuboid { min, max }).collect();
            shapes.push(TestShape::Cuboid { min: far, max: as_f32(far + DVec3::ONE) });
            shapes
        }
    };
    (shapes, rays)
}

/// [`at_integers`], scaled and moved so that faces and cell planes are not integers: coordinates that were equal
/// differ by rounding.
pub(super) fn scaled_and_moved(rng: &mut SplitMix64) -> BoxesAndRays {
    let (shapes, rays) = at_integers(rng);
    let (size, shift) = (rng.log_between(0.01, 100.0), rng.in_ball(DVec3::ZERO, 10.0));
    let transform = |v: DVec3| as_f32((v + shift) * size);
    let shape = |shape: TestShape| match shape {
        TestShape::Cuboid { min, max } => TestShape::Cuboid { min: transform(min), max: transform(max) },
        other => other,
    };
    let ray = |ray: TestRay| TestRay { origin: transform(ray.origin), ..ray };
    (shapes.into_iter().map(shape).collect(), rays.into_iter().map(ray).collect())
}

/// Long bars, and small plates across their lower faces. A ray reaches a plate after hundreds of cells; right
/// behind the plate is the bar, which the accelerator has offered long before.
pub(super) fn long_row(rng: &mut SplitMix64) -> BoxesAndRays {
    const LENGTH: f64 = 3000.0;
    let (mut shapes, mut rays) = (Vec::new(), Vec::new());
    for _ in 0..5 {
        let (level, perpendicular) = (rng.between(0.3, 0.9), rng.between(0.1, 0.9));
        let (y, z) = (DVec3::Y * level, DVec3::Z * perpendicular);
        let (min, max) = (y + z - DVec3::Z * 0.05, y + z + dvec3(LENGTH, 0.05, 0.05));
        shapes.push(TestShape::Cuboid { min: as_f32(min), max: as_f32(max) });
        for _ in 0..RAYS / 5 {
            let at = rng.between(10.0, LENGTH);
            let (center, half) = (DVec3::X * at + y + z, dvec3(0.0, 0.003, 0.003));
            shapes.push(TestShape::Cuboid { min: as_f32(center - half), max: as_f32(center + half) });
            let viewpoint = dvec3(-rng.between(1.0, 10.0), level - 0.2, rng.between(0.0, 1.0));
            rays.push(towards(as_f32(viewpoint), as_f32(center + DVec3::X * rng.log_between(1e-3, 0.3))));
        }
    }
    (shapes, rays)
}
