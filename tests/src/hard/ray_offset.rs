//! Rays that start on a surface: they must not hit it again.

use super::case::{HardCase, HardCaseTally, Solver, ULP, answers, as_f32, length, towards};
use crate::oracle::signed_distance;
use crate::textbook::{self, TextbookShape};
use strahl_test_scene as single;
use strahl_test_scene::{CoreHit, DVec3, SplitMix64, TestRay, TestShape, TestShapeKind, TestedCore, dvec3};
use strahl_test_scene_double as double;

const fn case(
    name: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own("leaving", name, naive, BOUND, check)
}

/// Largest correct distance of an offset origin from its surface, in units in the last place of coordinates
/// and size.
const BOUND: f64 = 64.0;

const FIXED: &str = "an offset of 1e-4 is too small far away, too large for small things";

pub(super) const CASES: [HardCase; 15] = [
    case("a sphere", FIXED, |rng| self_intersections(TestShapeKind::Sphere, rng)),
    case("an open cylinder", FIXED, |rng| self_intersections(TestShapeKind::OpenCylinder, rng)),
    case("a capped cylinder", FIXED, |rng| self_intersections(TestShapeKind::CappedCylinder, rng)),
    case("an open cone", FIXED, |rng| self_intersections(TestShapeKind::OpenCone, rng)),
    case("a capped cone", FIXED, |rng| self_intersections(TestShapeKind::CappedCone, rng)),
    case("a torus", FIXED, |rng| self_intersections(TestShapeKind::Torus, rng)),
    case("a box", FIXED, |rng| self_intersections(TestShapeKind::Cuboid, rng)),
    case("an oriented box", FIXED, |rng| self_intersections(TestShapeKind::OrientedCuboid, rng))
        .seed(0xc239_408c_e7b7_b489),
    case("a plane", FIXED, |rng| self_intersections(TestShapeKind::Plane, rng)),
    case("a disc", FIXED, |rng| self_intersections(TestShapeKind::Disc, rng)),
    case("a triangle", FIXED, |rng| self_intersections(TestShapeKind::Triangle, rng)),
    case("a smooth triangle", FIXED, |rng| self_intersections(TestShapeKind::SmoothTriangle, rng)),
    case("a polygon", FIXED, |rng| self_intersections(TestShapeKind::Polygon, rng)),
    case("a smooth polygon", FIXED, |rng| self_intersections(TestShapeKind::SmoothPolygon, rng)),
    case("between two plates, 1e-3 of their size apart", "the offset skips the other plate", plates),
];

/// A direction on the side of `normal`; every other one is grazing.
fn outward(normal: DVec3, rng: &mut SplitMix64) -> DVec3 {
    let direction = rng.direction();
    let height = direction.dot(normal);
    let target_height = if rng.below(2) == 0 { height.abs() } else { rng.log_between(2e-4, 1e-1) };
    as_f32(direction + normal * (target_height.max(2e-4) - height))
}

const SHAPES: usize = 40;

/// A shape, rays that hit it, and for each of them the seeds of directions of further rays.
struct OffsetCase {
    shape: TestShape,
    radius: f64,
    camera_rays: Vec<TestRay>,
    seeds: Vec<Vec<u64>>,
}

fn offset_case(kind: TestShapeKind, rng: &mut SplitMix64) -> OffsetCase {
    const HITS: usize = 25;
    const RAYS: usize = 10;
    let size = rng.log_between(1e-4, 1e4);
    let away = if rng.below(3) == 0 { 0.0 } else { size * rng.log_between(1.0, 1e4) };
    let shape = TestShape::random(kind, rng.direction() * away, size, rng);
    let (center, radius) = shape.bounding_sphere();
    let radius = if kind == TestShapeKind::Plane { size } else { radius };
    let camera_rays = (0..HITS)
        .map(|_| {
            let viewpoint = as_f32(center + rng.direction() * (radius * rng.log_between(1.2, 10.0)));
            towards(viewpoint, rng.in_ball(center, radius))
        })
        .collect();
    let seeds = (0..HITS).map(|_| (0..RAYS).map(|_| rng.bits()).collect()).collect();
    OffsetCase { shape, radius, camera_rays, seeds }
}

/// Rays from hits of shapes 1e-4 to 1e4 in size, up to 1e4 sizes from the origin, on the side of the incoming
/// ray. None may hit the shape again near its origin, and none may start farther from the surface than
/// rounding requires.
fn self_intersections(kind: TestShapeKind, rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for _ in 0..SHAPES {
        let OffsetCase { shape, radius, camera_rays, seeds } = offset_case(kind, rng);
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let starts = starts(solver, &shape, &camera_rays);
            let distances = |rays: &[TestRay]| distances(solver, &shape, rays);
            count_faults(&shape, radius, &starts, &seeds, distances, tally);
        }
    }
    tallies
}

/// Counts the faults of rays from `starts`, each a point with its normal, in the directions of `seeds`.
fn count_faults(
    shape: &TestShape,
    radius: f64,
    starts: &[Option<(DVec3, DVec3)>],
    seeds: &[Vec<u64>],
    distances: impl Fn(&[TestRay]) -> Vec<Option<f64>>,
    tally: &mut HardCaseTally,
) {
    for (from, seeds) in starts.iter().zip(seeds) {
        let Some((origin, normal)) = *from else { continue };
        let ray = |seed: &u64| TestRay { origin, direction: outward(normal, &mut SplitMix64::new(*seed)) };
        let rays: Vec<TestRay> = seeds.iter().map(ray).collect();
        let step = signed_distance(shape, origin).abs() / (ULP * (length(origin) + 2.0 * radius));
        tally.worst = tally.worst.max(step);
        for (ray, distances) in rays.iter().zip(distances(&rays)) {
            let is_right = distances.is_none_or(|t| t >= min_distance(shape, origin, ray.direction, normal));
            tally.rays += 1;
            tally.faults += usize::from(!is_right || step > BOUND);
        }
    }
}

/// Smallest correct distance of a second hit, of a ray that leaves the shape at `p` with `normal` in
/// `direction`.
///
/// Infinite for flat and convex shapes. A hollow with the radius of curvature `r` is hit again at `2 r` times
/// the cosine to the normal, or later; half of that is accepted.
fn min_distance(shape: &TestShape, p: DVec3, direction: DVec3, normal: DVec3) -> f64 {
    let hollow = |radius: f64| radius * direction.dot(normal) / direction.dot(direction);
    match shape {
        TestShape::Cone { base, end, capped: false, .. } => {
            let (q, axis) = (p - *base, (*end - *base) / length(*end - *base));
            let out = q - axis * q.dot(axis);
            if out.dot(normal) > 0.0 { f64::INFINITY } else { hollow(length(out)) }
        }
        TestShape::Torus { center, axis, major, minor } => {
            let (q, axis) = (p - *center, *axis / length(*axis));
            let out = length(q - axis * q.dot(axis));
            // The outer half of the tube is convex.
            if out > *major { f64::INFINITY } else { hollow(major - minor) }
        }
        _ => f64::INFINITY,
    }
}

/// Offset origins at the hits of `rays`, on the side of each ray, and the normals on that side.
fn starts(solver: Solver, shape: &TestShape, rays: &[TestRay]) -> Vec<Option<(DVec3, DVec3)>> {
    let shapes = std::slice::from_ref(shape);
    let facing = |n: DVec3, ray: &TestRay| if n.dot(ray.direction) > 0.0 { -n } else { n };
    match solver {
        Solver::Textbook => {
            let textbook = TextbookShape::of(shape);
            let start = |ray: &TestRay| {
                let hit = textbook.intersect(ray)?;
                let narrow = |v: DVec3| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
                let wide = |v: strahl_core::Vec3| dvec3(v.x.into(), v.y.into(), v.z.into());
                let normal = facing(wide(hit.normal), ray);
                let point = narrow(ray.origin) + narrow(ray.direction) * hit.t;
                Some((wide(textbook::offset_origin(point, narrow(normal))), normal))
            };
            rays.iter().map(start).collect()
        }
        Solver::Single => core_starts::<single::TestScene>(shapes, rays),
        Solver::Double => core_starts::<double::TestScene>(shapes, rays),
    }
}

fn core_starts<C: TestedCore>(shapes: &[TestShape], rays: &[TestRay]) -> Vec<Option<(DVec3, DVec3)>> {
    let start = |(hit, ray): (Option<CoreHit>, &TestRay)| {
        let hit = hit?;
        let normal = if hit.normal.dot(ray.direction) > 0.0 { -hit.normal } else { hit.normal };
        Some((C::offset_origin(&hit, normal), normal))
    };
    C::with_shapes(shapes).cast(rays).into_iter().zip(rays).map(start).collect()
}

/// Distances of the nearest hits.
fn distances(solver: Solver, shape: &TestShape, rays: &[TestRay]) -> Vec<Option<f64>> {
    answers(solver, shape, rays).into_iter().map(|answer| answer.map(|answer| answer.t)).collect()
}

/// Rays from the lower of two plates through the gap: each must hit the upper one, at every scale.
fn plates(rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for _ in 0..200 {
        let size = rng.log_between(1e-6, 1e6);
        let gap = 1e-3 * size;
        let center = rng.in_ball(DVec3::ZERO, 3.0 * size);
        let plate = |z: f64| TestShape::Cuboid {
            min: as_f32(center + dvec3(-size, -size, z)),
            max: as_f32(center + dvec3(size, size, z + gap)),
        };
        let (lower, upper) = (plate(-gap), plate(gap));
        let viewpoint = as_f32(center + dvec3(1.5 * size, 0.0, 0.5 * gap));
        let camera_rays: Vec<TestRay> = (0..10)
            .map(|_| {
                towards(viewpoint, center + dvec3(rng.between(-0.5, 0.5), rng.between(-0.5, 0.5), 0.0) * size)
            })
            .collect();
        let seeds: Vec<u64> = (0..10).map(|_| rng.bits()).collect();
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            for from in starts(solver, &lower, &camera_rays) {
                let Some((origin, _)) = from else { continue };
                let ray = |seed: &u64| {
                    let mut rng = SplitMix64::new(*seed);
                    let side = dvec3(rng.between(-0.1, 0.1), rng.between(-0.1, 0.1), 1.0);
                    TestRay { origin, direction: as_f32(side) }
                };
                let rays: Vec<TestRay> = seeds.iter().map(ray).collect();
                tally.rays += rays.len();
                let step = signed_distance(&lower, origin).abs() / (ULP * (length(origin) + 2.0 * size));
                tally.worst = tally.worst.max(step);
                tally.faults += distances(solver, &upper, &rays).into_iter().filter(Option::is_none).count();
            }
        }
    }
    tallies
}
