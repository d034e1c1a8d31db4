//! A ray that leaves a surface does not hit it again.

use crate::*;

const SEED: u64 = 0x5eed_0002;

const SHAPES: usize = 150;
/// Hits of each shape, and rays from each hit.
const HITS: usize = 20;
const RAYS: usize = 12;

/// Sides of a shape, as factors of the normal, on which no ray hits the shape again: both of a flat shape,
/// the outer one of a convex solid.
fn sides(kind: TestShapeKind) -> &'static [f64] {
    match kind {
        TestShapeKind::Torus => &[],
        TestShapeKind::Plane
        | TestShapeKind::Disc
        | TestShapeKind::Triangle
        | TestShapeKind::SmoothTriangle
        | TestShapeKind::Polygon
        | TestShapeKind::SmoothPolygon => &[1.0, -1.0],
        _ => &[1.0],
    }
}

/// A direction on the side of `normal`. Every other one is grazing, down to about 1e-4, where the rounding
/// error of the normal is still small.
fn outward(normal: DVec3, rng: &mut SplitMix64) -> DVec3 {
    loop {
        let direction = rng.direction();
        let height = direction.dot(normal);
        let target_height = if rng.below(2) == 0 { height.abs() } else { rng.log_between(1e-4, 1e-1) };
        let direction = direction + normal * (target_height - height);
        let direction = dvec3(rounded(direction.x), rounded(direction.y), rounded(direction.z));
        if direction.dot(normal) > 0.9 * target_height && target_height > 1e-4 {
            return direction;
        }
    }
}

fn is_not_hit_again(kind: TestShapeKind) {
    let mut rng = SplitMix64::new(SEED + kind as u64);
    for core in CORES {
        let mut ray_count = 0;
        for _ in 0..SHAPES {
            let size = rng.log_between(1e-4, 1e4);
            // Every third around the origin, the others up to 1e4 sizes away.
            let away = if rng.below(3) == 0 { 0.0 } else { size * rng.log_between(1.0, 1e4) };
            let shape = TestShape::random(kind, rng.direction() * away, size, &mut rng);
            let rays: Vec<TestRay> = (0..HITS).map(|_| random_ray(&shape, &mut rng)).collect();
            for hit in (core.cast)(&shape, &rays).into_iter().flatten() {
                for side in sides(kind) {
                    let side = hit.normal * *side;
                    let origin = (core.offset_origin)(&hit, side);
                    let ray = |_| TestRay { origin, direction: outward(side, &mut rng) };
                    let rays: Vec<TestRay> = (0..RAYS).map(ray).collect();
                    for (ray, again) in rays.iter().zip((core.cast)(&shape, &rays)) {
                        assert!(again.is_none(), "{}: {shape:?}\n{hit:?}\n{ray:?}\n{again:?}", core.name);
                    }
                    ray_count += rays.len();
                }
            }
        }
        assert!(ray_count > SHAPES * HITS * RAYS / 8 || sides(kind).is_empty(), "{ray_count}");
    }
}

for_every_kind!(is_not_hit_again, is_not_hit_again_by_a_ray_that_leaves_it);

#[test]
fn a_floor_on_a_coordinate_plane_is_not_hit_again() {
    // Its points have no error along the normal; the offset must not vanish with the error.
    let vertex = |x, z| dvec3(x, 0.0, z);
    let vertices = [vertex(-3.0, -2.0), vertex(5.0, -1.0), vertex(0.5, 7.0)];
    let mut rng = SplitMix64::new(SEED + 100);
    for shape in [
        TestShape::Triangle { vertices },
        TestShape::Polygon { vertices: vertices.to_vec() },
        TestShape::Disc { center: DVec3::ZERO, normal: DVec3::Y, radius: 4.0 },
        TestShape::Plane { point: DVec3::ZERO, normal: DVec3::Y },
        TestShape::Cuboid { min: dvec3(-5.0, -1.0, -5.0), max: dvec3(5.0, 0.0, 5.0) },
    ] {
        for core in CORES {
            for _ in 0..300 {
                let viewpoint = rng.in_ball(dvec3(0.0, 5.0, 0.0), 2.0);
                let Some(hit) = core.one(&shape, towards(viewpoint, rng.in_ball(DVec3::ZERO, 3.0), 1.0))
                else {
                    continue;
                };
                let origin = (core.offset_origin)(&hit, hit.normal * hit.normal.y);
                for _ in 0..30 {
                    let ray = TestRay { origin, direction: outward(DVec3::Y, &mut rng) };
                    let again = core.one(&shape, ray);
                    assert!(again.is_none(), "{}: {shape:?}\n{hit:?}\n{ray:?}\n{again:?}", core.name);
                }
            }
        }
    }
}

/// A triangle that contains the origin, inside or on its edge. Near the origin coordinates are small, but the
/// rounding errors of the intersection are not. Its height is `min` to `max` times its longest side.
fn through_the_origin(rng: &mut SplitMix64, min: f64, max: f64) -> [DVec3; 3] {
    loop {
        let (a, b) = (rng.in_ball(DVec3::ZERO, 1.0), rng.in_ball(DVec3::ZERO, 1.0));
        let vertices = [[a, b, -(a + b)], [a, -a, b], [DVec3::ZERO, a, b]][rng.below(3) as usize];
        let vertices = vertices.map(|c| dvec3(rounded(c.x), rounded(c.y), rounded(c.z)));
        let [a, b, c] = vertices;
        let longest = [b - a, c - b, a - c].map(|side| side.dot(side)).into_iter().fold(0.0, f64::max);
        let height = length((b - a).cross(c - a)) / longest;
        if height >= min && height <= max {
            return vertices;
        }
    }
}

/// Number of rays that leave such triangles near the origin and hit them again.
fn self_intersections_near_the_origin(min: f64, max: f64, as_polygon: bool) -> usize {
    let mut rng = SplitMix64::new(SEED + 101);
    let mut again = 0;
    for core in CORES {
        for _ in 0..2000 {
            let vertices = through_the_origin(&mut rng, min, max);
            let shape = match as_polygon {
                true => TestShape::Polygon { vertices: vertices.to_vec() },
                false => TestShape::Triangle { vertices },
            };
            let aim = |rng: &mut SplitMix64| {
                let shrunk = rng.log_between(1e-5, 0.3);
                let target = vertices.iter().map(|vertex| *vertex * (shrunk * rng.unit())).sum();
                towards(rng.in_ball(DVec3::ZERO, 3.0), target, 1.0)
            };
            let rays: Vec<TestRay> = (0..10).map(|_| aim(&mut rng)).collect();
            for hit in (core.cast)(&shape, &rays).into_iter().flatten() {
                for side in [hit.normal, -hit.normal] {
                    let origin = (core.offset_origin)(&hit, side);
                    let ray = |_| TestRay { origin, direction: outward(side, &mut rng) };
                    let rays: Vec<TestRay> = (0..10).map(ray).collect();
                    again += (core.cast)(&shape, &rays).iter().flatten().count();
                }
            }
        }
    }
    again
}

#[test]
fn a_triangle_through_the_origin_is_not_hit_again_there() {
    assert_eq!(self_intersections_near_the_origin(0.05, 1.0, false), 0);
}

#[test]
fn a_polygon_through_the_origin_is_not_hit_again_there() {
    assert_eq!(self_intersections_near_the_origin(0.05, 1.0, true), 0);
}

#[test]
fn a_needle_through_the_origin_is_not_hit_again_there() {
    assert_eq!(self_intersections_near_the_origin(1e-4, 0.02, false), 0);
}
