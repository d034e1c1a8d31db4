//! The line between light and shadow on coarse smooth balls: a point whose shading normal faces the
//! light must not stand in the shadow of its own ball, and in that of something else it must.

use super::case::{HardCase, HardCaseTally, Solver, as_f32, aside, length, towards};
use super::mesh::ClosedMesh;
use crate::cast::{CoreHit, TestedCore};
use crate::test_shape::{TestRay, TestShape};
use crate::textbook;
use crate::vector::{DVec3, dvec3};
use crate::{SplitMix64, single};

const fn case(
    name: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own("shadow terminator", name, naive, 0.0, check)
}

pub(super) const CASES: [HardCase; 2] = [
    case("smooth balls of 20 to 320 triangles", "whole triangles lie in their own shadow", |rng| {
        tried(false, rng)
    }),
    case("the same with a plate before the light", "a plate that is skipped casts no shadow", |rng| {
        tried(true, rng)
    })
    .easy(),
];

/// A smooth ball of triangles, with a plate towards the light or without.
fn ball(level: u32, center: DVec3, radius: f64, plate: Option<DVec3>) -> Vec<TestShape> {
    let mesh = ClosedMesh::icosphere(level, center, radius);
    let corners = |triangle: &[u32; 3]| triangle.map(|corner| mesh.points[corner as usize]);
    let smooth = |corners: [DVec3; 3]| TestShape::SmoothTriangle {
        corners,
        normals: corners.map(|corner| as_f32((corner - center) / length(corner - center))),
    };
    let mut shapes: Vec<TestShape> = mesh.triangles.iter().map(corners).map(smooth).collect();
    if let Some(light) = plate {
        shapes.push(TestShape::Disc {
            center: as_f32(center + light * (1.6 * radius)),
            normal: light,
            radius: 3.0 * radius,
        });
    }
    shapes
}

/// Rays at a ball from the side, so that the line between light and shadow is seen, and not through
/// the plate.
fn eyes(center: DVec3, radius: f64, light: DVec3, rng: &mut SplitMix64) -> Vec<TestRay> {
    let ray = |_| {
        let side = aside(light, rng) - light * rng.between(-0.4, 0.6);
        let eye = as_f32(center + side * (radius * rng.between(2.0, 9.0)));
        towards(eye, rng.in_ball(center, radius))
    };
    (0..110).map(ray).collect()
}

fn tried(with_plate: bool, rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for round in 0..24 {
        let radius = rng.log_between(1e-3, 1e3);
        let center = rng.in_ball(DVec3::ZERO, 10.0 * radius);
        let light = rng.direction();
        let shapes = ball(round % 3, center, radius, with_plate.then_some(light));
        let eyes = eyes(center, radius, light, rng);
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let (shown, lit) = match solver {
                Solver::Textbook => in_textbook(&shapes, &eyes, light),
                Solver::Single => in_single::lit(&shapes, &eyes, light),
                Solver::Double => in_double::lit(&shapes, &eyes, light),
            };
            for ((hit, eye), lit) in shown.iter().zip(&eyes).zip(lit) {
                let is_plate = |item: u32| matches!(shapes[item as usize], TestShape::Disc { .. });
                let Some(hit) = hit.filter(|hit| !is_plate(hit.item)) else { continue };
                let facing = |n: DVec3| if hit.normal.dot(eye.direction) > 0.0 { -n } else { n };
                // What shows least of the light is left to rounding.
                if facing(hit.shading).dot(light) <= 1e-3 {
                    continue;
                }
                tally.rays += 1;
                tally.faults += usize::from(lit == with_plate);
            }
        }
    }
    tallies
}

/// What the core sees, lit where nothing is in the way of a ray from a little above it.
fn in_textbook(shapes: &[TestShape], eyes: &[TestRay], light: DVec3) -> (Vec<Option<CoreHit>>, Vec<bool>) {
    let scene = single::TestScene::with_shapes(shapes);
    let hit = scene.cast(eyes);
    let narrow = |v: DVec3| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
    let shadow = |(hit, eye): (&Option<CoreHit>, &TestRay)| {
        let hit = hit.as_ref()?;
        let side = if hit.normal.dot(eye.direction) > 0.0 { -hit.normal } else { hit.normal };
        let from = textbook::offset_origin(narrow(hit.point), narrow(side));
        Some(TestRay { origin: dvec3(from.x.into(), from.y.into(), from.z.into()), direction: light })
    };
    let lit = hit.iter().zip(eyes).map(shadow);
    let lit = lit.map(|ray| ray.is_some_and(|ray| scene.cast(&[ray])[0].is_none())).collect();
    (hit, lit)
}

/// What one of both cores sees, and whether its tracer shows it lit.
macro_rules! core {
    ($room:ident, $core:ident, $scene:path) => {
        mod $room {
            use $core::math::try_normalize;
            use $core::{Light, Limits, Rgb, Source, vec3};

            use $scene as TestScene;

            use super::{CoreHit, DVec3, TestRay, TestShape, TestedCore};

            pub fn lit(
                shapes: &[TestShape],
                eyes: &[TestRay],
                light: DVec3,
            ) -> (Vec<Option<CoreHit>>, Vec<bool>) {
                let narrow = |v: DVec3| vec3(v.x as _, v.y as _, v.z as _);
                let mut scene = TestScene::with_shapes(shapes);
                let hit = scene.cast(eyes);
                let toward = try_normalize(narrow(light)).unwrap();
                let source = Source::Directional { toward };
                scene.lights.push(Light { source, color: Rgb::WHITE, shadows: true });
                let look = |eye: &TestRay| {
                    let limits = Limits { levels: 1, cutoff: 0.0 };
                    !scene.trace(narrow(eye.origin), narrow(eye.origin + eye.direction), limits).is_black()
                };
                let lit = eyes.iter().map(look).collect();
                (hit, lit)
            }
        }
    };
}

core!(in_single, strahl_core, crate::single::TestScene);
core!(in_double, strahl_core_double, crate::double::TestScene);
