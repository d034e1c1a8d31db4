//! The shadow terminator on coarse smooth spheres: a point whose shading normal faces the light must not be
//! in the shadow of its own mesh, and must be in the shadow of other objects.

use super::case::{HardCase, HardCaseTally, Solver, as_f32, length, perpendicular, towards};
use super::mesh::ClosedMesh;
use crate::textbook;
use strahl_test_scene as single;
use strahl_test_scene::{CoreHit, DVec3, SplitMix64, TestRay, TestShape, TestedCore, dvec3};

const fn case(
    name: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own("shadow terminator", name, naive, 0.0, check)
}

pub(super) const CASES: [HardCase; 2] = [
    case("smooth spheres of 20 to 320 triangles", "whole triangles are in their own shadow", |rng| {
        evaluated(false, rng)
    })
    .seed(0x4c13_257e_a390_ebc2),
    case("the same with a plate in front of the light", "a plate that is skipped casts no shadow", |rng| {
        evaluated(true, rng)
    })
    .easy()
    .seed(0x3f50_b36b_b23e_7cc8),
];

/// A smooth sphere of triangles, with or without a plate in front of the light.
fn smooth_sphere(level: u32, center: DVec3, radius: f64, plate: Option<DVec3>) -> Vec<TestShape> {
    let mesh = ClosedMesh::icosphere(level, center, radius);
    let vertices = |triangle: &[u32; 3]| triangle.map(|vertex| mesh.points[vertex as usize]);
    let smooth = |vertices: [DVec3; 3]| TestShape::SmoothTriangle {
        vertices,
        normals: vertices.map(|vertex| as_f32((vertex - center) / length(vertex - center))),
    };
    let mut shapes: Vec<TestShape> = mesh.triangles.iter().map(vertices).map(smooth).collect();
    if let Some(light) = plate {
        shapes.push(TestShape::Disc {
            center: as_f32(center + light * (1.6 * radius)),
            normal: light,
            radius: 3.0 * radius,
        });
    }
    shapes
}

/// Rays at a sphere from the side, so that they hit its terminator and not the plate.
fn camera_rays(center: DVec3, radius: f64, light: DVec3, rng: &mut SplitMix64) -> Vec<TestRay> {
    let ray = |_| {
        let side = perpendicular(light, rng) - light * rng.between(-0.4, 0.6);
        let viewpoint = as_f32(center + side * (radius * rng.between(2.0, 9.0)));
        towards(viewpoint, rng.in_ball(center, radius))
    };
    (0..110).map(ray).collect()
}

fn evaluated(with_plate: bool, rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for round in 0..24 {
        let radius = rng.log_between(1e-3, 1e3);
        let center = rng.in_ball(DVec3::ZERO, 10.0 * radius);
        let light = rng.direction();
        let shapes = smooth_sphere(round % 3, center, radius, with_plate.then_some(light));
        let camera_rays = camera_rays(center, radius, light, rng);
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let (shown, lit) = match solver {
                Solver::Textbook => in_textbook(&shapes, &camera_rays, light),
                Solver::Single => in_single::lit(&shapes, &camera_rays, light),
                Solver::Double => in_double::lit(&shapes, &camera_rays, light),
            };
            for ((hit, viewpoint), lit) in shown.iter().zip(&camera_rays).zip(lit) {
                let is_plate = |item: u32| matches!(shapes[item as usize], TestShape::Disc { .. });
                let Some(hit) = hit.filter(|hit| !is_plate(hit.item)) else { continue };
                let facing = |n: DVec3| if hit.normal.dot(viewpoint.direction) > 0.0 { -n } else { n };
                // At grazing light rounding decides.
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

/// The core's hits, lit if nothing occludes a shadow ray from slightly above the surface.
fn in_textbook(
    shapes: &[TestShape],
    camera_rays: &[TestRay],
    light: DVec3,
) -> (Vec<Option<CoreHit>>, Vec<bool>) {
    let scene = single::TestScene::with_shapes(shapes);
    let hit = scene.cast(camera_rays);
    let narrow = |v: DVec3| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
    let shadow = |(hit, viewpoint): (&Option<CoreHit>, &TestRay)| {
        let hit = hit.as_ref()?;
        let side = if hit.normal.dot(viewpoint.direction) > 0.0 { -hit.normal } else { hit.normal };
        let from = textbook::offset_origin(narrow(hit.point), narrow(side));
        Some(TestRay { origin: dvec3(from.x.into(), from.y.into(), from.z.into()), direction: light })
    };
    let lit = hit.iter().zip(camera_rays).map(shadow);
    let lit = lit.map(|ray| ray.is_some_and(|ray| scene.cast(&[ray])[0].is_none())).collect();
    (hit, lit)
}

/// The hits of one core, and whether its tracer shows them lit.
macro_rules! core {
    ($module:ident, $core:ident, $scene:path) => {
        mod $module {
            use $core::math::try_normalize;
            use $core::{Light, LightSource, Limits, Rgb, vec3};

            use $scene as TestScene;

            use super::{CoreHit, DVec3, TestRay, TestShape, TestedCore};

            pub fn lit(
                shapes: &[TestShape],
                camera_rays: &[TestRay],
                light: DVec3,
            ) -> (Vec<Option<CoreHit>>, Vec<bool>) {
                let narrow = |v: DVec3| vec3(v.x as _, v.y as _, v.z as _);
                let mut scene = TestScene::with_shapes(shapes);
                let hit = scene.cast(camera_rays);
                let toward = try_normalize(narrow(light)).unwrap();
                let source = LightSource::Directional { to_light: toward };
                scene.lights.push(Light { source, color: Rgb::WHITE, casts_shadows: true });
                let is_lit = |viewpoint: &TestRay| {
                    let limits = Limits { levels: 1, cutoff: 0.0 };
                    !scene
                        .trace(
                            narrow(viewpoint.origin),
                            narrow(viewpoint.origin + viewpoint.direction),
                            limits,
                        )
                        .is_black()
                };
                let lit = camera_rays.iter().map(is_lit).collect();
                (hit, lit)
            }
        }
    };
}

core!(in_single, strahl_core, strahl_test_scene::TestScene);
core!(in_double, strahl_core_double, strahl_test_scene_double::TestScene);
