//! Hard rays at flat shapes: triangles, polygons, planes, discs and boxes.

use super::case::{AimFunction, HardCase, about_one, as_f32, length, perpendicular, towards};
use strahl_test_scene::{DVec3, SplitMix64, TestRay, TestShape, dvec3};

/// Rays at each shape.
const RAYS: usize = 25;

const fn flat(family: &'static str, name: &'static str, naive: &'static str, aim: AimFunction) -> HardCase {
    HardCase::aimed(family, name, naive, 4.0, 400, aim)
}

pub(super) const CASES: [HardCase; 16] = [
    flat("triangle", "needles, 10 to 1e5 times as long as high", "the determinant cancels", needle),
    flat("triangle", "of size 1e-5 to 1e-3", "an absolute threshold treats it as edge-on", tiny_triangle),
    flat("triangle", "10 to 1e4 sizes away", "edge functions cancel", far_triangle).easy(),
    flat("triangle", "of size 1e4, eye close", "edge functions cancel", huge_triangle).easy(),
    flat(
        "triangle",
        "grazing rays, 1e-5 to 0.01 rad to its plane",
        "the determinant is below the threshold",
        grazed_triangle,
    )
    .seed(0xf118_0ebb_080f_5f12),
    flat("triangle", "1e4 sizes from the origin", "coordinates are coarse", distant_triangle),
    flat(
        "polygon",
        "star, comb, spiral: level with vertices",
        "a vertex counts twice or never",
        level_with_vertices,
    )
    .seed(0xad79_a35d_74be_ee23),
    flat("polygon", "1e4 sizes from the origin", "the plane's constant is coarse", distant_polygon),
    flat(
        "plane",
        "grazing rays, 1e-5 to 0.01 rad to it",
        "a threshold treats them as parallel",
        grazed_plane,
    )
    .seed(0xf1fb_1cd4_5e67_94b3),
    flat("plane", "point and eye 1e5 from the origin", "the plane's constant is coarse", distant_plane),
    flat("disc", "at r (1 +- 10^-k) from its center", "hit and miss are swapped", disc_edge)
        .seed(0x7815_6c88_a78b_d7af),
    flat("box", "components 0 and -0", "`d >= 0` treats -0 as 0 and swaps the slab planes", zeros),
    flat("box", "at corners and along edges", "slab planes in the wrong order", corners_of_box).easy(),
    flat("box", "eye inside", "the near plane is behind", inside_box).easy(),
    flat(
        "oriented box",
        "up to 1e4 sizes from the origin",
        "rotated before the center is subtracted",
        distant_box,
    )
    .seed(0x7190_ba5d_a2af_12c7),
    flat(
        "oriented box",
        "at corners and along edges",
        "slab planes in the wrong order",
        corners_of_oriented_box,
    )
    .easy()
    .seed(0x9441_f434_ee40_479b),
];

fn rays<T>(mut one: impl FnMut() -> T) -> Vec<T> {
    (0..RAYS).map(|_| one()).collect()
}

/// A point of a triangle, or slightly outside.
fn point_of([a, b, c]: &[DVec3; 3], rng: &mut SplitMix64) -> DVec3 {
    let (u, v) = (rng.between(-0.1, 1.1), rng.between(-0.1, 1.1));
    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
    *a + (*b - *a) * u + (*c - *a) * v
}

fn any_triangle(center: DVec3, size: f64, rng: &mut SplitMix64) -> [DVec3; 3] {
    match TestShape::random(strahl_test_scene::TestShapeKind::Triangle, center, size, rng) {
        TestShape::Triangle { vertices } => vertices,
        _ => unreachable!("the kind is a triangle"),
    }
}

fn needle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let long = rng.log_between(1e-2, 1e2);
    let a = rng.in_ball(DVec3::ZERO, long);
    let edge = rng.direction() * long;
    let b = as_f32(a + edge);
    let along = rng.between(0.0, 1.0);
    let c = as_f32(a + edge * along + perpendicular(edge, rng) * (long * rng.log_between(1e-5, 0.1)));
    let vertices = [a, b, c];
    let ray = |rng: &mut SplitMix64| {
        let target = point_of(&vertices, rng);
        towards(as_f32(target + rng.direction() * (long * rng.log_between(0.01, 3.0))), target)
    };
    (TestShape::Triangle { vertices }, rays(|| ray(rng)))
}

fn tiny_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(1e-5, 1e-3);
    let vertices = any_triangle(rng.in_ball(DVec3::ZERO, 10.0 * size), size, rng);
    let viewpoint = as_f32(vertices[0] + rng.direction() * (size * rng.log_between(1.0, 30.0)));
    (TestShape::Triangle { vertices }, rays(|| towards(viewpoint, point_of(&vertices, rng))))
}

fn far_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(0.1, 10.0);
    let vertices = any_triangle(rng.in_ball(DVec3::ZERO, 3.0 * size), size, rng);
    let viewpoint = as_f32(vertices[0] + rng.direction() * (size * rng.log_between(10.0, 1e4)));
    (TestShape::Triangle { vertices }, rays(|| towards(viewpoint, point_of(&vertices, rng))))
}

fn huge_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let vertices = any_triangle(DVec3::ZERO, 1e4, rng);
    let ray = |rng: &mut SplitMix64| {
        let target = point_of(&vertices, rng);
        let viewpoint = as_f32(point_of(&vertices, rng) * 0.01 + target * 0.99);
        towards(as_f32(viewpoint + rng.direction() * rng.log_between(0.5, 100.0)), target)
    };
    (TestShape::Triangle { vertices }, rays(|| ray(rng)))
}

fn unit_normal([a, b, c]: &[DVec3; 3]) -> DVec3 {
    let n = (*b - *a).cross(*c - *a);
    n / length(n)
}

fn grazed_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(1e-2, 1e2);
    let vertices = any_triangle(rng.in_ball(DVec3::ZERO, size), size, rng);
    let n = unit_normal(&vertices);
    let ray = |rng: &mut SplitMix64| {
        let target = point_of(&vertices, rng);
        let away = perpendicular(n, rng) + n * rng.log_between(1e-5, 1e-2);
        towards(as_f32(target + away * (size * rng.log_between(0.3, 10.0))), target)
    };
    (TestShape::Triangle { vertices }, rays(|| ray(rng)))
}

fn distant_triangle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(1e-2, 1e2);
    let center = as_f32(rng.direction() * (size * rng.log_between(1e3, 1e4)));
    let vertices = any_triangle(center, size, rng);
    let viewpoint = as_f32(center + rng.direction() * (size * rng.log_between(0.5, 10.0)));
    (TestShape::Triangle { vertices }, rays(|| towards(viewpoint, point_of(&vertices, rng))))
}

/// Vertices with integer coordinates, many of them level with each other.
fn integer_polygon(rng: &mut SplitMix64) -> Vec<(f64, f64)> {
    match rng.below(3) {
        // A star of four to nine points.
        0 => {
            let points = 4 + rng.below(6);
            let radius = |i: u32| if i.is_multiple_of(2) { 12.0 } else { 5.0 };
            let corner = |i: u32| {
                let angle = f64::from(i) * std::f64::consts::PI / f64::from(points);
                ((radius(i) * libm::cos(angle)).round(), (radius(i) * libm::sin(angle)).round())
            };
            (0..2 * points).map(corner).collect()
        }
        // A comb, whose teeth end at three levels.
        1 => {
            let mut vertices = vec![(-9.0, -6.0), (9.0, -6.0)];
            for tooth in (-4..=4).rev() {
                let (x, top) = (2.0 * f64::from(tooth), f64::from(2 + 2 * rng.below(3)));
                vertices.extend([(x + 1.0, -2.0), (x + 0.5, top), (x, top), (x - 1.0, -2.0)]);
            }
            vertices
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

fn level_with_vertices(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let vertices = integer_polygon(rng);
    let turn = rng.below(3);
    let placed = |x: f64, y: f64, z: f64| [dvec3(x, y, z), dvec3(y, z, x), dvec3(z, x, y)][turn as usize];
    let ray = |rng: &mut SplitMix64| {
        let (level_x, level_y) = vertices[rng.below(vertices.len() as u32) as usize];
        // Level with a vertex along one axis, anywhere along the other.
        let free = rng.between(-12.0, 12.0);
        let (x, y) = if rng.below(2) == 0 { (level_x, free) } else { (free, level_y) };
        let height = rng.between(1.0, 20.0);
        TestRay { origin: placed(x, y, height), direction: placed(0.0, 0.0, -rng.log_between(0.1, 10.0)) }
    };
    let rays = rays(|| ray(rng));
    (TestShape::Polygon { vertices: vertices.iter().map(|(x, y)| placed(*x, *y, 0.0)).collect() }, rays)
}

fn distant_polygon(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let size = rng.log_between(1e-2, 1e2);
    let center = as_f32(rng.direction() * (size * rng.log_between(1e3, 1e4)));
    let polygon = TestShape::random(strahl_test_scene::TestShapeKind::Polygon, center, size, rng);
    let viewpoint = as_f32(center + rng.direction() * (size * rng.log_between(0.5, 10.0)));
    (polygon, rays(|| towards(viewpoint, rng.in_ball(center, size))))
}

fn grazed_plane(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (size, normal) = (rng.log_between(1e-2, 1e2), rng.direction());
    let point = rng.in_ball(DVec3::ZERO, size);
    let ray = |rng: &mut SplitMix64| {
        let target = point + perpendicular(normal, rng) * (size * rng.unit());
        let away = perpendicular(normal, rng) + normal / length(normal) * rng.log_between(1e-5, 1e-2);
        towards(as_f32(target + away * (size * rng.log_between(0.3, 10.0))), target)
    };
    (TestShape::Plane { point, normal }, rays(|| ray(rng)))
}

fn distant_plane(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let center = as_f32(rng.direction() * 1e5);
    let (point, normal) = (rng.in_ball(center, 10.0), rng.direction());
    let ray = |rng: &mut SplitMix64| towards(rng.in_ball(center, 10.0), rng.in_ball(center, 10.0));
    (TestShape::Plane { point, normal }, rays(|| ray(rng)))
}

fn disc_edge(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (radius, normal) = (rng.log_between(1e-3, 1e3), rng.direction());
    let center = rng.in_ball(DVec3::ZERO, 1e3 * radius);
    let ray = |rng: &mut SplitMix64| {
        let viewpoint = as_f32(center + rng.direction() * (radius * rng.log_between(0.5, 100.0)));
        towards(viewpoint, center + perpendicular(normal, rng) * (radius * about_one(rng)))
    };
    (TestShape::Disc { center, normal, radius }, rays(|| ray(rng)))
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
        let mut direction = as_f32(target - origin);
        // One or two zero components, of either sign.
        let first = rng.below(3) as usize;
        for axis in [first, (first + rng.below(2) as usize) % 3] {
            direction[axis] = if rng.below(2) == 0 { 0.0 } else { -0.0 };
        }
        TestRay { origin, direction }
    };
    (TestShape::Cuboid { min, max }, rays(|| ray(rng)))
}

/// A corner of the box from -1 to 1, or a point of one of its edges, slightly displaced.
fn corner_or_edge(rng: &mut SplitMix64) -> DVec3 {
    let mut side = || if rng.below(2) == 0 { -1.0 } else { 1.0 };
    let mut corner = dvec3(side(), side(), side());
    if rng.below(2) == 0 {
        corner[rng.below(3) as usize] = rng.between(-1.0, 1.0);
    }
    corner + rng.direction() * rng.log_between(1e-7, 0.1)
}

fn corners_of_box(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (min, max) = any_box(rng);
    let (center, half) = ((min + max) * 0.5, (max - min) * 0.5);
    let viewpoint = as_f32(center + rng.direction() * (length(half) * rng.log_between(1.2, 100.0)));
    let rays = rays(|| towards(viewpoint, center + half * corner_or_edge(rng)));
    (TestShape::Cuboid { min, max }, rays)
}

fn inside_box(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (min, max) = any_box(rng);
    let (center, half) = ((min + max) * 0.5, (max - min) * 0.5);
    let ray = |rng: &mut SplitMix64| {
        let origin = as_f32(center + half * rng.in_ball(DVec3::ZERO, 0.99));
        TestRay { origin, direction: as_f32(rng.direction() * rng.log_between(0.01, 100.0)) }
    };
    (TestShape::Cuboid { min, max }, rays(|| ray(rng)))
}

/// A random oriented box, its center, half extents and axes.
fn any_oriented_box(relative_distance: f64, rng: &mut SplitMix64) -> (TestShape, DVec3, DVec3, [DVec3; 3]) {
    let size = rng.log_between(1e-2, 1e2);
    let third = rng.direction();
    let first = perpendicular(third, rng);
    let first = as_f32(first + third * rng.between(-0.5, 0.5));
    let center = as_f32(rng.direction() * (size * relative_distance));
    let half =
        as_f32(dvec3(rng.log_between(0.1, 1.0), rng.log_between(0.1, 1.0), rng.log_between(0.1, 1.0)) * size);
    let z = third / length(third);
    let y = z.cross(first) / length(z.cross(first));
    (TestShape::OrientedCuboid { center, half, first, third }, center, half, [y.cross(z), y, z])
}

fn distant_box(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let relative_distance = rng.log_between(1e2, 1e4);
    let (shape, center, half, _) = any_oriented_box(relative_distance, rng);
    let ray = |rng: &mut SplitMix64| {
        let viewpoint = as_f32(center + rng.direction() * (length(half) * rng.log_between(0.1, 10.0)));
        towards(viewpoint, rng.in_ball(center, length(half)))
    };
    (shape, rays(|| ray(rng)))
}

fn corners_of_oriented_box(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (shape, center, half, [x, y, z]) = any_oriented_box(3.0, rng);
    let viewpoint = as_f32(center + rng.direction() * (length(half) * rng.log_between(1.2, 100.0)));
    let ray = |rng: &mut SplitMix64| {
        let own = half * corner_or_edge(rng);
        towards(viewpoint, center + x * own.x + y * own.y + z * own.z)
    };
    (shape, rays(|| ray(rng)))
}
