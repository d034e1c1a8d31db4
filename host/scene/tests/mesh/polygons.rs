//! Triangulations cover their polygons.

use crate::files::mesh;
use crate::random::Random;

/// A mesh of one face with these vertices, read as OBJ.
fn face(corners: &[[f64; 3]]) -> strahl_scene::mesh::TriangleMesh {
    let mut text: String = corners.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
    text.push('f');
    (1..=corners.len()).for_each(|i| text.push_str(&format!(" {i}")));
    mesh("obj", text)
}

/// Twice the signed area of a triangle in the xy plane; positive if it is counterclockwise.
fn turn([a, b, c]: [[f32; 3]; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| [f64::from(p[0]), f64::from(p[1])]);
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Checks that all triangles have the orientation of the polygon, and together its area: then they cover it without
/// overlaps.
fn assert_covers(corners: &[[f64; 3]]) {
    let it = face(corners);
    assert_eq!(it.triangles.len(), corners.len() - 2, "{corners:?}");
    let area: f64 = (0..corners.len())
        .map(|i| (corners[i], corners[(i + 1) % corners.len()]))
        .map(|(p, q)| p[0] * q[1] - p[1] * q[0])
        .sum();
    let turns = it.triangles.iter().map(|t| turn(t.map(|i| it.vertices[i as usize])) * area.signum());
    let turns: Vec<f64> = turns.collect();
    assert!(turns.iter().all(|turn| *turn >= 0.0), "{turns:?}\n{corners:?}");
    // Vertices are rounded to single precision: about 1e-7 of sides below 100.
    assert!((turns.iter().sum::<f64>() - area.abs()).abs() <= 1e-3, "{corners:?}");
    assert_eq!(it.warnings, [""; 0], "{corners:?}");
}

fn flat(corners: &[[f64; 2]]) -> Vec<[f64; 3]> {
    corners.iter().map(|[x, y]| [*x, *y, 0.0]).collect()
}

#[test]
fn concave_polygons_are_covered_by_their_triangles() {
    let arrow = flat(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [3.0, 1.0]]);
    let bay = flat(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]]);
    let comb: Vec<_> = (0..40).map(|i| [f64::from(i), f64::from(i % 2) * 5.0]).collect();
    let comb = flat(&[comb, vec![[39.0, -1.0], [0.0, -1.0]]].concat());
    // A ring with a bridge to its hole: two vertices occur twice.
    let ring = flat(&[
        [0.0, 0.0],
        [6.0, 0.0],
        [6.0, 6.0],
        [0.0, 6.0],
        [0.0, 0.0],
        [2.0, 2.0],
        [2.0, 4.0],
        [4.0, 4.0],
        [4.0, 2.0],
        [2.0, 2.0],
    ]);
    let straight =
        flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0], [0.0, 1.0]]);
    for polygon in [arrow, bay, comb, ring, straight] {
        // From every vertex, in both directions, and tilted so that another projection plane is used.
        for start in 0..polygon.len() {
            let mut turned = polygon.clone();
            turned.rotate_left(start);
            assert_covers(&turned);
            turned.iter_mut().for_each(|corner| corner[2] = corner[0] * 7.0);
            assert_covers(&turned);
            turned.reverse();
            assert_covers(&turned);
        }
    }
}

#[test]
fn stars_of_random_lengths_are_covered_by_their_triangles() {
    let mut random = Random(1975);
    for _ in 0..300 {
        let n = 4 + random.below(60);
        let corner = |i: usize, random: &mut Random| {
            let (angle, length) =
                (std::f64::consts::TAU * i as f64 / n as f64, 1.0 + random.below(900) as f64 / 100.0);
            [angle.cos() * length, angle.sin() * length, 0.0]
        };
        let polygon: Vec<_> = (0..n).map(|i| corner(i, &mut random)).collect();
        assert_covers(&polygon);
    }
}

#[test]
fn convex_polygons_are_fans() {
    let it = face(&flat(&[[0.0, 0.0], [2.0, 0.0], [3.0, 1.0], [2.0, 2.0], [0.0, 2.0]]));
    assert_eq!(it.triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
}

#[test]
fn self_intersecting_and_zero_area_polygons_are_triangulated() {
    for corners in [
        flat(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]),
        flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [1.5, 0.0]]),
        flat(&[[1.0, 1.0]; 9]),
    ] {
        let it = face(&corners);
        assert_eq!(it.triangles.len(), corners.len() - 2);
        assert!(it.warnings.iter().any(|w| w.starts_with("self-intersecting or zero-area polygons")));
    }
}

#[test]
fn a_polygon_with_very_many_vertices_is_triangulated_in_bounded_time() {
    // A saw with more teeth than the maximum number of tests.
    let n = 20_000;
    let saw: Vec<_> = (0..n).map(|i| [f64::from(i), f64::from(i % 2) * 5.0, 0.0]).collect();
    let clock = std::time::Instant::now();
    assert_eq!(
        face(&[saw, vec![[f64::from(n), -9.0, 0.0], [0.0, -9.0, 0.0]]].concat()).triangles.len(),
        20_000
    );
    assert!(clock.elapsed().as_secs() < 20);
}
