//! Shapes at places where the answer is known on paper, in both cores.
//!
//! Most numbers are such that no step rounds; then the answer is asked for exactly. Else a
//! distance of about 5 may be off by a few roundings of that: see [`near`].

use strahl_core::Rgb;
use strahl_tests::assert_picture;

use crate::*;

fn line(origin: [f64; 3], direction: [f64; 3]) -> Line {
    let held = |[x, y, z]: [f64; 3]| vector(rounded(x), rounded(y), rounded(z));
    Line { origin: held(origin), direction: held(direction) }
}

/// Distance and normal, from both cores, which must agree on them to the last bit.
fn met(thing: &Thing, line: Line) -> Option<(f64, Vector)> {
    let [one, other] = CORES.map(|core| core.one(thing, line).map(|found| (found.t, found.normal)));
    assert_eq!(one, other, "{thing:?}\n{line:?}");
    one
}

/// The same where rounding has its say: distance and normal are right to eight roundoffs of 5,
/// the largest number in these scenes.
fn near(thing: &Thing, line: Line, t: f64, normal: Vector) {
    for core in CORES {
        let found = core.one(thing, line).unwrap();
        let bound = 8.0 * 5.0 * core.roundoff;
        assert!((found.t - t).abs() <= bound, "{}: {} is not {t}\n{thing:?}", core.name, found.t);
        assert!(
            length(found.normal - normal) <= bound,
            "{}: {:?} is not {normal:?}",
            core.name,
            found.normal
        );
    }
}

#[test]
fn a_sphere_is_met_in_front_behind_and_from_inside() {
    let sphere = Thing::Sphere { center: vector(0.0, 0.0, -5.0), radius: 1.0 };
    assert_eq!(met(&sphere, line([0.0; 3], [0.0, 0.0, -1.0])), Some((4.0, Vector::Z)));
    assert_eq!(met(&sphere, line([0.0; 3], [0.0, 0.0, -0.5])), Some((8.0, Vector::Z)));
    assert_eq!(met(&sphere, line([0.0, 0.0, -5.0], [0.0, 0.0, -1.0])), Some((1.0, -Vector::Z)));
    assert_eq!(met(&sphere, line([0.0, 0.0, -5.5], [0.0, 0.0, 1.0])), Some((1.5, Vector::Z)));
    assert_eq!(met(&sphere, line([0.0; 3], [0.0, 0.0, 1.0])), None);
    assert_eq!(met(&sphere, line([0.0, 1.5, 0.0], [0.0, 0.0, -1.0])), None);
    // 3, 4, 5.
    let sphere = Thing::Sphere { center: vector(0.0, 0.0, -5.0), radius: 5.0 };
    near(&sphere, line([3.0, 0.0, 4.0], [0.0, 0.0, -1.0]), 5.0, vector(0.6, 0.0, 0.8));
}

#[test]
fn a_plane_is_met_from_both_sides_and_never_turns_its_normal() {
    let plane = Thing::Plane { point: vector(7.0, 2.0, 1.0), normal: vector(0.0, 3.0, 0.0) };
    assert_eq!(met(&plane, line([0.0, 5.0, 0.0], [1.0, -1.0, 0.5])), Some((3.0, Vector::Y)));
    assert_eq!(met(&plane, line([0.0, -5.0, 0.0], [1.0, 2.0, 0.5])), Some((3.5, Vector::Y)));
    assert_eq!(met(&plane, line([0.0, 5.0, 0.0], [1.0, 1.0, 0.5])), None);
    assert_eq!(met(&plane, line([0.0, 5.0, 0.0], [1.0, 0.0, 0.5])), None, "parallel");
    assert_eq!(met(&plane, line([0.0, 2.0, 0.0], [1.0, 0.0, 0.5])), None, "in the plane");
}

#[test]
fn a_disc_ends_at_its_rim() {
    let disc = Thing::Disc { center: vector(1.0, 0.0, 0.0), normal: vector(0.0, 0.0, 2.0), radius: 2.0 };
    let down = |x: f64, y: f64| met(&disc, line([x, y, 4.0], [0.0, 0.0, -1.0]));
    let up = |x: f64, y: f64| met(&disc, line([x, y, -4.0], [0.0, 0.0, 1.0]));
    for (x, y) in [(1.0, 0.0), (2.75, 0.75), (-1.0, 0.0), (1.0, 2.0)] {
        assert_eq!(down(x, y), Some((4.0, Vector::Z)), "{x} {y}");
        assert_eq!(up(x, y), Some((4.0, Vector::Z)), "{x} {y}");
    }
    for (x, y) in [(3.001, 0.0), (1.0, -2.001), (2.75, 1.0)] {
        assert_eq!((down(x, y), up(x, y)), (None, None), "{x} {y}");
    }
}

#[test]
fn a_triangle_contains_its_edges_and_corners() {
    let corners = [vector(0.0, 0.0, 1.0), vector(4.0, 0.0, 1.0), vector(0.0, 4.0, 1.0)];
    let triangle = Thing::Triangle { corners };
    for (x, y) in [(1.0, 1.0), (0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (2.0, 0.0), (0.0, 1.0), (2.0, 2.0)] {
        assert_eq!(met(&triangle, line([x, y, 5.0], [0.0, 0.0, -2.0])), Some((2.0, Vector::Z)), "{x} {y}");
        assert_eq!(met(&triangle, line([x, y, -1.0], [0.0, 0.0, 1.0])), Some((2.0, Vector::Z)), "{x} {y}");
    }
    for (x, y) in [(-0.001, 1.0), (1.0, -0.001), (2.0, 2.001), (4.001, 0.0)] {
        assert_eq!(met(&triangle, line([x, y, 5.0], [0.0, 0.0, -1.0])), None, "{x} {y}");
    }
    // The other way round the normal is the other one.
    let triangle = Thing::Triangle { corners: [corners[0], corners[2], corners[1]] };
    assert_eq!(met(&triangle, line([1.0, 1.0, 5.0], [0.0, 0.0, -1.0])), Some((4.0, -Vector::Z)));
}

#[test]
fn a_triangle_without_area_is_never_met() {
    let mut random = Random::new(5);
    for round in 0..3000 {
        // On a raster, so that three points on one line are on it exactly.
        let mut point = |size: f64| (random.near(Vector::ZERO, size) * 64.0).round() / 64.0;
        let (a, b) = (point(4.0), point(1.0));
        let corners = [[a, a + b, a + b * 3.0], [a, a + b, a], [a, a, a]][round % 3];
        let triangle = Thing::Triangle { corners };
        let aim = |random: &mut Random| {
            let eye = random.near(Vector::ZERO, 6.0);
            towards(eye, a + b * (3.0 * random.unit()), 1.0)
        };
        let lines: Vec<Line> = (0..10).map(|_| aim(&mut random)).collect();
        for core in CORES {
            assert!((core.cast)(&triangle, &lines).iter().all(Option::is_none), "{}: {corners:?}", core.name);
        }
    }
}

#[test]
fn the_shading_normal_in_the_middle_is_the_mean_of_those_of_the_corners() {
    let corners = [vector(-2.0, -1.0, 0.0), vector(2.0, -1.0, 0.0), vector(0.0, 2.0, 0.0)];
    let normals = [vector(3.0, 0.0, 4.0), vector(-3.0, 0.0, 4.0), vector(0.0, 0.0, 1.0)];
    let smooth = [
        Thing::SmoothTriangle { corners, normals },
        Thing::SmoothPolygon { corners: corners.to_vec(), normals: normals.to_vec() },
    ];
    for thing in smooth {
        for core in CORES {
            let shading = |x, y| core.one(&thing, line([x, y, 3.0], [0.0, 0.0, -1.0])).unwrap().shading;
            let near = |n: Vector, want: Vector| {
                assert!(length(n - want) <= 16.0 * core.roundoff, "{}: {n:?} is not {want:?}", core.name);
            };
            near(shading(0.0, 0.0), Vector::Z);
            // In the middle of an edge that of its two ends; close to a corner that of the corner.
            near(shading(0.0, -1.0 + 1e-7), Vector::Z);
            let n = shading(-1.9999, -0.9999);
            assert!(length(n - vector(0.6, 0.0, 0.8)) <= 1e-4, "{n:?}");
        }
    }
}

/// The shape as it is seen along -z, through the middles of the unit squares of a raster.
fn seen(thing: &Thing, width: i32, height: i32) -> Vec<Rgb> {
    let ray =
        |x: i32, y: i32| line([f64::from(x) + 0.5, f64::from(height - 1 - y) + 0.5, 3.0], [0.0, 0.0, -1.0]);
    let color = |hit: Option<_>| if hit.is_some() { Rgb::WHITE } else { Rgb::BLACK };
    (0..height).flat_map(|y| (0..width).map(move |x| color(met(thing, ray(x, y))))).collect()
}

/// A polygon, both ways round; the normal follows the way.
fn polygons(corners: &[(f64, f64)]) -> [Thing; 2] {
    let mut corners: Vec<Vector> = corners.iter().map(|(x, y)| vector(*x, *y, 0.0)).collect();
    let left = Thing::Polygon { corners: corners.clone() };
    corners.reverse();
    [left, Thing::Polygon { corners }]
}

#[test]
fn a_polygon_may_have_the_form_of_an_l() {
    for (polygon, up) in polygons(&[(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)])
        .into_iter()
        .zip([1.0, -1.0])
    {
        assert_picture(
            &seen(&polygon, 8, 6),
            8,
            "
            ........
            ##......
            ##......
            ##......
            ######..
            ######..",
        );
        for z in [3.0, -3.0] {
            let (t, normal) = met(&polygon, line([1.0, 1.0, z], [0.0, 0.0, -z])).unwrap();
            assert_eq!((t, normal), (1.0, vector(0.0, 0.0, up)));
        }
    }
}

#[test]
fn a_polygon_may_have_the_form_of_a_comb() {
    // Many corners are level with each other and with the rays.
    let mut corners = vec![(0.0, 0.0), (9.0, 0.0), (9.0, 3.5)];
    for tooth in (0..4).rev() {
        let x = 2.0 * f64::from(tooth);
        corners.extend([(x + 2.0, 3.5), (x + 2.0, 1.5), (x + 1.0, 1.5), (x + 1.0, 3.5)]);
    }
    corners.push((0.0, 3.5));
    for polygon in polygons(&corners) {
        assert_picture(
            &seen(&polygon, 10, 5),
            10,
            "
            ..........
            ..........
            #.#.#.#.#.
            #.#.#.#.#.
            #########.",
        );
    }
}

#[test]
fn a_polygon_may_have_the_form_of_a_star() {
    // The rays of the middle row and column run level with corners.
    let star =
        [(5.5, 11.0), (4.0, 7.0), (0.0, 5.5), (4.0, 4.0), (5.5, 0.0), (7.0, 4.0), (11.0, 5.5), (7.0, 7.0)];
    for polygon in polygons(&star) {
        assert_picture(
            &seen(&polygon, 11, 11),
            11,
            "
            .....#.....
            .....#.....
            .....#.....
            ....###....
            ...#####...
            ###########
            ...#####...
            ....###....
            .....#.....
            .....#.....
            .....#.....",
        );
    }
}

#[test]
fn a_corner_level_with_the_point_counts_once() {
    let [polygon, _] = polygons(&[(0.0, 0.0), (4.0, 0.0), (6.0, 1.0), (4.0, 2.0), (0.0, 2.0), (-2.0, 1.0)]);
    let hit = |x: f64, y: f64| met(&polygon, line([x, y, 1.0], [0.0, 0.0, -1.0])).is_some();
    assert!([-1.0, 0.0, 2.0, 5.0].iter().all(|x| hit(*x, 1.0)));
    assert!([-3.0, -2.5, 6.5, 9.0].iter().all(|x| !hit(*x, 1.0)));
    assert!(!hit(2.0, -0.5) && !hit(-1.0, 2.5));
}

#[test]
fn a_box_is_met_at_all_six_faces_from_outside_and_inside() {
    let cuboid = Thing::Cuboid { min: vector(-1.0, -2.0, -3.0), max: vector(1.0, 2.0, 3.0) };
    let turned = Thing::OrientedCuboid {
        center: Vector::ZERO,
        half: vector(1.0, 2.0, 3.0),
        first: vector(5.0, 0.0, 0.0),
        third: Vector::Z,
    };
    for thing in [cuboid, turned] {
        for (axis, half) in [(Vector::X, 1.0), (Vector::Y, 2.0), (Vector::Z, 3.0)] {
            for side in [axis, -axis] {
                // Both signs of zero, alone and in pairs.
                for zero in [0.0, -0.0] {
                    let inward = Line { origin: side * 5.0, direction: -side + vector(zero, zero, zero) };
                    assert_eq!(met(&thing, inward), Some((5.0 - half, side)));
                    let outward = Line { origin: Vector::ZERO, direction: side + vector(zero, zero, zero) };
                    assert_eq!(met(&thing, outward), Some((half, side)));
                    let away = Line { origin: side * 5.0, direction: side + vector(zero, zero, zero) };
                    assert_eq!(met(&thing, away), None);
                }
            }
        }
    }
}

#[test]
fn a_box_on_its_edge_is_met_at_the_edge() {
    // Turned by an eighth, half of its diagonal is the root of 2.
    let root = 2.0_f64.sqrt();
    let thing = Thing::OrientedCuboid {
        center: vector(0.0, 0.0, -3.0),
        half: Vector::ONE,
        first: vector(1.0, 0.0, 1.0),
        third: vector(-1.0, 0.0, 1.0),
    };
    let (x, z) = (0.25, 1.0 / root);
    near(&thing, line([x, 0.5, 2.0], [0.0, 0.0, -1.0]), 5.0 - root + x, vector(z, 0.0, z));
    near(&thing, line([-x, 0.5, 2.0], [0.0, 0.0, -1.0]), 5.0 - root + x, vector(-z, 0.0, z));
    assert_eq!(CORES.map(|core| core.one(&thing, line([1.42, 0.0, 2.0], [0.0, 0.0, -1.0]))), [None; 2]);
}

#[test]
fn a_plate_without_thickness_is_met_from_both_sides() {
    let plate = Thing::Cuboid { min: vector(-1.0, -1.0, 2.0), max: vector(1.0, 1.0, 2.0) };
    for (z, side) in [(4.0, 1.0), (0.0, -1.0)] {
        let (t, normal) = met(&plate, line([0.5, 0.25, z], [0.0, 0.0, -side])).unwrap();
        assert_eq!((t, normal), (2.0, vector(0.0, 0.0, side)));
    }
}

fn tube(radius: f64, end_radius: f64, capped: bool) -> Thing {
    Thing::Cone { base: Vector::ZERO, base_radius: radius, end: vector(0.0, 0.0, 2.0), end_radius, capped }
}

#[test]
fn a_cylinder_is_met_at_its_side_from_outside_and_inside() {
    for capped in [false, true] {
        let cylinder = tube(1.5, 1.5, capped);
        assert_eq!(met(&cylinder, line([4.0, 0.0, 1.0], [-1.0, 0.0, 0.0])), Some((2.5, Vector::X)));
        // From inside the normal still leaves the axis.
        assert_eq!(met(&cylinder, line([0.0, 0.0, 1.0], [-1.0, 0.0, 0.0])), Some((1.5, -Vector::X)));
        assert_eq!(met(&cylinder, line([4.0, 0.0, 2.5], [-1.0, 0.0, 0.0])), None);
        assert_eq!(met(&cylinder, line([4.0, 1.75, 1.0], [-1.0, 0.0, 0.0])), None);
    }
}

#[test]
fn only_a_capped_cylinder_is_met_along_its_axis() {
    for x in [0.0, 1.0] {
        let along = line([x, 0.0, -2.0], [0.0, 0.0, 1.0]);
        assert_eq!(met(&tube(1.5, 1.5, false), along), None);
        assert_eq!(met(&tube(1.5, 1.5, true), along), Some((2.0, -Vector::Z)));
        let inside = line([x, 0.0, 0.5], [0.0, 0.0, 1.0]);
        assert_eq!(met(&tube(1.5, 1.5, true), inside), Some((1.5, Vector::Z)));
    }
}

#[test]
fn a_ray_through_the_open_end_meets_the_inside() {
    // In at (0, 0, 2), and at z = 1 by 1 from the axis.
    let slanted = line([-1.0, 0.0, 3.0], [1.0, 0.0, -1.0]);
    assert_eq!(met(&tube(1.0, 1.0, false), slanted), Some((2.0, Vector::X)));
    assert_eq!(met(&tube(1.0, 1.0, true), slanted), Some((1.0, Vector::Z)));
}

#[test]
fn a_cone_is_met_at_its_side_and_its_other_nappe_never() {
    let cone = tube(2.0, 0.0, false);
    let slant = 0.5_f64.sqrt();
    near(&cone, line([3.0, 0.0, 1.0], [-1.0, 0.0, 0.0]), 2.0, vector(slant, 0.0, slant));
    near(&cone, line([0.0, 0.0, 0.5], [0.0, -1.0, 0.0]), 1.5, vector(0.0, -slant, slant));
    // Beyond the apex the same formula has a cone upside down.
    assert_eq!(met(&cone, line([3.0, 0.0, 3.0], [-1.0, 0.0, 0.0])), None);
    assert_eq!(met(&cone, line([3.0, 0.0, -0.5], [-1.0, 0.0, 0.0])), None);
    // Along the axis through the apex's inside: two thirds out the side is two thirds high.
    near(&cone, line([1.0, 0.0, -1.0], [0.0, 0.0, 1.0]), 2.0, vector(slant, 0.0, slant));
    // Parallel to one side, so that the equation has only one root: the other side, from inside.
    near(&cone, line([0.0, 0.0, 0.5], [-1.0, 0.0, 1.0]), 0.75, vector(-slant, 0.0, slant));
}

#[test]
fn a_ray_through_the_middle_of_a_torus_meets_it_four_times() {
    let torus =
        Thing::Torus { center: vector(1.0, 0.0, 0.0), axis: vector(0.0, 2.0, 0.0), major: 2.0, minor: 0.5 };
    // From the left, from inside the tube, from the hole, from inside the tube beyond.
    for (start, place, side) in [(-4.0, -1.5, -1.0), (-1.25, -0.5, 1.0), (1.0, 2.5, -1.0), (3.25, 3.5, 1.0)] {
        near(&torus, line([start, 0.0, 0.0], [1.0, 0.0, 0.0]), place - start, vector(side, 0.0, 0.0));
    }
    let miss = |origin, direction| {
        assert_eq!(CORES.map(|core| core.one(&torus, line(origin, direction))), [None; 2])
    };
    miss([3.75, 0.0, 0.0], [1.0, 0.0, 0.0]);
    // Through the hole, along the axis and beside it.
    miss([1.0, 4.0, 0.0], [0.0, -1.0, 0.0]);
    miss([2.4, 4.0, 0.0], [0.0, -1.0, 0.0]);
    // On the top of the tube.
    near(&torus, line([3.0, 4.0, 0.0], [0.0, -1.0, 0.0]), 3.5, Vector::Y);
    near(&torus, line([1.0, 0.0, 2.0], [0.0, -1.0, 0.0]), 0.5, -Vector::Y);
}
