//! A ray that leaves a surface does not meet it again.

use crate::*;

const SEED: u64 = 0x5eed_0002;

const THINGS: usize = 150;
/// Hits on each thing, and rays from each hit.
const HITS: usize = 20;
const RAYS: usize = 12;

/// The sides that a ray can leave a thing to without meeting it again: both of what is flat,
/// the outer one of what is convex.
fn sides(kind: Kind) -> &'static [f64] {
    match kind {
        Kind::Torus => &[],
        Kind::Plane
        | Kind::Disc
        | Kind::Triangle
        | Kind::SmoothTriangle
        | Kind::Polygon
        | Kind::SmoothPolygon => &[1.0, -1.0],
        _ => &[1.0],
    }
}

/// A direction to the side of `normal`; every other one grazes it, down to some 1e-4, where the
/// roundings of the normal itself are still small.
fn outward(normal: Vector, random: &mut Random) -> Vector {
    loop {
        let direction = random.direction();
        let height = direction.dot(normal);
        let wanted = if random.below(2) == 0 { height.abs() } else { random.scale(1e-4, 1e-1) };
        let direction = direction + normal * (wanted - height);
        let direction = vector(rounded(direction.x), rounded(direction.y), rounded(direction.z));
        if direction.dot(normal) > 0.9 * wanted && wanted > 1e-4 {
            return direction;
        }
    }
}

fn is_not_met_again(kind: Kind) {
    let mut random = Random::new(SEED + kind as u64);
    for core in CORES {
        let mut rays = 0;
        for _ in 0..THINGS {
            let size = random.scale(1e-4, 1e4);
            // Every third round the origin, the others up to 1e4 sizes away.
            let away = if random.below(3) == 0 { 0.0 } else { size * random.scale(1.0, 1e4) };
            let thing = Thing::random(kind, random.direction() * away, size, &mut random);
            let lines: Vec<Line> = (0..HITS).map(|_| random_ray(&thing, &mut random)).collect();
            for found in (core.cast)(&thing, &lines).into_iter().flatten() {
                for side in sides(kind) {
                    let side = found.normal * *side;
                    let origin = (core.leave)(&found, side);
                    let line = |_| Line { origin, direction: outward(side, &mut random) };
                    let lines: Vec<Line> = (0..RAYS).map(line).collect();
                    for (line, again) in lines.iter().zip((core.cast)(&thing, &lines)) {
                        assert!(again.is_none(), "{}: {thing:?}\n{found:?}\n{line:?}\n{again:?}", core.name);
                    }
                    rays += lines.len();
                }
            }
        }
        assert!(rays > THINGS * HITS * RAYS / 8 || sides(kind).is_empty(), "{rays}");
    }
}

for_every_kind!(is_not_met_again, is_not_met_again_by_a_ray_that_leaves_it);

#[test]
fn a_floor_on_a_coordinate_plane_is_not_met_again() {
    // No coordinate of its points is off along the normal: the step must not vanish with them.
    let corner = |x, z| vector(x, 0.0, z);
    let corners = [corner(-3.0, -2.0), corner(5.0, -1.0), corner(0.5, 7.0)];
    let mut random = Random::new(SEED + 100);
    for thing in [
        Thing::Triangle { corners },
        Thing::Polygon { corners: corners.to_vec() },
        Thing::Disc { center: Vector::ZERO, normal: Vector::Y, radius: 4.0 },
        Thing::Plane { point: Vector::ZERO, normal: Vector::Y },
        Thing::Cuboid { min: vector(-5.0, -1.0, -5.0), max: vector(5.0, 0.0, 5.0) },
    ] {
        for core in CORES {
            for _ in 0..300 {
                let eye = random.near(vector(0.0, 5.0, 0.0), 2.0);
                let Some(found) = core.one(&thing, towards(eye, random.near(Vector::ZERO, 3.0), 1.0)) else {
                    continue;
                };
                let origin = (core.leave)(&found, found.normal * found.normal.y);
                for _ in 0..30 {
                    let line = Line { origin, direction: outward(Vector::Y, &mut random) };
                    let again = core.one(&thing, line);
                    assert!(again.is_none(), "{}: {thing:?}\n{found:?}\n{line:?}\n{again:?}", core.name);
                }
            }
        }
    }
}

/// A triangle whose plane goes through the origin, which lies inside or on its edge: where its
/// points have small coordinates the rounding of the test does not become small with them. Its
/// height is at least `least` of its longest side.
fn through_the_origin(random: &mut Random, least: f64, most: f64) -> [Vector; 3] {
    loop {
        let (a, b) = (random.near(Vector::ZERO, 1.0), random.near(Vector::ZERO, 1.0));
        let corners = [[a, b, -(a + b)], [a, -a, b], [Vector::ZERO, a, b]][random.below(3) as usize];
        let corners = corners.map(|c| vector(rounded(c.x), rounded(c.y), rounded(c.z)));
        let [a, b, c] = corners;
        let longest = [b - a, c - b, a - c].map(|side| side.dot(side)).into_iter().fold(0.0, f64::max);
        let height = length((b - a).cross(c - a)) / longest;
        if height >= least && height <= most {
            return corners;
        }
    }
}

/// How many of the rays that leave such triangles, near the origin, meet them again.
fn met_again_near_the_origin(least: f64, most: f64, as_polygon: bool) -> usize {
    let mut random = Random::new(SEED + 101);
    let mut again = 0;
    for core in CORES {
        for _ in 0..2000 {
            let corners = through_the_origin(&mut random, least, most);
            let thing = match as_polygon {
                true => Thing::Polygon { corners: corners.to_vec() },
                false => Thing::Triangle { corners },
            };
            let aim = |random: &mut Random| {
                let shrunk = random.scale(1e-5, 0.3);
                let target = corners.iter().map(|corner| *corner * (shrunk * random.unit())).sum();
                towards(random.near(Vector::ZERO, 3.0), target, 1.0)
            };
            let lines: Vec<Line> = (0..10).map(|_| aim(&mut random)).collect();
            for found in (core.cast)(&thing, &lines).into_iter().flatten() {
                for side in [found.normal, -found.normal] {
                    let origin = (core.leave)(&found, side);
                    let line = |_| Line { origin, direction: outward(side, &mut random) };
                    let lines: Vec<Line> = (0..10).map(line).collect();
                    again += (core.cast)(&thing, &lines).iter().flatten().count();
                }
            }
        }
    }
    again
}

#[test]
fn a_triangle_through_the_origin_is_not_met_again_there() {
    assert_eq!(met_again_near_the_origin(0.05, 1.0, false), 0);
}

#[test]
fn a_polygon_through_the_origin_is_not_met_again_there() {
    assert_eq!(met_again_near_the_origin(0.05, 1.0, true), 0);
}

#[test]
fn a_needle_through_the_origin_is_not_met_again_there() {
    assert_eq!(met_again_near_the_origin(1e-4, 0.02, false), 0);
}
