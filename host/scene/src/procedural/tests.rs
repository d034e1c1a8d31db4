use glam::{DVec3, dvec3};
use writer::{rotate_from_z, to_float3};

use super::*;

#[test]
fn the_sizes_of_the_databases_have_their_counts() {
    let counts = [
        (ProceduralScene::Sphereflake, 7382),
        (ProceduralScene::Tetra, 4096),
        (ProceduralScene::Mountain, 8196),
        (ProceduralScene::Rings, 8401),
        (ProceduralScene::Tree, 8191),
    ];
    for (scene, count) in counts {
        assert_eq!(scene.objects(scene.default_size()), Some(count), "{scene}");
    }
}

#[test]
fn a_knot_has_the_requested_number_of_triangles_or_few_more() {
    for requested in [1, 100, 215, 216, 217, 1000, 9_999, 10_000, 500_000, 1_000_000, 1_000_003, 16_000_000] {
        let knot = knot::TorusKnot::of(requested);
        let has = knot.triangles();
        // At most one ring of squares more, and the minimum of a knot.
        let most = requested.max(216) as f64 * 1.002 + 60.0;
        assert!(has >= requested && f64::from(has) <= most, "{has} for {requested}");
    }
}

#[test]
fn a_mesh_is_closed_and_its_front_faces_outward() {
    for scene in [ProceduralScene::Tetra, ProceduralScene::Knot] {
        let mesh = scene.mesh(if scene == ProceduralScene::Knot { 3000 } else { 3 }).unwrap();
        let mut edges = std::collections::BTreeSet::new();
        let mut volume = 0.0;
        for triangle in 0..mesh.triangles() {
            let corners = mesh.triangle(triangle);
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                assert!(
                    edges.insert((corners[a], corners[b])),
                    "{scene}: an edge is used twice in one direction"
                );
            }
            let [a, b, c] = corners.map(|corner| mesh.point(corner).0);
            volume += a.dot(b.cross(c)) / 6.0;
        }
        assert!(edges.iter().all(|(a, b)| edges.contains(&(*b, *a))), "{scene}: an edge has one side only");
        assert!(volume > 0.0, "{scene}: {volume}");
    }
}

#[test]
fn the_volume_of_the_pyramid_halves_with_every_size() {
    // One tetrahedron in a cube of side two is a third of it.
    for (size, expected) in [(1, 8.0 / 3.0), (2, 4.0 / 3.0), (5, 1.0 / 6.0)] {
        let mesh = tetra::TetrahedronPyramid::of(size);
        let volume: f64 = (0..mesh.triangles())
            .map(|triangle| {
                let [a, b, c] = mesh.triangle(triangle).map(|corner| mesh.point(corner).0);
                a.dot(b.cross(c)) / 6.0
            })
            .sum();
        assert!((volume - expected).abs() < 1e-12, "{size}: {volume}");
    }
}

#[test]
fn the_normals_of_a_knot_are_perpendicular_to_its_triangles() {
    let knot = knot::TorusKnot::of(200_000);
    for triangle in (0..knot.triangles()).step_by(997) {
        let [a, b, c] = knot.triangle(triangle).map(|corner| knot.point(corner));
        let face_normal = (b.0 - a.0).cross(c.0 - a.0);
        let cosine = face_normal.dot(a.1.unwrap()) / face_normal.dot(face_normal).sqrt();
        // The normal of a triangle differs from a vertex normal by about one step around the tube.
        assert!(cosine > 0.995, "{triangle}: {cosine}");
    }
}

#[test]
fn a_larger_terrain_contains_the_points_of_a_smaller_one() {
    let (small, large) = (mountain::FractalTerrain::of(3), mountain::FractalTerrain::of(5));
    for y in 0..=8 {
        for x in 0..=8 {
            let (position, finer) = (small.point(y * 9 + x).0, large.point(4 * (y * 33 + x)).0);
            assert_eq!(to_float3(position), to_float3(finer));
        }
    }
}

#[test]
fn the_rotation_from_z_is_orthogonal_and_reaches_its_target() {
    let z = dvec3(0.0, 0.0, 1.0);
    for toward in [z, -z, dvec3(1.0, 0.0, 0.0), dvec3(0.6, -0.8, 0.0), dvec3(2.0, 3.0, -6.0) / 7.0] {
        assert!((rotate_from_z(toward, z) - toward).abs().max_element() < 1e-12, "{toward}");
        let v = dvec3(0.3, -0.4, 1.2);
        let rotated = rotate_from_z(toward, v);
        assert!((rotated.dot(rotated) - v.dot(v)).abs() < 1e-12);
        assert!((rotated.dot(toward) - v.z).abs() < 1e-12);
    }
}

#[test]
fn rounded_points_have_no_negative_zero() {
    let signs = to_float3(dvec3(-0.0, -1e-17, 1e-17)).map(|x| x.is_sign_negative());
    assert_eq!(signs, [false; 3]);
    assert_eq!(to_float3(DVec3::ONE * -0.1), [-0.1; 3]);
}
