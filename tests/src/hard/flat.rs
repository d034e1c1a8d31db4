//! Hard rays at what is flat: triangles, polygons, planes, discs and boxes.

use super::case::{Aim, Case, about_one, aside, held, length, towards};
use crate::Random;
use crate::thing::{Line, Thing};
use crate::vector::{Vector, vector};

/// Rays at one thing.
const RAYS: usize = 25;

const fn flat(family: &'static str, name: &'static str, naive: &'static str, aim: Aim) -> Case {
    Case::aimed(family, name, naive, 4.0, 400, aim)
}

pub(super) const CASES: [Case; 16] = [
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
fn point_of([a, b, c]: &[Vector; 3], random: &mut Random) -> Vector {
    let (u, v) = (random.between(-0.1, 1.1), random.between(-0.1, 1.1));
    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
    *a + (*b - *a) * u + (*c - *a) * v
}

fn any_triangle(place: Vector, size: f64, random: &mut Random) -> [Vector; 3] {
    match Thing::random(crate::Kind::Triangle, place, size, random) {
        Thing::Triangle { corners } => corners,
        _ => unreachable!("it was asked for a triangle"),
    }
}

fn needle(random: &mut Random) -> (Thing, Vec<Line>) {
    let long = random.scale(1e-2, 1e2);
    let a = random.near(Vector::ZERO, long);
    let way = random.direction() * long;
    let b = held(a + way);
    let along = random.between(0.0, 1.0);
    let c = held(a + way * along + aside(way, random) * (long * random.scale(1e-5, 0.1)));
    let corners = [a, b, c];
    let line = |random: &mut Random| {
        let target = point_of(&corners, random);
        towards(held(target + random.direction() * (long * random.scale(0.01, 3.0))), target)
    };
    (Thing::Triangle { corners }, some(|| line(random)))
}

fn tiny_triangle(random: &mut Random) -> (Thing, Vec<Line>) {
    let size = random.scale(1e-5, 1e-3);
    let corners = any_triangle(random.near(Vector::ZERO, 10.0 * size), size, random);
    let eye = held(corners[0] + random.direction() * (size * random.scale(1.0, 30.0)));
    (Thing::Triangle { corners }, some(|| towards(eye, point_of(&corners, random))))
}

fn far_triangle(random: &mut Random) -> (Thing, Vec<Line>) {
    let size = random.scale(0.1, 10.0);
    let corners = any_triangle(random.near(Vector::ZERO, 3.0 * size), size, random);
    let eye = held(corners[0] + random.direction() * (size * random.scale(10.0, 1e4)));
    (Thing::Triangle { corners }, some(|| towards(eye, point_of(&corners, random))))
}

fn huge_triangle(random: &mut Random) -> (Thing, Vec<Line>) {
    let corners = any_triangle(Vector::ZERO, 1e4, random);
    let line = |random: &mut Random| {
        let target = point_of(&corners, random);
        let eye = held(point_of(&corners, random) * 0.01 + target * 0.99);
        towards(held(eye + random.direction() * random.scale(0.5, 100.0)), target)
    };
    (Thing::Triangle { corners }, some(|| line(random)))
}

fn upright_on([a, b, c]: &[Vector; 3]) -> Vector {
    let n = (*b - *a).cross(*c - *a);
    n / length(n)
}

fn grazed_triangle(random: &mut Random) -> (Thing, Vec<Line>) {
    let size = random.scale(1e-2, 1e2);
    let corners = any_triangle(random.near(Vector::ZERO, size), size, random);
    let n = upright_on(&corners);
    let line = |random: &mut Random| {
        let target = point_of(&corners, random);
        let away = aside(n, random) + n * random.scale(1e-5, 1e-2);
        towards(held(target + away * (size * random.scale(0.3, 10.0))), target)
    };
    (Thing::Triangle { corners }, some(|| line(random)))
}

fn placed_triangle(random: &mut Random) -> (Thing, Vec<Line>) {
    let size = random.scale(1e-2, 1e2);
    let place = held(random.direction() * (size * random.scale(1e3, 1e4)));
    let corners = any_triangle(place, size, random);
    let eye = held(place + random.direction() * (size * random.scale(0.5, 10.0)));
    (Thing::Triangle { corners }, some(|| towards(eye, point_of(&corners, random))))
}

/// Corners with whole coordinates, many of them level with each other.
fn whole(random: &mut Random) -> Vec<(f64, f64)> {
    match random.below(3) {
        // A star of four to nine points, its notches level with other points.
        0 => {
            let points = 4 + random.below(6);
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
                let (x, top) = (2.0 * f64::from(tooth), f64::from(2 + 2 * random.below(3)));
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

fn level_with_corners(random: &mut Random) -> (Thing, Vec<Line>) {
    let corners = whole(random);
    let turn = random.below(3);
    let placed = |x: f64, y: f64, z: f64| [vector(x, y, z), vector(y, z, x), vector(z, x, y)][turn as usize];
    let line = |random: &mut Random| {
        let (level_x, level_y) = corners[random.below(corners.len() as u32) as usize];
        // Level with a corner along one of both axes, and anywhere along the other.
        let free = random.between(-12.0, 12.0);
        let (x, y) = if random.below(2) == 0 { (level_x, free) } else { (free, level_y) };
        let height = random.between(1.0, 20.0);
        Line { origin: placed(x, y, height), direction: placed(0.0, 0.0, -random.scale(0.1, 10.0)) }
    };
    let lines = some(|| line(random));
    (Thing::Polygon { corners: corners.iter().map(|(x, y)| placed(*x, *y, 0.0)).collect() }, lines)
}

fn placed_polygon(random: &mut Random) -> (Thing, Vec<Line>) {
    let size = random.scale(1e-2, 1e2);
    let place = held(random.direction() * (size * random.scale(1e3, 1e4)));
    let polygon = Thing::random(crate::Kind::Polygon, place, size, random);
    let eye = held(place + random.direction() * (size * random.scale(0.5, 10.0)));
    (polygon, some(|| towards(eye, random.near(place, size))))
}

fn grazed_plane(random: &mut Random) -> (Thing, Vec<Line>) {
    let (size, normal) = (random.scale(1e-2, 1e2), random.direction());
    let point = random.near(Vector::ZERO, size);
    let line = |random: &mut Random| {
        let target = point + aside(normal, random) * (size * random.unit());
        let away = aside(normal, random) + normal / length(normal) * random.scale(1e-5, 1e-2);
        towards(held(target + away * (size * random.scale(0.3, 10.0))), target)
    };
    (Thing::Plane { point, normal }, some(|| line(random)))
}

fn placed_plane(random: &mut Random) -> (Thing, Vec<Line>) {
    let place = held(random.direction() * 1e5);
    let (point, normal) = (random.near(place, 10.0), random.direction());
    let line = |random: &mut Random| towards(random.near(place, 10.0), random.near(place, 10.0));
    (Thing::Plane { point, normal }, some(|| line(random)))
}

fn disc_rim(random: &mut Random) -> (Thing, Vec<Line>) {
    let (radius, normal) = (random.scale(1e-3, 1e3), random.direction());
    let center = random.near(Vector::ZERO, 1e3 * radius);
    let line = |random: &mut Random| {
        let eye = held(center + random.direction() * (radius * random.scale(0.5, 100.0)));
        towards(eye, center + aside(normal, random) * (radius * about_one(random)))
    };
    (Thing::Disc { center, normal, radius }, some(|| line(random)))
}

fn any_box(random: &mut Random) -> (Vector, Vector) {
    let size = random.scale(1e-3, 1e3);
    let center = random.near(Vector::ZERO, 3.0 * size);
    let half = vector(random.scale(0.05, 1.0), random.scale(0.05, 1.0), random.scale(0.05, 1.0)) * size;
    (held(center - half), held(center + half))
}

fn zeros(random: &mut Random) -> (Thing, Vec<Line>) {
    let (min, max) = any_box(random);
    let (center, half) = ((min + max) * 0.5, (max - min) * 0.5);
    let line = |random: &mut Random| {
        let origin = held(center + half * random.near(Vector::ZERO, 2.0));
        let target = center + half * random.near(Vector::ZERO, 1.0);
        let mut way = held(target - origin);
        // One or two of the components, of either sign.
        let first = random.below(3) as usize;
        for axis in [first, (first + random.below(2) as usize) % 3] {
            way[axis] = if random.below(2) == 0 { 0.0 } else { -0.0 };
        }
        Line { origin, direction: way }
    };
    (Thing::Cuboid { min, max }, some(|| line(random)))
}

/// A corner of the box from -1 to 1, or a point of one of its edges.
fn corner_or_edge(random: &mut Random) -> Vector {
    let mut side = || if random.below(2) == 0 { -1.0 } else { 1.0 };
    let mut corner = vector(side(), side(), side());
    if random.below(2) == 0 {
        corner[random.below(3) as usize] = random.between(-1.0, 1.0);
    }
    // Somewhat to either side.
    corner + random.direction() * random.scale(1e-7, 0.1)
}

fn corners_of_box(random: &mut Random) -> (Thing, Vec<Line>) {
    let (min, max) = any_box(random);
    let (center, half) = ((min + max) * 0.5, (max - min) * 0.5);
    let eye = held(center + random.direction() * (length(half) * random.scale(1.2, 100.0)));
    let lines = some(|| towards(eye, center + half * corner_or_edge(random)));
    (Thing::Cuboid { min, max }, lines)
}

fn inside_box(random: &mut Random) -> (Thing, Vec<Line>) {
    let (min, max) = any_box(random);
    let (center, half) = ((min + max) * 0.5, (max - min) * 0.5);
    let line = |random: &mut Random| {
        let origin = held(center + half * random.near(Vector::ZERO, 0.99));
        Line { origin, direction: held(random.direction() * random.scale(0.01, 100.0)) }
    };
    (Thing::Cuboid { min, max }, some(|| line(random)))
}

/// A turned box, and its middle, the halves of its lengths and its axes.
fn any_turned(place: f64, random: &mut Random) -> (Thing, Vector, Vector, [Vector; 3]) {
    let size = random.scale(1e-2, 1e2);
    let third = random.direction();
    let first = aside(third, random);
    let first = held(first + third * random.between(-0.5, 0.5));
    let center = held(random.direction() * (size * place));
    let half = held(vector(random.scale(0.1, 1.0), random.scale(0.1, 1.0), random.scale(0.1, 1.0)) * size);
    let z = third / length(third);
    let y = z.cross(first) / length(z.cross(first));
    (Thing::OrientedCuboid { center, half, first, third }, center, half, [y.cross(z), y, z])
}

fn placed_box(random: &mut Random) -> (Thing, Vec<Line>) {
    let place = random.scale(1e2, 1e4);
    let (thing, center, half, _) = any_turned(place, random);
    let line = |random: &mut Random| {
        let eye = held(center + random.direction() * (length(half) * random.scale(0.1, 10.0)));
        towards(eye, random.near(center, length(half)))
    };
    (thing, some(|| line(random)))
}

fn corners_of_turned(random: &mut Random) -> (Thing, Vec<Line>) {
    let (thing, center, half, [x, y, z]) = any_turned(3.0, random);
    let eye = held(center + random.direction() * (length(half) * random.scale(1.2, 100.0)));
    let line = |random: &mut Random| {
        let own = half * corner_or_edge(random);
        towards(eye, center + x * own.x + y * own.y + z * own.z)
    };
    (thing, some(|| line(random)))
}
