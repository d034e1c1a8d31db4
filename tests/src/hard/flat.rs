//! Hard rays at what is flat: triangles, polygons, planes, discs and boxes.

use super::case::{AimFunction, HardCase, about_one, as_f32, aside, length, towards};
use crate::SplitMix64;
use crate::test_shape::{TestRay, TestShape};
use crate::vector::{DVec3, dvec3};

/// Rays at one thing.
const RAYS: usize = 25;

const fn flat(family: &'static str, name: &'static str, naive: &'static str, aim: AimFunction) -> HardCase {
    HardCase::aimed(family, name, naive, 4.0, 400, aim)
}

pub(super) const CASES: [HardCase; 16] = [
    flat("triangle", "needles, 10 to 1e5 times as long as high", "the determinant cancels", needle),
    flat("triangle", "of size 1e-5 to 1e-3", "an absolute threshold takes it for edge-on", tiny_triangle),
    flat("triangle", "10 to 1e4 sizes away", "edge functions cancel", far_triangle).easy(),
    flat("triangle", "of size 1e4, eye close", "edge functions cancel", huge_triangle).easy(),
    flat(
        "triangle",
        "rays at 1e-5 to 0.01 to its plane",
        "the determinant is below the threshold",
        grazed_triangle,
    ),
    flat("triangle", "1e4 sizes from the origin", "coordinates are coarse", placed_triangle),
    flat(
        "polygon",
        "star, comb, spiral: level with corners",
        "a corner counts twice or never",
        level_with_corners,
    ),
    flat("polygon", "1e4 sizes from the origin", "the plane's constant is coarse", placed_polygon),
    flat("plane", "rays at 1e-5 to 0.01 to it", "a threshold takes them for parallel", grazed_plane),
    flat("plane", "point and eye 1e5 from the origin", "the plane's constant is coarse", placed_plane),
    flat("disc", "at r (1 +- 10^-k) from its centre", "hit and miss change places", disc_rim),
    flat("box", "components 0 and -0", "`d >= 0` takes -0 for 0, and changes the walls", zeros),
    flat("box", "at corners and along edges", "walls in the wrong order", corners_of_box).easy(),
    flat("box", "eye inside", "the near wall is behind", inside_box).easy(),
    flat(
        "turned box",
        "up to 1e4 sizes from the origin",
        "turned before the centre is subtracted",
        placed_box,
    ),
    flat("turned box", "at corners and along edges", "walls in the wrong order", corners_of_turned).easy(),
];

fn some<T>(mut one: impl FnMut() -> T) -> Vec<T> {
    (0..RAYS).map(|_| one()).collect()
}

/// A point of a triangle, or a little outside.
fn point_of([a, b, c]: &[DVec3; 3], rng: &mut SplitMix64) -> DVec3 {
    let (u, v) = (rng.between(-0.1, 1.1), rng.between(-0.1, 1.1));
    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
    *a + (*b - *a) * u + (*c - *a) * v
}

fn any_triangle(place: DVec3, size: f64, rng: &mut SplitMix64) -> [DVec3; 3] {
    match TestShape::random(crate::TestShapeKind::Triangle, place, size, rng) {
        TestShape::Triangle { corners } => corners,
        _ => unreachable!("it was asked for a triangle"),
    }
}

fn needle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let long = rng.log_between(1e-2, 1e2);
    let a = rng.in_ball(DVec3::ZERO, long);
    let way = rng.direction() * long;
    let b = as_f32(a + way);
    let along = rng.between(0.0, 1.0);
    let c = as_f32(a + way * along + aside(way, rng) * (long * rng.log_between(1e-5, 0.1)));
    let corners = [a, b, c];
    let ray = |rng: &mut SplitMix64| {
        let target = point_of(&corners, rng);
        towards(as_f32(target + rng.direction() * (long * rng.log_between(0.01, 3.0))), target)
    };
    (TestShape::Triangle { corners }, some(|| ray(rng)))
}

fn tiny_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(1e-5, 1e-3);
    let corners = any_triangle(rng.in_ball(DVec3::ZERO, 10.0 * size), size, rng);
    let eye = as_f32(corners[0] + rng.direction() * (size * rng.log_between(1.0, 30.0)));
    (TestShape::Triangle { corners }, some(|| towards(eye, point_of(&corners, rng))))
}

fn far_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(0.1, 10.0);
    let corners = any_triangle(rng.in_ball(DVec3::ZERO, 3.0 * size), size, rng);
    let eye = as_f32(corners[0] + rng.direction() * (size * rng.log_between(10.0, 1e4)));
    (TestShape::Triangle { corners }, some(|| towards(eye, point_of(&corners, rng))))
}

fn huge_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let corners = any_triangle(DVec3::ZERO, 1e4, rng);
    let ray = |rng: &mut SplitMix64| {
        let target = point_of(&corners, rng);
        let eye = as_f32(point_of(&corners, rng) * 0.01 + target * 0.99);
        towards(as_f32(eye + rng.direction() * rng.log_between(0.5, 100.0)), target)
    };
    (TestShape::Triangle { corners }, some(|| ray(rng)))
}

fn unit_normal([a, b, c]: &[DVec3; 3]) -> DVec3 {
    let n = (*b - *a).cross(*c - *a);
    n / length(n)
}

fn grazed_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(1e-2, 1e2);
    let corners = any_triangle(rng.in_ball(DVec3::ZERO, size), size, rng);
    let n = unit_normal(&corners);
    let ray = |rng: &mut SplitMix64| {
        let target = point_of(&corners, rng);
        let away = aside(n, rng) + n * rng.log_between(1e-5, 1e-2);
        towards(as_f32(target + away * (size * rng.log_between(0.3, 10.0))), target)
    };
    (TestShape::Triangle { corners }, some(|| ray(rng)))
}

fn placed_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(1e-2, 1e2);
    let place = as_f32(rng.direction() * (size * rng.log_between(1e3, 1e4)));
    let corners = any_triangle(place, size, rng);
    let eye = as_f32(place + rng.direction() * (size * rng.log_between(0.5, 10.0)));
    (TestShape::Triangle { corners }, some(|| towards(eye, point_of(&corners, rng))))
}

/// Corners with whole coordinates, many of them level with each other.
fn whole(rng: &mut SplitMix64) -> Vec<(f64, f64)> {
    match rng.below(3) {
        // A star of four to nine points, its notches level with other points.
        0 => {
            let points = 4 + rng.below(6);
            let reach = |i: u32| if i.is_multiple_of(2) { 12.0 } else { 5.0 };
            let corner = |i: u32| {
                let angle = f64::from(i) * std::f64::consts::PI / f64::from(points);
                ((reach(i) * libm::cos(angle)).round(), (reach(i) * libm::sin(angle)).round())
            };
            (0..2 * points).map(corner).collect()
        }
        // A comb, whose teeth end at three levels.
        1 => {
            let mut corners = vec![(-9.0, -6.0), (9.0, -6.0)];
            for tooth in (-4..=4).rev() {
                let (x, top) = (2.0 * f64::from(tooth), f64::from(2 + 2 * rng.below(3)));
                corners.extend([(x + 1.0, -2.0), (x + 0.5, top), (x, top), (x - 1.0, -2.0)]);
            }
            corners
        }
        // A spiral of two turns.
        _ => {
            let mut outer =
                vec![(-8.0, -8.0), (8.0, -8.0), (8.0, 8.0), (-8.0, 8.0), (-8.0, -4.0), (4.0, -4.0)];
            outer.extend([
                (4.0, 4.0),
                (-4.0, 4.0),
                (-4.0, 0.0),
                (-2.0, 0.0),
                (-2.0, 2.0),
                (2.0, 2.0),
                (2.0, -2.0),
            ]);
            outer.extend([(-6.0, -2.0), (-6.0, 6.0), (6.0, 6.0), (6.0, -6.0), (-8.0, -6.0)]);
            outer
        }
    }
}

fn level_with_corners(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let corners = whole(rng);
    let turn = rng.below(3);
    let placed = |x: f64, y: f64, z: f64| [dvec3(x, y, z), dvec3(y, z, x), dvec3(z, x, y)][turn as usize];
    let ray = |rng: &mut SplitMix64| {
        let (level_x, level_y) = corners[rng.below(corners.len() as u32) as usize];
        // Level with a corner along one of both axes, and anywhere along the other.
        let free = rng.between(-12.0, 12.0);
        let (x, y) = if rng.below(2) == 0 { (level_x, free) } else { (free, level_y) };
        let height = rng.between(1.0, 20.0);
        TestRay { origin: placed(x, y, height), direction: placed(0.0, 0.0, -rng.log_between(0.1, 10.0)) }
    };
    let rays = some(|| ray(rng));
    (TestShape::Polygon { corners: corners.iter().map(|(x, y)| placed(*x, *y, 0.0)).collect() }, rays)
}

fn placed_polygon(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(1e-2, 1e2);
    let place = as_f32(rng.direction() * (size * rng.log_between(1e3, 1e4)));
    let polygon = TestShape::random(crate::TestShapeKind::Polygon, place, size, rng);
    let eye = as_f32(place + rng.direction() * (size * rng.log_between(0.5, 10.0)));
    (polygon, some(|| towards(eye, rng.in_ball(place, size))))
}

fn grazed_plane(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (size, normal) = (rng.log_between(1e-2, 1e2), rng.direction());
    let point = rng.in_ball(DVec3::ZERO, size);
    let ray = |rng: &mut SplitMix64| {
        let target = point + aside(normal, rng) * (size * rng.unit());
        let away = aside(normal, rng) + normal / length(normal) * rng.log_between(1e-5, 1e-2);
        towards(as_f32(target + away * (size * rng.log_between(0.3, 10.0))), target)
    };
    (TestShape::Plane { point, normal }, some(|| ray(rng)))
}

fn placed_plane(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let place = as_f32(rng.direction() * 1e5);
    let (point, normal) = (rng.in_ball(place, 10.0), rng.direction());
    let ray = |rng: &mut SplitMix64| towards(rng.in_ball(place, 10.0), rng.in_ball(place, 10.0));
    (TestShape::Plane { point, normal }, some(|| ray(rng)))
}

fn disc_rim(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (radius, normal) = (rng.log_between(1e-3, 1e3), rng.direction());
    let center = rng.in_ball(DVec3::ZERO, 1e3 * radius);
    let ray = |rng: &mut SplitMix64| {
        let eye = as_f32(center + rng.direction() * (radius * rng.log_between(0.5, 100.0)));
        towards(eye, center + aside(normal, rng) * (radius * about_one(rng)))
    };
    (TestShape::Disc { center, normal, radius }, some(|| ray(rng)))
}

fn any_box(rng: &mut SplitMix64) -> (DVec3, DVec3) {
    let size = rng.log_between(1e-3, 1e3);
    let center = rng.in_ball(DVec3::ZERO, 3.0 * size);
    let half =
        dvec3(rng.log_between(0.05, 1.0), rng.log_between(0.05, 1.0), rng.log_between(0.05, 1.0)) * size;
    (as_f32(center - half), as_f32(center + half))
}

fn zeros(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (min, max) = any_box(rng);
    let (center, half) = ((min + max) * 0.5, (max - min) * 0.5);
    let ray = |rng: &mut SplitMix64| {
        let origin = as_f32(center + half * rng.in_ball(DVec3::ZERO, 2.0));
        let target = center + half * rng.in_ball(DVec3::ZERO, 1.0);
        let mut way = as_f32(target - origin);
        // One or two of the components, of either sign.
        let first = rng.below(3) as usize;
        for axis in [first, (first + rng.below(2) as usize) % 3] {
            way[axis] = if rng.below(2) == 0 { 0.0 } else { -0.0 };
        }
        TestRay { origin, direction: way }
    };
    (TestShape::Cuboid { min, max }, some(|| ray(rng)))
}

/// A corner of the box from -1 to 1, or a point of one of its edges.
fn corner_or_edge(rng: &mut SplitMix64) -> DVec3 {
    let mut side = || if rng.below(2) == 0 { -1.0 } else { 1.0 };
    let mut corner = dvec3(side(), side(), side());
    if rng.below(2) == 0 {
        corner[rng.below(3) as usize] = rng.between(-1.0, 1.0);
    }
    // Somewhat to either side.
    corner + rng.direction() * rng.log_between(1e-7, 0.1)
}

fn corners_of_box(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (min, max) = any_box(rng);
    let (center, half) = ((min + max) * 0.5, (max - min) * 0.5);
    let eye = as_f32(center + rng.direction() * (length(half) * rng.log_between(1.2, 100.0)));
    let rays = some(|| towards(eye, center + half * corner_or_edge(rng)));
    (TestShape::Cuboid { min, max }, rays)
}

fn inside_box(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (min, max) = any_box(rng);
    let (center, half) = ((min + max) * 0.5, (max - min) * 0.5);
    let ray = |rng: &mut SplitMix64| {
        let origin = as_f32(center + half * rng.in_ball(DVec3::ZERO, 0.99));
        TestRay { origin, direction: as_f32(rng.direction() * rng.log_between(0.01, 100.0)) }
    };
    (TestShape::Cuboid { min, max }, some(|| ray(rng)))
}

/// A turned box, and its middle, the halves of its lengths and its axes.
fn any_turned(place: f64, rng: &mut SplitMix64) -> (TestShape, DVec3, DVec3, [DVec3; 3]) {
    let size = rng.log_between(1e-2, 1e2);
    let third = rng.direction();
    let first = aside(third, rng);
    let first = as_f32(first + third * rng.between(-0.5, 0.5));
    let center = as_f32(rng.direction() * (size * place));
    let half =
        as_f32(dvec3(rng.log_between(0.1, 1.0), rng.log_between(0.1, 1.0), rng.log_between(0.1, 1.0)) * size);
    let z = third / length(third);
    let y = z.cross(first) / length(z.cross(first));
    (TestShape::OrientedCuboid { center, half, first, third }, center, half, [y.cross(z), y, z])
}

fn placed_box(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let place = rng.log_between(1e2, 1e4);
    let (shape, center, half, _) = any_turned(place, rng);
    let ray = |rng: &mut SplitMix64| {
        let eye = as_f32(center + rng.direction() * (length(half) * rng.log_between(0.1, 10.0)));
        towards(eye, rng.in_ball(center, length(half)))
    };
    (shape, some(|| ray(rng)))
}

fn corners_of_turned(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (shape, center, half, [x, y, z]) = any_turned(3.0, rng);
    let eye = as_f32(center + rng.direction() * (length(half) * rng.log_between(1.2, 100.0)));
    let ray = |rng: &mut SplitMix64| {
        let own = half * corner_or_edge(rng);
        towards(eye, center + x * own.x + y * own.y + z * own.z)
    };
    (shape, some(|| ray(rng)))
}
