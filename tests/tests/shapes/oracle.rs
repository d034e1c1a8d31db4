//! Random shapes of all kinds, from all sides, compared with an oracle that solves no equation.

use strahl_tests::oracle::{OracleAnswer, OracleHit, PRECISION, intersect, shading, signed_distance, size};

use crate::*;

const SEED: u64 = 0x5eed_0001;

/// Things of each kind, and rays for each of them.
const SHAPES: usize = 150;
const RAYS: usize = 150;

/// How many roundoffs, times [`size`] over slope, a way may be off: 4 units in the last place,
/// whatever the formula. Half of it is what is found.
const MULTIPLE: f64 = 8.0;

/// What was checked, and the worst that was found.
#[derive(Debug, Default)]
struct Report {
    hits: usize,
    misses: usize,
    unclear: usize,
    /// Of a way, in roundoffs times size over slope.
    way: f64,
    /// Of a normal, in roundoffs, and on a curved surface as many as the point may be off.
    normal: f64,
    /// Of a point, in the errors that the core has promised.
    point: f64,
    /// Of a shading normal, in roundoffs, and as many as the point may be off.
    shading: f64,
}

/// Holds the answers of both cores against the truth.
fn hold(shape: &TestShape, rays: &[TestRay], reports: &mut [Report; 2]) {
    let truths: Vec<OracleAnswer> = rays.iter().map(|ray| intersect(shape, ray)).collect();
    for (core, report) in CORES.iter().zip(reports) {
        for ((ray, truth), hit) in rays.iter().zip(&truths).zip((core.cast)(shape, rays)) {
            let about = || format!("{}\n{shape:?}\n{ray:?}\n{truth:?}\n{hit:?}", core.name);
            assert!(hit.is_none_or(|hit| hit.is_finite()), "{}", about());
            match (truth, hit) {
                (OracleAnswer::Unclear, _) => report.unclear += 1,
                (OracleAnswer::Miss, None) => report.misses += 1,
                (OracleAnswer::Hit(contact), Some(hit)) => {
                    report.hits += 1;
                    report.check(core, shape, ray, contact, &hit, &about);
                }
                _ => panic!("hit or miss is wrong: {}", about()),
            }
        }
    }
}

/// Prints what was found; else little would have been checked when so few are hit, missed, and
/// clear.
fn conclude(name: &str, reports: &[Report; 2], hits: f64, misses: f64, unclear: f64) {
    for (core, report) in CORES.iter().zip(reports) {
        println!("{name} in {} precision: {report:?}", core.name);
        let all = (report.hits + report.misses + report.unclear) as f64;
        let share = |count: usize| count as f64 / all;
        assert!(share(report.hits) >= hits, "{report:?}");
        assert!(share(report.misses) >= misses, "{report:?}");
        assert!(share(report.unclear) <= unclear, "{report:?}");
    }
}

fn random_thing(kind: TestShapeKind, rng: &mut SplitMix64) -> TestShape {
    let size = rng.log_between(0.1, 10.0);
    let place = rng.in_ball(DVec3::ZERO, 3.0 * size);
    TestShape::random(kind, place, size, rng)
}

fn is_met_where_the_truth_is(kind: TestShapeKind) {
    let mut rng = SplitMix64::new(SEED + kind as u64);
    let mut reports = CORES.map(|_| Report::default());
    for _ in 0..SHAPES {
        let shape = random_thing(kind, &mut rng);
        let rays: Vec<TestRay> = (0..RAYS).map(|_| random_ray(&shape, &mut rng)).collect();
        hold(&shape, &rays, &mut reports);
    }
    conclude(&format!("{kind:?}"), &reports, 0.25, 0.05, 0.01);
}

/// Rays ever closer to a silhouette, a rim or an edge, from both sides: between a point where
/// the thing is met and one beside it the border is found by halving.
fn rays_at_the_border(shape: &TestShape, rng: &mut SplitMix64) -> Vec<TestRay> {
    let (center, radius) = shape.bounding_sphere();
    let away = radius * rng.log_between(2.0, 20.0);
    let eye = rng.in_ball(center, away);
    let (mut on, mut beside) = (target(shape, rng), rng.in_ball(center, 2.0 * radius));
    let is_met = |point: DVec3| {
        !matches!(intersect(shape, &TestRay { origin: eye, direction: point - eye }), OracleAnswer::Miss)
    };
    if !is_met(on) || is_met(beside) {
        return Vec::new();
    }
    let across = beside - on;
    for _ in 0..22 {
        let middle = (on + beside) * 0.5;
        if is_met(middle) { on = middle } else { beside = middle }
    }
    (0..18)
        .flat_map(|k| {
            let step = across / f64::from(16 << k);
            [towards(eye, on - step, 1.0), towards(eye, beside + step, 1.0)]
        })
        .collect()
}

fn ends_where_the_truth_does(kind: TestShapeKind) {
    let mut rng = SplitMix64::new(SEED + 50 + kind as u64);
    let mut reports = CORES.map(|_| Report::default());
    for _ in 0..SHAPES {
        let shape = random_thing(kind, &mut rng);
        let rays = rays_at_the_border(&shape, &mut rng);
        hold(&shape, &rays, &mut reports);
    }
    if kind != TestShapeKind::Plane {
        conclude(&format!("the border of {kind:?}"), &reports, 0.2, 0.2, 0.4);
    }
}

#[test]
fn a_torus_of_any_proportions_is_met_where_the_oracle_says() {
    let mut rng = SplitMix64::new(SEED + 101);
    let mut reports = CORES.map(|_| Report::default());
    for _ in 0..SHAPES {
        let major = rng.log_between(0.1, 10.0);
        let minor = rounded(major * rng.log_between(1e-3, 1.0));
        let (center, axis) = (rng.in_ball(DVec3::ZERO, 3.0), rng.direction());
        let torus = TestShape::Torus { center, axis, major, minor };
        // At the tube, from up to a hundred sizes away.
        let aim = |rng: &mut SplitMix64| {
            let middle = rng.direction();
            let middle = middle - axis * (middle.dot(axis) / axis.dot(axis));
            let target = rng.in_ball(center + middle * (major / length(middle)), 1.2 * minor);
            let away = major * rng.log_between(0.5, 100.0);
            towards(rng.in_ball(center, away), target, 1.0)
        };
        let rays: Vec<TestRay> = (0..RAYS).map(|_| aim(&mut rng)).collect();
        hold(&torus, &rays, &mut reports);
    }
    conclude("a torus of any proportions", &reports, 0.5, 0.02, 0.1);
}

impl Report {
    fn check(
        &mut self,
        core: &Caster,
        shape: &TestShape,
        ray: &TestRay,
        truth: &OracleHit,
        hit: &CoreHit,
        about: &dyn Fn() -> String,
    ) {
        // The oracle itself is only so good, and its normals are differences.
        let (u, fine) = (core.roundoff.max(PRECISION), core.roundoff.max(1e-10));
        let size = size(shape, ray);
        let conditioning = size / truth.slope;
        let hold = |worst: &mut f64, off: f64, unit: f64, bound: f64| {
            *worst = worst.max(off / unit);
            assert!(off <= bound * unit, "{} off: {}", off / unit, about());
        };

        // How far, in scene lengths.
        let way = hit.t * length(ray.direction) - truth.distance;
        hold(&mut self.way, way.abs(), u * conditioning, MULTIPLE);

        // The normal: of length one, and as promised whichever side is met.
        for normal in [hit.normal, hit.shading] {
            assert!((normal.dot(normal) - 1.0).abs() <= 1e-6, "{}", about());
        }
        let bent = 1.0 + conditioning / truth.curvature;
        hold(&mut self.normal, length(hit.normal - truth.normal), fine * bent, MULTIPLE);

        // The point: on the surface as well as it says, which is no empty promise, and where the way says.
        let promised = hit.normal.abs().dot(hit.error) + PRECISION * size;
        hold(&mut self.point, signed_distance(shape, hit.point).abs(), promised, 1.0);
        let coarse = 64.0 * core.roundoff * (length(hit.point) + size);
        assert!(hit.error.max_element() <= coarse, "{}", about());
        let moved = length(hit.point - truth.point);
        assert!(moved <= 2.0 * MULTIPLE * u * (conditioning + length(hit.point)), "{}", about());

        // The normal that shades.
        match shading(shape, truth.point) {
            None => assert_eq!(hit.shading, hit.normal),
            Some((shading, vertex)) => {
                let bent = 1.0 + conditioning / vertex;
                // At an edge the shares of a polygon's corners are quotients of small numbers.
                hold(&mut self.shading, length(hit.shading - shading), u * bent, 8.0 * MULTIPLE);
            }
        }
    }
}

mod inside {
    use super::*;
    for_every_kind!(is_met_where_the_truth_is, is_met_where_the_oracle_says);
}

mod at_the_border {
    use super::*;
    for_every_kind!(ends_where_the_truth_does, ends_where_the_oracle_says);
}

#[test]
fn both_cores_find_the_same_within_single_precision() {
    let mut rng = SplitMix64::new(SEED + 100);
    let mut hits = 0;
    for kind in TestShapeKind::ALL {
        for _ in 0..22 {
            let shape = TestShape::random(kind, DVec3::ZERO, 1.0, &mut rng);
            let rays: Vec<TestRay> = (0..100).map(|_| random_ray(&shape, &mut rng)).collect();
            let answers = (SINGLE.cast)(&shape, &rays).into_iter().zip((DOUBLE.cast)(&shape, &rays));
            for (ray, (single, double)) in rays.iter().zip(answers) {
                let (truth, about) =
                    (intersect(&shape, ray), || format!("{shape:?}\n{ray:?}\n{single:?}\n{double:?}"));
                let OracleAnswer::Hit(OracleHit { slope, .. }) = truth else {
                    assert!(
                        single.is_none() && double.is_none() || matches!(truth, OracleAnswer::Unclear),
                        "{}",
                        about()
                    );
                    continue;
                };
                let (Some(single), Some(double)) = (single, double) else { panic!("{}", about()) };
                let bound = MULTIPLE * SINGLE.roundoff * size(&shape, ray) / slope;
                assert!((single.t - double.t).abs() * length(ray.direction) <= bound, "{}", about());
                hits += 1;
            }
        }
    }
    assert!(hits > 15_000, "{hits}");
}
