//! Scaled shapes, invalid rays, and the end of a ray.

use super::case::{HardCase, HardCaseTally, Solver, SolverHit, answers, towards};
use crate::textbook::TextbookShape;
use strahl_test_scene::{DVec3, SplitMix64, TestRay, TestShape, TestShapeKind, dvec3};

pub(super) const CASES: [HardCase; 3] = [
    HardCase::own("scale", "every kind, times 2^-30 to 2^30", "thresholds and fourth powers", 0.0, scaled),
    HardCase::own("bad rays", "NaN, infinite, without direction", "NaN passes every comparison", 0.0, none),
    HardCase::own(
        "end of a ray",
        "just before a hit, at it, behind it",
        "`t < t_max` excludes the end",
        0.0,
        ends,
    ),
];

const SHAPES: usize = 8;
const RAYS: usize = 40;

/// Shapes of every kind and rays at them.
fn scenes(rng: &mut SplitMix64) -> Vec<(TestShape, Vec<TestRay>)> {
    let scene = |kind: &TestShapeKind| {
        let center = rng.in_ball(DVec3::ZERO, 5.0);
        let shape = TestShape::random(*kind, center, rng.log_between(0.1, 3.0), rng);
        let ray = |rng: &mut SplitMix64| towards(rng.in_ball(center, 12.0), rng.in_ball(center, 2.0));
        (shape, (0..RAYS).map(|_| ray(rng)).collect())
    };
    TestShapeKind::ALL.iter().cycle().take(SHAPES * TestShapeKind::ALL.len()).map(scene).collect()
}

/// The distance scales with the scene, and the normal does not change, bit for bit.
fn scaled(rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for (shape, rays) in scenes(rng) {
        let exponent = rng.below(61) as i32 - 30;
        let scale = libm::scalbn(1.0, exponent);
        let other = shape.mapped(|p| p * scale, |d| d, scale);
        let other_rays: Vec<TestRay> =
            rays.iter().map(|ray| TestRay { origin: ray.origin * scale, ..*ray }).collect();
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let expected = answers(solver, &shape, &rays);
            for (expected, answer) in expected.into_iter().zip(answers(solver, &other, &other_rays)) {
                let scaled_answer = expected.map(|expected| (expected.t * scale, expected.normal));
                tally.rays += 1;
                tally.faults +=
                    usize::from(answer.map(|SolverHit { t, normal }| (t, normal)) != scaled_answer);
            }
        }
    }
    tallies
}

/// An invalid ray hits nothing.
fn none(rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for (shape, mut rays) in scenes(rng) {
        for ray in &mut rays {
            let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][rng.below(3) as usize];
            let axis = rng.below(3) as usize;
            match rng.below(3) {
                0 => ray.origin[axis] = bad,
                1 => ray.direction[axis] = bad,
                _ => ray.direction = dvec3(0.0, -0.0, 0.0),
            }
        }
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            tally.rays += rays.len();
            tally.faults += answers(solver, &shape, &rays).iter().flatten().count();
        }
    }
    tallies
}

/// A ray that ends at the hit or behind it hits; a ray that ends before it does not.
fn ends(rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for (shape, rays) in scenes(rng) {
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let answers = match solver {
                Solver::Textbook => in_textbook(&shape, &rays),
                Solver::Single => in_single::ends(&shape, &rays),
                Solver::Double => in_double::ends(&shape, &rays),
            };
            tally.rays += 3 * answers.len();
            tally.faults += answers.iter().flatten().filter(|is_right| !**is_right).count();
        }
    }
    tallies
}

/// For each ray that hits the shape, whether the answers are correct if it ends just before the hit, at it
/// and behind it.
fn in_textbook(shape: &TestShape, rays: &[TestRay]) -> Vec<[bool; 3]> {
    let textbook = TextbookShape::of(shape);
    let ends = |ray: &TestRay| {
        let t = textbook.intersect(ray)?.t;
        let is_hit = |t_max: f32| textbook.intersect(ray).is_some_and(|hit| hit.t < t_max);
        Some([!is_hit(t.next_down()), is_hit(t), is_hit(t.next_up())])
    };
    rays.iter().filter_map(ends).collect()
}

macro_rules! core {
    ($module:ident, $core:ident, $scene:path) => {
        mod $module {
            use $core::accel::List;
            use $core::geometry::Ray;
            use $core::tally::RayKind;
            use $core::{AllEffects, Real, World, vec3};

            use $scene as TestScene;

            use super::{TestRay, TestShape};
            use strahl_test_scene::TestedCore;

            pub fn ends(shape: &TestShape, rays: &[TestRay]) -> Vec<[bool; 3]> {
                let scene = TestScene::with_shapes(std::slice::from_ref(shape));
                let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
                let ends = |ray: &TestRay| {
                    let (o, d) = (ray.origin, ray.direction);
                    let core_ray =
                        Ray::new(vec3(o.x as _, o.y as _, o.z as _), vec3(d.x as _, d.y as _, d.z as _));
                    let nearest = |t_max: Real| {
                        world.nearest_hit::<AllEffects, _>(
                            &core_ray,
                            t_max,
                            RayKind::Camera,
                            &mut (),
                            &mut (),
                        )
                    };
                    let is_hit = |t_max: Real| {
                        let occluder = world.occluder::<AllEffects, _>(
                            &core_ray,
                            t_max,
                            RayKind::Shadow,
                            &mut (),
                            &mut (),
                        );
                        assert_eq!(nearest(t_max).is_some(), occluder.is_some());
                        occluder.is_some()
                    };
                    let t = nearest(Real::INFINITY)?.t;
                    Some([!is_hit(t.next_down()), is_hit(t), is_hit(t.next_up())])
                };
                rays.iter().filter_map(ends).collect()
            }
        }
    };
}

core!(in_single, strahl_core, strahl_test_scene::TestScene);
core!(in_double, strahl_core_double, strahl_test_scene_double::TestScene);
