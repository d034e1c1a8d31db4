//! Shapes whose hits are known on paper, in both cores.
//!
//! Most numbers are chosen so that no step rounds; the answer must then be exact. Otherwise a distance of
//! about 5 may have an error of a few roundings: see [`assert_near`].

use strahl_core::Rgb;
use strahl_tests::assert_picture;

use crate::*;

fn ray(origin: [f64; 3], direction: [f64; 3]) -> TestRay {
    let held = |[x, y, z]: [f64; 3]| dvec3(rounded(x), rounded(y), rounded(z));
    TestRay { origin: held(origin), direction: held(direction) }
}

/// Distance and normal of a hit, which must be equal in both cores, bit for bit.
fn hit(shape: &TestShape, ray: TestRay) -> Option<(f64, DVec3)> {
    let [one, other] = CORES.map(|core| core.one(shape, ray).map(|hit| (hit.t, hit.normal)));
    assert_eq!(one, other, "{shape:?}\n{ray:?}");
    one
}

/// Asserts that distance and normal are correct to eight roundoffs of 5, the largest number in these scenes.
fn assert_near(shape: &TestShape, ray: TestRay, t: f64, normal: DVec3) {
    for core in CORES {
        let hit = core.one(shape, ray).unwrap();
        let bound = 8.0 * 5.0 * core.roundoff;
        assert!((hit.t - t).abs() <= bound, "{}: {} is not {t}\n{shape:?}", core.name, hit.t);
        assert!(length(hit.normal - normal) <= bound, "{}: {:?} is not {normal:?}", core.name, hit.normal);
    }
}

#[test]
fn a_sphere_is_hit_from_outside_and_from_inside_and_not_behind() {
    let sphere = TestShape::Sphere { center: dvec3(0.0, 0.0, -5.0), radius: 1.0 };
    assert_eq!(hit(&sphere, ray([0.0; 3], [0.0, 0.0, -1.0])), Some((4.0, DVec3::Z)));
    assert_eq!(hit(&sphere, ray([0.0; 3], [0.0, 0.0, -0.5])), Some((8.0, DVec3::Z)));
    assert_eq!(hit(&sphere, ray([0.0, 0.0, -5.0], [0.0, 0.0, -1.0])), Some((1.0, -DVec3::Z)));
    assert_eq!(hit(&sphere, ray([0.0, 0.0, -5.5], [0.0, 0.0, 1.0])), Some((1.5, DVec3::Z)));
    assert_eq!(hit(&sphere, ray([0.0; 3], [0.0, 0.0, 1.0])), None);
    assert_eq!(hit(&sphere, ray([0.0, 1.5, 0.0], [0.0, 0.0, -1.0])), None);
    // 3, 4, 5.
    let sphere = TestShape::Sphere { center: dvec3(0.0, 0.0, -5.0), radius: 5.0 };
    assert_near(&sphere, ray([3.0, 0.0, 4.0], [0.0, 0.0, -1.0]), 5.0, dvec3(0.6, 0.0, 0.8));
}

#[test]
fn a_plane_is_hit_from_both_sides_with_the_same_normal() {
    let plane = TestShape::Plane { point: dvec3(7.0, 2.0, 1.0), normal: dvec3(0.0, 3.0, 0.0) };
    assert_eq!(hit(&plane, ray([0.0, 5.0, 0.0], [1.0, -1.0, 0.5])), Some((3.0, DVec3::Y)));
    assert_eq!(hit(&plane, ray([0.0, -5.0, 0.0], [1.0, 2.0, 0.5])), Some((3.5, DVec3::Y)));
    assert_eq!(hit(&plane, ray([0.0, 5.0, 0.0], [1.0, 1.0, 0.5])), None);
    assert_eq!(hit(&plane, ray([0.0, 5.0, 0.0], [1.0, 0.0, 0.5])), None, "parallel");
    assert_eq!(hit(&plane, ray([0.0, 2.0, 0.0], [1.0, 0.0, 0.5])), None, "in the plane");
}

#[test]
fn a_disc_ends_at_its_radius() {
    let disc = TestShape::Disc { center: dvec3(1.0, 0.0, 0.0), normal: dvec3(0.0, 0.0, 2.0), radius: 2.0 };
    let down = |x: f64, y: f64| hit(&disc, ray([x, y, 4.0], [0.0, 0.0, -1.0]));
    let up = |x: f64, y: f64| hit(&disc, ray([x, y, -4.0], [0.0, 0.0, 1.0]));
    for (x, y) in [(1.0, 0.0), (2.75, 0.75), (-1.0, 0.0), (1.0, 2.0)] {
        assert_eq!(down(x, y), Some((4.0, DVec3::Z)), "{x} {y}");
        assert_eq!(up(x, y), Some((4.0, DVec3::Z)), "{x} {y}");
    }
    for (x, y) in [(3.001, 0.0), (1.0, -2.001), (2.75, 1.0)] {
        assert_eq!((down(x, y), up(x, y)), (None, None), "{x} {y}");
    }
}

#[test]
fn a_triangle_contains_its_edges_and_vertices() {
    let vertices = [dvec3(0.0, 0.0, 1.0), dvec3(4.0, 0.0, 1.0), dvec3(0.0, 4.0, 1.0)];
    let triangle = TestShape::Triangle { vertices };
    for (x, y) in [(1.0, 1.0), (0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (2.0, 0.0), (0.0, 1.0), (2.0, 2.0)] {
        assert_eq!(hit(&triangle, ray([x, y, 5.0], [0.0, 0.0, -2.0])), Some((2.0, DVec3::Z)), "{x} {y}");
        assert_eq!(hit(&triangle, ray([x, y, -1.0], [0.0, 0.0, 1.0])), Some((2.0, DVec3::Z)), "{x} {y}");
    }
    for (x, y) in [(-0.001, 1.0), (1.0, -0.001), (2.0, 2.001), (4.001, 0.0)] {
        assert_eq!(hit(&triangle, ray([x, y, 5.0], [0.0, 0.0, -1.0])), None, "{x} {y}");
    }
    // With the opposite winding the normal is opposite.
    let triangle = TestShape::Triangle { vertices: [vertices[0], vertices[2], vertices[1]] };
    assert_eq!(hit(&triangle, ray([1.0, 1.0, 5.0], [0.0, 0.0, -1.0])), Some((4.0, -DVec3::Z)));
}

#[test]
fn a_triangle_without_area_is_never_hit() {
    let mut rng = SplitMix64::new(5);
    for round in 0..3000 {
        // Multiples of 1/64, so that three points on one line are exactly collinear.
        let mut point = |size: f64| (rng.in_ball(DVec3::ZERO, size) * 64.0).round() / 64.0;
        let (a, b) = (point(4.0), point(1.0));
        let vertices = [[a, a + b, a + b * 3.0], [a, a + b, a], [a, a, a]][round % 3];
        let triangle = TestShape::Triangle { vertices };
        let aim = |rng: &mut SplitMix64| {
            let viewpoint = rng.in_ball(DVec3::ZERO, 6.0);
            towards(viewpoint, a + b * (3.0 * rng.unit()), 1.0)
        };
        let rays: Vec<TestRay> = (0..10).map(|_| aim(&mut rng)).collect();
        for core in CORES {
            assert!((core.cast)(&triangle, &rays).iter().all(Option::is_none), "{}: {vertices:?}", core.name);
        }
    }
}

#[test]
fn the_shading_normal_at_the_center_is_the_mean_of_the_vertex_normals() {
    let vertices = [dvec3(-2.0, -1.0, 0.0), dvec3(2.0, -1.0, 0.0), dvec3(0.0, 2.0, 0.0)];
    let normals = [dvec3(3.0, 0.0, 4.0), dvec3(-3.0, 0.0, 4.0), dvec3(0.0, 0.0, 1.0)];
    let smooth = [
        TestShape::SmoothTriangle { vertices, normals },
        TestShape::SmoothPolygon { vertices: vertices.to_vec(), normals: normals.to_vec() },
    ];
    for shape in smooth {
        for core in CORES {
            let shading = |x, y| core.one(&shape, ray([x, y, 3.0], [0.0, 0.0, -1.0])).unwrap().shading;
            let near = |n: DVec3, expected: DVec3| {
                assert!(
                    length(n - expected) <= 16.0 * core.roundoff,
                    "{}: {n:?} is not {expected:?}",
                    core.name
                );
            };
            near(shading(0.0, 0.0), DVec3::Z);
            // At the midpoint of an edge the mean of its ends; close to a vertex that of the vertex.
            near(shading(0.0, -1.0 + 1e-7), DVec3::Z);
            let n = shading(-1.9999, -0.9999);
            assert!(length(n - dvec3(0.6, 0.0, 0.8)) <= 1e-4, "{n:?}");
        }
    }
}

/// Picture of a shape along -z, with one ray through the center of each unit square.
fn rendered(shape: &TestShape, width: i32, height: i32) -> Vec<Rgb> {
    let ray =
        |x: i32, y: i32| ray([f64::from(x) + 0.5, f64::from(height - 1 - y) + 0.5, 3.0], [0.0, 0.0, -1.0]);
    let color = |hit: Option<_>| if hit.is_some() { Rgb::WHITE } else { Rgb::BLACK };
    (0..height).flat_map(|y| (0..width).map(move |x| color(hit(shape, ray(x, y))))).collect()
}

/// A polygon in both windings; the normal follows the winding.
fn polygons(vertices: &[(f64, f64)]) -> [TestShape; 2] {
    let mut vertices: Vec<DVec3> = vertices.iter().map(|(x, y)| dvec3(*x, *y, 0.0)).collect();
    let counterclockwise = TestShape::Polygon { vertices: vertices.clone() };
    vertices.reverse();
    [counterclockwise, TestShape::Polygon { vertices }]
}

#[test]
fn an_l_shaped_polygon_is_hit_in_its_interior_only() {
    for (polygon, up) in polygons(&[(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)])
        .into_iter()
        .zip([1.0, -1.0])
    {
        assert_picture(
            &rendered(&polygon, 8, 6),
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
            let (t, normal) = hit(&polygon, ray([1.0, 1.0, z], [0.0, 0.0, -z])).unwrap();
            assert_eq!((t, normal), (1.0, dvec3(0.0, 0.0, up)));
        }
    }
}

#[test]
fn a_comb_shaped_polygon_is_hit_in_its_interior_only() {
    // Many vertices are level with each other and with the rays.
    let mut vertices = vec![(0.0, 0.0), (9.0, 0.0), (9.0, 3.5)];
    for tooth in (0..4).rev() {
        let x = 2.0 * f64::from(tooth);
        vertices.extend([(x + 2.0, 3.5), (x + 2.0, 1.5), (x + 1.0, 1.5), (x + 1.0, 3.5)]);
    }
    vertices.push((0.0, 3.5));
    for polygon in polygons(&vertices) {
        assert_picture(
            &rendered(&polygon, 10, 5),
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
fn a_star_shaped_polygon_is_hit_in_its_interior_only() {
    // The rays of the central row and column are level with vertices.
    let star =
        [(5.5, 11.0), (4.0, 7.0), (0.0, 5.5), (4.0, 4.0), (5.5, 0.0), (7.0, 4.0), (11.0, 5.5), (7.0, 7.0)];
    for polygon in polygons(&star) {
        assert_picture(
            &rendered(&polygon, 11, 11),
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
fn a_vertex_level_with_the_point_counts_once() {
    let [polygon, _] = polygons(&[(0.0, 0.0), (4.0, 0.0), (6.0, 1.0), (4.0, 2.0), (0.0, 2.0), (-2.0, 1.0)]);
    let is_hit = |x: f64, y: f64| hit(&polygon, ray([x, y, 1.0], [0.0, 0.0, -1.0])).is_some();
    assert!([-1.0, 0.0, 2.0, 5.0].iter().all(|x| is_hit(*x, 1.0)));
    assert!([-3.0, -2.5, 6.5, 9.0].iter().all(|x| !is_hit(*x, 1.0)));
    assert!(!is_hit(2.0, -0.5) && !is_hit(-1.0, 2.5));
}

#[test]
fn a_box_is_hit_at_all_six_faces_from_outside_and_inside() {
    let cuboid = TestShape::Cuboid { min: dvec3(-1.0, -2.0, -3.0), max: dvec3(1.0, 2.0, 3.0) };
    let oriented = TestShape::OrientedCuboid {
        center: DVec3::ZERO,
        half: dvec3(1.0, 2.0, 3.0),
        first: dvec3(5.0, 0.0, 0.0),
        third: DVec3::Z,
    };
    for shape in [cuboid, oriented] {
        for (axis, half) in [(DVec3::X, 1.0), (DVec3::Y, 2.0), (DVec3::Z, 3.0)] {
            for side in [axis, -axis] {
                // Both signs of zero, alone and in pairs.
                for zero in [0.0, -0.0] {
                    let inward = TestRay { origin: side * 5.0, direction: -side + dvec3(zero, zero, zero) };
                    assert_eq!(hit(&shape, inward), Some((5.0 - half, side)));
                    let outward = TestRay { origin: DVec3::ZERO, direction: side + dvec3(zero, zero, zero) };
                    assert_eq!(hit(&shape, outward), Some((half, side)));
                    let away = TestRay { origin: side * 5.0, direction: side + dvec3(zero, zero, zero) };
                    assert_eq!(hit(&shape, away), None);
                }
            }
        }
    }
}

#[test]
fn a_box_rotated_by_45_degrees_is_hit_beside_its_edge() {
    // Half of its diagonal is the root of 2.
    let root = 2.0_f64.sqrt();
    let shape = TestShape::OrientedCuboid {
        center: dvec3(0.0, 0.0, -3.0),
        half: DVec3::ONE,
        first: dvec3(1.0, 0.0, 1.0),
        third: dvec3(-1.0, 0.0, 1.0),
    };
    let (x, z) = (0.25, 1.0 / root);
    assert_near(&shape, ray([x, 0.5, 2.0], [0.0, 0.0, -1.0]), 5.0 - root + x, dvec3(z, 0.0, z));
    assert_near(&shape, ray([-x, 0.5, 2.0], [0.0, 0.0, -1.0]), 5.0 - root + x, dvec3(-z, 0.0, z));
    assert_eq!(CORES.map(|core| core.one(&shape, ray([1.42, 0.0, 2.0], [0.0, 0.0, -1.0]))), [None; 2]);
}

#[test]
fn a_plate_without_thickness_is_hit_from_both_sides() {
    let plate = TestShape::Cuboid { min: dvec3(-1.0, -1.0, 2.0), max: dvec3(1.0, 1.0, 2.0) };
    for (z, side) in [(4.0, 1.0), (0.0, -1.0)] {
        let (t, normal) = hit(&plate, ray([0.5, 0.25, z], [0.0, 0.0, -side])).unwrap();
        assert_eq!((t, normal), (2.0, dvec3(0.0, 0.0, side)));
    }
}

fn tube(radius: f64, end_radius: f64, capped: bool) -> TestShape {
    TestShape::Cone { base: DVec3::ZERO, base_radius: radius, end: dvec3(0.0, 0.0, 2.0), end_radius, capped }
}

#[test]
fn a_cylinder_is_hit_at_its_side_from_outside_and_inside() {
    for capped in [false, true] {
        let cylinder = tube(1.5, 1.5, capped);
        assert_eq!(hit(&cylinder, ray([4.0, 0.0, 1.0], [-1.0, 0.0, 0.0])), Some((2.5, DVec3::X)));
        // From inside the normal still points away from the axis.
        assert_eq!(hit(&cylinder, ray([0.0, 0.0, 1.0], [-1.0, 0.0, 0.0])), Some((1.5, -DVec3::X)));
        assert_eq!(hit(&cylinder, ray([4.0, 0.0, 2.5], [-1.0, 0.0, 0.0])), None);
        assert_eq!(hit(&cylinder, ray([4.0, 1.75, 1.0], [-1.0, 0.0, 0.0])), None);
    }
}

#[test]
fn only_a_capped_cylinder_is_hit_along_its_axis() {
    for x in [0.0, 1.0] {
        let along = ray([x, 0.0, -2.0], [0.0, 0.0, 1.0]);
        assert_eq!(hit(&tube(1.5, 1.5, false), along), None);
        assert_eq!(hit(&tube(1.5, 1.5, true), along), Some((2.0, -DVec3::Z)));
        let inside = ray([x, 0.0, 0.5], [0.0, 0.0, 1.0]);
        assert_eq!(hit(&tube(1.5, 1.5, true), inside), Some((1.5, DVec3::Z)));
    }
}

#[test]
fn a_ray_through_an_open_end_hits_the_inside() {
    // It enters at (0, 0, 2) and is at distance 1 from the axis at z = 1.
    let slanted = ray([-1.0, 0.0, 3.0], [1.0, 0.0, -1.0]);
    assert_eq!(hit(&tube(1.0, 1.0, false), slanted), Some((2.0, DVec3::X)));
    assert_eq!(hit(&tube(1.0, 1.0, true), slanted), Some((1.0, DVec3::Z)));
}

#[test]
fn a_cone_is_hit_at_its_side_and_never_at_the_other_nappe() {
    let cone = tube(2.0, 0.0, false);
    let slant = 0.5_f64.sqrt();
    assert_near(&cone, ray([3.0, 0.0, 1.0], [-1.0, 0.0, 0.0]), 2.0, dvec3(slant, 0.0, slant));
    assert_near(&cone, ray([0.0, 0.0, 0.5], [0.0, -1.0, 0.0]), 1.5, dvec3(0.0, -slant, slant));
    // Beyond the apex the same equation describes the other nappe.
    assert_eq!(hit(&cone, ray([3.0, 0.0, 3.0], [-1.0, 0.0, 0.0])), None);
    assert_eq!(hit(&cone, ray([3.0, 0.0, -0.5], [-1.0, 0.0, 0.0])), None);
    // Parallel to the axis at half of the radius: the side is at half of the height.
    assert_near(&cone, ray([1.0, 0.0, -1.0], [0.0, 0.0, 1.0]), 2.0, dvec3(slant, 0.0, slant));
    // Parallel to one side, so that the equation has only one root: the other side, from inside.
    assert_near(&cone, ray([0.0, 0.0, 0.5], [-1.0, 0.0, 1.0]), 0.75, dvec3(-slant, 0.0, slant));
}

#[test]
fn a_ray_through_the_center_of_a_torus_crosses_it_four_times() {
    let torus =
        TestShape::Torus { center: dvec3(1.0, 0.0, 0.0), axis: dvec3(0.0, 2.0, 0.0), major: 2.0, minor: 0.5 };
    // From the left, from inside the tube, from the hole, from inside the tube beyond.
    for (start, x, side) in [(-4.0, -1.5, -1.0), (-1.25, -0.5, 1.0), (1.0, 2.5, -1.0), (3.25, 3.5, 1.0)] {
        assert_near(&torus, ray([start, 0.0, 0.0], [1.0, 0.0, 0.0]), x - start, dvec3(side, 0.0, 0.0));
    }
    let miss =
        |origin, direction| assert_eq!(CORES.map(|core| core.one(&torus, ray(origin, direction))), [None; 2]);
    miss([3.75, 0.0, 0.0], [1.0, 0.0, 0.0]);
    // Through the hole, along the axis and beside it.
    miss([1.0, 4.0, 0.0], [0.0, -1.0, 0.0]);
    miss([2.4, 4.0, 0.0], [0.0, -1.0, 0.0]);
    // On the top of the tube.
    assert_near(&torus, ray([3.0, 4.0, 0.0], [0.0, -1.0, 0.0]), 3.5, DVec3::Y);
    assert_near(&torus, ray([1.0, 0.0, 2.0], [0.0, -1.0, 0.0]), 0.5, -DVec3::Y);
}
