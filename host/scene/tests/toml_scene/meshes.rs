//! Meshes in scenes.

use std::path::Path;

use strahl_core::Rgb;
use strahl_scene::LoadError;
use strahl_scene::description::{LoadedScene, ShapeDescription};

use crate::text::load_in;

const MODEL: &str =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nusemtl red\nf 1 2 3\nf 1 3 4\nusemtl none\nf 1 2 4\n";
const MATERIALS: &str = "newmtl red\nKd 1 0 0\nnewmtl none\nKd 0 0 1\n";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("sub")).unwrap();
    std::fs::write(folder.path().join("sub/m.obj"), MODEL).unwrap();
    std::fs::write(folder.path().join("sub/m.mtl"), MATERIALS).unwrap();
    folder
}

fn loaded(folder: &Path, text: &str) -> LoadedScene {
    let it = load_in(folder, text.as_bytes()).unwrap_or_else(|failure| panic!("{failure}\n{text}"));
    assert!(strahl_session::tables::single::scene_tables(&it).scene().is_ok(), "{text}");
    assert!(strahl_session::tables::double::scene_tables(&it).scene().is_ok(), "{text}");
    it
}

#[test]
fn a_mesh_is_numbered_among_the_objects_with_its_own_materials() {
    let folder = folder();
    let it = loaded(
        folder.path(),
        "[[sphere]]\nradius = 1\n[[mesh]]\nfile = \"sub/m.obj\"\n[[triangle]]\ncorners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n",
    );
    let forms: Vec<_> = it.objects.iter().map(|object| (object.shape, object.line)).collect();
    assert!(matches!(forms[0], (ShapeDescription::Sphere { .. }, 1)));
    assert_eq!(forms[1], (ShapeDescription::Mesh { first: 0, count: 2, smooth: false }, 3));
    assert_eq!(forms[2], (ShapeDescription::Mesh { first: 2, count: 1, smooth: false }, 3));
    assert!(matches!(forms[3], (ShapeDescription::Triangle { .. }, 5)));
    let red = &it.materials[usize::from(it.objects[1].material)];
    assert_eq!((red.name.as_deref(), red.value.diffuse), (Some("red"), Rgb::new(1.0, 0.0, 0.0)));
}

#[test]
fn a_mesh_is_scaled_then_rotated_then_translated() {
    let folder = folder();
    let it = loaded(
        folder.path(),
        "[[mesh]]\nfile = \"sub/m.obj\"\nmaterial = { mirror = 1 }\nscale = [2, 1, 1]\nrotate = [0, 0, 90]\ntranslate = [5, 0, 0]\n",
    );
    let corners = it.triangles[0].map(|corner| it.vertices[corner as usize]);
    assert_eq!(corners, [[5.0, 0.0, 0.0], [5.0, 2.0, 0.0], [3.0, 0.0, 0.0]]);
    assert!(
        it.objects
            .iter()
            .all(|object| it.materials[usize::from(object.material)].value.reflection == Rgb::WHITE)
    );
}

#[test]
fn a_mirrored_mesh_keeps_its_front_faces() {
    let folder = folder();
    let plain = loaded(folder.path(), "[[mesh]]\nfile = \"sub/m.obj\"\n");
    let mirrored = loaded(folder.path(), "[[mesh]]\nfile = \"sub/m.obj\"\nscale = [1, 1, -1]\n");
    let [a, b, c] = plain.triangles[1];
    assert_eq!(mirrored.triangles[1], [a, c, b]);
    assert_eq!(mirrored.vertices[3], [0.0, 0.0, -3.0]);
}

#[test]
fn normals_stay_perpendicular_under_a_nonuniform_scale() {
    let folder = folder();
    let slope = "v 0 0 0\nv 1 1 0\nv 0 0 1\nvn -1 1 0\nf 1//1 3//1 2//1\n";
    std::fs::write(folder.path().join("slope.obj"), slope).unwrap();
    let it =
        loaded(folder.path(), "[[sphere]]\nradius = 1\n[[mesh]]\nfile = \"slope.obj\"\nscale = [2, 1, 1]\n");
    assert!(matches!(it.objects[1].shape, ShapeDescription::Mesh { smooth: true, .. }));
    let normal = it.normals[it.triangles[0][0] as usize];
    assert_eq!(normal, [-0.5, 1.0, 0.0]);
}

#[test]
fn a_scene_may_use_a_mesh_file_many_times() {
    let folder = folder();
    let one = "[[mesh]]\nfile = \"sub/m.obj\"\n";
    let it = loaded(folder.path(), &format!("{one}translate = [1, 0, 0]\n{one}translate = [2, 0, 0]\n"));
    assert_eq!((it.vertices.len(), it.triangles.len(), it.objects.len()), (2 * 4, 2 * 3, 2 * 2));
    assert_eq!(it.vertices[it.triangles[3][0] as usize], [2.0, 0.0, 0.0]);
}

#[test]
fn errors_of_a_mesh_file_are_reported_at_its_name() {
    let folder = folder();
    std::fs::write(folder.path().join("bad.obj"), "v 0 0 0\nv 1 x 0\n").unwrap();
    for (text, line, expected_text) in [
        ("[[mesh]]\nfile = \"bad.obj\"\n", 2, "bad.obj:2:"),
        ("[[mesh]]\nfile = \"gone.ply\"\n", 2, "gone.ply"),
        ("[[mesh]]\nfile = \"sub\"\n", 2, "not a regular file"),
        ("[[mesh]]\nfile = \"sub/m.obj\"\nscale = 0\n", 3, "must not be 0"),
        ("[[mesh]]\nfile = \"sub/m.obj\"\nscale = [1, 0, 1]\n", 3, "must not be 0"),
        ("[[mesh]]\nfile = \"sub/m.obj\"\nscale = 1e15\n", 1, "beyond 1e15"),
        ("[[mesh]]\nfile = \"sub/m.obj\"\nmaterial = \"gold\"\n", 3, "unknown material `gold`"),
    ] {
        let Err(LoadError::Diagnostics(diagnostics)) = load_in(folder.path(), text.as_bytes()) else {
            panic!("{text}")
        };
        assert_eq!(diagnostics.list().len(), 1, "{diagnostics}");
        assert_eq!(diagnostics.line_and_column(&diagnostics.list()[0]).0, line, "{diagnostics}");
        assert!(diagnostics.list()[0].message.contains(expected_text), "{diagnostics}");
    }
}

#[test]
fn translation_is_an_alias_of_translate() {
    let folder = folder();
    let mesh =
        |key: &str| loaded(folder.path(), &format!("[[mesh]]\nfile = \"sub/m.obj\"\n{key} = [1, 2, 3]\n"));
    assert_eq!(mesh("translation"), mesh("translate"));
}
