//! Random shapes of all kinds, from all sides, compared with an oracle that solves no equation.

use strahl_tests::oracle::{OracleAnswer, OracleHit, PRECISION, intersect, shading, signed_distance, size};

use crate::*;

const SEED: u64 = 0x5eed_0001;

/// Shapes of each kind, and rays at each of them.
const SHAPES: usize = 150;
const RAYS: usize = 150;

/// Error bound of a distance, in roundoffs times [`size`] over slope: 4 units in the last place for every
/// formula. Half of it is measured.
const MULTIPLE: f64 = 8.0;

/// Numbers of rays, and the largest errors.
#[derive(Debug, Default)]
struct OracleReport {
    hits: usize,
    misses: usize,
    unclear: usize,
    /// Error of a distance, in roundoffs times size over slope.
    distance: f64,
    /// Error of a normal, in roundoffs, which on a curved surface include the error of the point.
    normal: f64,
    /// Distance of a point from the surface, in the error bound that the core returns.
    point: f64,
    /// Error of a shading normal, in roundoffs, which include the error of the point.
    shading: f64,
}

/// Compares the answers of both cores with the oracle.
fn check(shape: &TestShape, rays: &[TestRay], reports: &mut [OracleReport; 2]) {
    let answers: Vec<OracleAnswer> = rays.iter().map(|ray| intersect(shape, ray)).collect();
    for (core, report) in CORES.iter().zip(reports) {
        for ((ray, expected), hit) in rays.iter().zip(&answers).zip((core.cast)(shape, rays)) {
            let context = || format!("{}\n{shape:?}\n{ray:?}\n{expected:?}\n{hit:?}", core.name);
            assert!(hit.is_none_or(|hit| hit.is_finite()), "{}", context());
            match (expected, hit) {
                (OracleAnswer::Unclear, _) => report.unclear += 1,
                (OracleAnswer::Miss, None) => report.misses += 1,
                (OracleAnswer::Hit(contact), Some(hit)) => {
                    report.hits += 1;
                    report.check(core, shape, ray, contact, &hit, &context);
                }
                _ => panic!("hit or miss is wrong: {}", context()),
            }
        }
    }
}

/// Prints the reports and asserts the fractions of hits, misses and unclear rays, so that enough is checked.
fn conclude(name: &str, reports: &[OracleReport; 2], hits: f64, misses: f64, unclear: f64) {
    for (core, report) in CORES.iter().zip(reports) {
        println!("{name} in {} precision: {report:?}", core.name);
        let all = (report.hits + report.misses + report.unclear) as f64;
        let fraction = |count: usize| count as f64 / all;
        assert!(fraction(report.hits) >= hits, "{report:?}");
        assert!(fraction(report.misses) >= misses, "{report:?}");
        assert!(fraction(report.unclear) <= unclear, "{report:?}");
    }
}

fn random_shape(kind: TestShapeKind, rng: &mut SplitMix64) -> TestShape {
    let size = rng.log_between(0.1, 10.0);
    let center = rng.in_ball(DVec3::ZERO, 3.0 * size);
    TestShape::random(kind, center, size, rng)
}

fn agrees_inside(kind: TestShapeKind) {
    let mut rng = SplitMix64::new(SEED + kind as u64);
    let mut reports = CORES.map(|_| OracleReport::default());
    for _ in 0..SHAPES {
        let shape = random_shape(kind, &mut rng);
        let rays: Vec<TestRay> = (0..RAYS).map(|_| random_ray(&shape, &mut rng)).collect();
        check(&shape, &rays, &mut reports);
    }
    conclude(&format!("{kind:?}"), &reports, 0.25, 0.05, 0.01);
}

/// Rays that approach a silhouette or an edge from both sides. The border is found by bisection between a
/// point of the shape and one beside it.
fn rays_at_the_border(shape: &TestShape, rng: &mut SplitMix64) -> Vec<TestRay> {
    let (center, radius) = shape.bounding_sphere();
    let away = radius * rng.log_between(2.0, 20.0);
    let viewpoint = rng.in_ball(center, away);
    let (mut on, mut beside) = (target(shape, rng), rng.in_ball(center, 2.0 * radius));
    let is_hit = |point: DVec3| {
        !matches!(
            intersect(shape, &TestRay { origin: viewpoint, direction: point - viewpoint }),
            OracleAnswer::Miss
        )
    };
    if !is_hit(on) || is_hit(beside) {
        return Vec::new();
    }
    let across = beside - on;
    for _ in 0..22 {
        let center = (on + beside) * 0.5;
        if is_hit(center) { on = center } else { beside = center }
    }
    (0..18)
        .flat_map(|k| {
            let step = across / f64::from(16 << k);
            [towards(viewpoint, on - step, 1.0), towards(viewpoint, beside + step, 1.0)]
        })
        .collect()
}

fn agrees_at_the_border(kind: TestShapeKind) {
    let mut rng = SplitMix64::new(SEED + 50 + kind as u64);
    let mut reports = CORES.map(|_| OracleReport::default());
    for _ in 0..SHAPES {
        let shape = random_shape(kind, &mut rng);
        let rays = rays_at_the_border(&shape, &mut rng);
        check(&shape, &rays, &mut reports);
    }
    if kind != TestShapeKind::Plane {
        conclude(&format!("the border of {kind:?}"), &reports, 0.2, 0.2, 0.4);
    }
}

#[test]
fn a_torus_of_any_proportions_is_hit_where_the_oracle_hits_it() {
    let mut rng = SplitMix64::new(SEED + 101);
    let mut reports = CORES.map(|_| OracleReport::default());
    for _ in 0..SHAPES {
        let major = rng.log_between(0.1, 10.0);
        let minor = rounded(major * rng.log_between(1e-3, 1.0));
        let (center, axis) = (rng.in_ball(DVec3::ZERO, 3.0), rng.direction());
        let torus = TestShape::Torus { center, axis, major, minor };
        // At the tube, from up to a hundred sizes away.
        let aim = |rng: &mut SplitMix64| {
            let radial = rng.direction();
            let radial = radial - axis * (radial.dot(axis) / axis.dot(axis));
            let target = rng.in_ball(center + radial * (major / length(radial)), 1.2 * minor);
            let away = major * rng.log_between(0.5, 100.0);
            towards(rng.in_ball(center, away), target, 1.0)
        };
        let rays: Vec<TestRay> = (0..RAYS).map(|_| aim(&mut rng)).collect();
        check(&torus, &rays, &mut reports);
    }
    conclude("a torus of any proportions", &reports, 0.5, 0.02, 0.1);
}

impl OracleReport {
    fn check(
        &mut self,
        core: &ShapeCaster,
        shape: &TestShape,
        ray: &TestRay,
        expected: &OracleHit,
        hit: &CoreHit,
        context: &dyn Fn() -> String,
    ) {
        // The oracle has errors as well, and its normals are differences.
        let (u, fine) = (core.roundoff.max(PRECISION), core.roundoff.max(1e-10));
        let size = size(shape, ray);
        let conditioning = size / expected.slope;
        let assert_bound = |worst: &mut f64, off: f64, unit: f64, bound: f64| {
            *worst = worst.max(off / unit);
            assert!(off <= bound * unit, "error of {} units: {}", off / unit, context());
        };

        // The distance, in scene lengths.
        let error = hit.t * length(ray.direction) - expected.distance;
        assert_bound(&mut self.distance, error.abs(), u * conditioning, MULTIPLE);

        // The normals: of unit length, and with the documented orientation on either side.
        for normal in [hit.normal, hit.shading] {
            assert!((normal.dot(normal) - 1.0).abs() <= 1e-6, "{}", context());
        }
        let bent = 1.0 + conditioning / expected.curvature;
        assert_bound(&mut self.normal, length(hit.normal - expected.normal), fine * bent, MULTIPLE);

        // The point: on the surface within its error bound, which must be small, and at the hit distance.
        let bound = hit.normal.abs().dot(hit.error) + PRECISION * size;
        assert_bound(&mut self.point, signed_distance(shape, hit.point).abs(), bound, 1.0);
        let coarse = 64.0 * core.roundoff * (length(hit.point) + size);
        assert!(hit.error.max_element() <= coarse, "{}", context());
        let moved = length(hit.point - expected.point);
        assert!(moved <= 2.0 * MULTIPLE * u * (conditioning + length(hit.point)), "{}", context());

        // The shading normal.
        match shading(shape, expected.point) {
            None => assert_eq!(hit.shading, hit.normal),
            Some((shading, vertex)) => {
                let bent = 1.0 + conditioning / vertex;
                // At an edge the weights of a polygon's vertices are quotients of small numbers.
                assert_bound(&mut self.shading, length(hit.shading - shading), u * bent, 8.0 * MULTIPLE);
            }
        }
    }
}

mod inside {
    use super::*;
    for_every_kind!(agrees_inside, is_hit_where_the_oracle_hits_it);
}

mod at_the_border {
    use super::*;
    for_every_kind!(agrees_at_the_border, ends_where_the_oracle_ends_it);
}

#[test]
fn both_cores_agree_within_single_precision() {
    let mut rng = SplitMix64::new(SEED + 100);
    let mut hits = 0;
    for kind in TestShapeKind::ALL {
        for _ in 0..22 {
            let shape = TestShape::random(kind, DVec3::ZERO, 1.0, &mut rng);
            let rays: Vec<TestRay> = (0..100).map(|_| random_ray(&shape, &mut rng)).collect();
            let answers = (SINGLE.cast)(&shape, &rays).into_iter().zip((DOUBLE.cast)(&shape, &rays));
            for (ray, (single, double)) in rays.iter().zip(answers) {
                let (expected, context) =
                    (intersect(&shape, ray), || format!("{shape:?}\n{ray:?}\n{single:?}\n{double:?}"));
                let OracleAnswer::Hit(OracleHit { slope, .. }) = expected else {
                    assert!(
                        single.is_none() && double.is_none() || matches!(expected, OracleAnswer::Unclear),
                        "{}",
                        context()
                    );
                    continue;
                };
                let (Some(single), Some(double)) = (single, double) else { panic!("{}", context()) };
                let bound = MULTIPLE * SINGLE.roundoff * size(&shape, ray) / slope;
                assert!((single.t - double.t).abs() * length(ray.direction) <= bound, "{}", context());
                hits += 1;
            }
        }
    }
    assert!(hits > 15_000, "{hits}");
}
