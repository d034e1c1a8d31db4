//! The default camera of a mesh file.

use strahl_core::{Camera, Resolution};
use strahl_scene::LoadError;
use strahl_scene::description::{LoadedScene, ObjectDescription, ProjectionDescription, ShapeDescription};
use strahl_scene::load_for_size;
use strahl_session::tables::single;

use crate::files::{Folder, PLAIN, SQUARE_OBJ, SQUARE_PLY, gltf_of};
use crate::random::Random;

fn scene(name: &str, text: &str, size: Resolution) -> LoadedScene {
    let folder = Folder::of(&[(name, text.as_bytes())]);
    load_for_size(&folder.path(name), size).unwrap_or_else(|failure| panic!("{failure}\n{text}"))
}

const WIDE: Resolution = Resolution::new(640, 480).unwrap();

#[test]
fn the_objects_of_the_scene_are_the_triangles_of_the_file() {
    let it = scene("a.obj", &format!("{SQUARE_OBJ}usemtl x\nf 1 2 3\n"), WIDE);
    let form = ShapeDescription::Mesh { first: 0, count: 3, smooth: false };
    assert_eq!(it.objects, [ObjectDescription { shape: form, material: 0, line: 0 }]);
    assert_eq!((it.materials.len(), it.vertices.len(), it.triangles.len()), (1, 4, 3));
    assert!(it.lights.len() >= 2 && it.settings.size.is_none());
    assert_eq!(single::scene_tables(&it).scene().unwrap().descriptor().geometry.shapes.len(), 3);
}

#[test]
fn only_normals_of_the_file_make_it_smooth() {
    let text = gltf_of(&PLAIN.replace("\"POSITION\":0", "\"POSITION\":0,\"NORMAL\":1"));
    let smooth =
        |it: &LoadedScene| matches!(it.objects[0].shape, ShapeDescription::Mesh { smooth: true, .. });
    assert!(smooth(&scene("a.gltf", &text, WIDE)));
    assert!(!smooth(&scene("a.gltf", &gltf_of(PLAIN), WIDE)));
}

#[test]
fn y_is_up_except_in_ply_files() {
    assert_eq!(scene("a.obj", SQUARE_OBJ, WIDE).camera.up, [0.0, 1.0, 0.0]);
    assert_eq!(scene("a.gltf", &gltf_of(PLAIN), WIDE).camera.up, [0.0, 1.0, 0.0]);
    let flat = scene("a.ply", SQUARE_PLY, WIDE).camera;
    assert_eq!(flat.up, [0.0, 0.0, 1.0]);
    // A flat model is viewed from higher up.
    let rise = |view: strahl_scene::description::CameraDescription| {
        let way = [0, 1, 2].map(|i| view.from[i] - view.at[i]);
        f64::from(way[2]) / way.iter().map(|x| f64::from(x * x)).sum::<f64>().sqrt()
    };
    assert!(rise(flat) > 0.6);
    assert!(rise(scene("a.ply", &SQUARE_PLY.replace("1 1 0", "1 1 1"), WIDE).camera) < 0.4);
}

/// The position of a point in the picture, in [-1, 1] along both sides.
fn place(it: &LoadedScene, size: Resolution, point: [f32; 3]) -> [f64; 2] {
    let ProjectionDescription::Perspective(angle) = it.camera.projection else { panic!() };
    let minus = |a: [f32; 3], b: [f32; 3]| [0, 1, 2].map(|i| f64::from(a[i]) - f64::from(b[i]));
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let unit = |a: [f64; 3]| a.map(|x| x / dot(a, a).sqrt());
    let ahead = unit(minus(it.camera.at, it.camera.from));
    let right = unit(cross(ahead, it.camera.up.map(f64::from)));
    let way = minus(point, it.camera.from);
    let depth = dot(way, ahead) * (f64::from(angle).to_radians() / 2.0).tan();
    assert!(depth > 0.0);
    let aspect = f64::from(size.width()) / f64::from(size.height());
    [dot(way, right) / depth / aspect, dot(way, cross(right, ahead)) / depth]
}

#[test]
fn the_whole_model_is_in_the_picture_and_fills_it() {
    let mut random = Random(7);
    for (w, h) in [(640, 480), (100, 700), (700, 100), (1, 1), (33, 1)] {
        let size = Resolution::new(w, h).unwrap();
        for scale in [1e-9_f32, 1.0, 1e9] {
            for _ in 0..20 {
                let stretch = [0, 1, 2].map(|_| scale * (1.0 + random.below(20) as f32));
                let mut text = String::new();
                for _ in 0..12 {
                    let [x, y, z] = stretch.map(|s| s * random.coordinate());
                    text.push_str(&format!("v {x} {y} {z}\n"));
                }
                text.push_str("f 1 2 3\nf 4 5 6\nf 7 8 9\nf 10 11 12\n");
                let it = scene("a.obj", &text, size);
                assert!(Camera::new(&single::camera_descriptor(&it.camera), size).is_ok());
                let places: Vec<_> = it.vertices.iter().map(|p| place(&it, size, *p)).collect();
                let most = |side: usize| places.iter().map(|p| p[side].abs()).fold(0.0, f64::max);
                // 0.92 of the picture, and the rounding of the view to single precision.
                assert!(most(0) <= 0.925 && most(1) <= 0.925, "{w} x {h}: {places:?}");
                assert!((most(0).max(most(1)) - 0.92).abs() < 0.005, "{w} x {h}: {places:?}");
            }
        }
    }
}

#[test]
fn a_model_without_a_possible_camera_is_rejected() {
    let folder = Folder::of(&[
        ("point.obj", b"v 1 1 1\nf 1 1 1\n"),
        ("far.obj", b"v 1e15 0 0\nv -1e15 1 0\nv 0 1e15 0\nf 1 2 3\n"),
        ("away.obj", b"v 1e12 1e12 0\nv 1e12 1e12 1e-3\nv 1e12 1e12 2e-3\nf 1 2 3\n"),
    ]);
    for (name, expected) in [
        ("point.obj", "all vertices are the same point"),
        ("far.obj", "too large or too far away"),
        ("away.obj", "too small compared with its distance from the origin"),
    ] {
        let failure = load_for_size(&folder.path(name), WIDE).unwrap_err();
        assert!(matches!(failure, LoadError::Invalid { .. } | LoadError::Diagnostics(_)));
        assert!(failure.to_string().contains(expected), "{failure}");
    }
}
