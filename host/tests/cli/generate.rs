//! What `generate` makes.

use std::path::{Path, PathBuf};

use serde_json::Value;
use strahl_scene::description::ShapeDescription;
use strahl_scene::load;

use crate::program::{EMPTY, Folder};

/// Everything that is made, in a size of a few hundred objects, and how many those are.
const SMALL: [(&str, u32, u64); 7] = [
    ("sphereflake", 2, 92),
    ("tetra", 4, 256),
    ("mountain", 3, 132),
    ("rings", 2, 301),
    ("tree", 5, 127),
    ("knot", 216, 216),
    ("stadium", 216, 4844),
];

/// The JSON output of `info` for a file.
fn info(folder: &Folder, name: &str) -> Value {
    serde_json::from_slice(&folder.done(&format!("info {name} --json"))).unwrap()
}

/// The digest of a picture of a file, and the objects in it.
fn rendered(folder: &Folder, name: &str) -> (Value, Value) {
    let report = folder.done(&format!("render {name} -o a.png --size 24x24 --stats json -q"));
    let report: Value = serde_json::from_slice(&report).unwrap();
    (report["digest"].clone(), report["scene"]["objects"].clone())
}

#[test]
fn every_scene_has_its_objects_and_is_the_same_picture_in_nff_and_toml() {
    let folder = Folder::with(EMPTY);
    for (what, size, objects) in SMALL {
        folder.done(&format!("generate {what} --size {size} -o a.nff -q"));
        folder.done(&format!("generate {what} --size {size} -o a.toml -q"));
        let (nff, toml) = (rendered(&folder, "a.nff"), rendered(&folder, "a.toml"));
        assert_eq!(nff.1, objects, "{what}");
        assert_eq!(nff, toml, "{what}");
    }
}

#[test]
fn the_default_is_nff_of_the_usual_size_in_the_current_folder() {
    let folder = Folder::with(EMPTY);
    let ran = folder.run("generate sphereflake");
    assert_eq!(ran.status, Some(0));
    assert!(ran.stderr.starts_with("strahl: sphereflake.nff: 7,382 objects, "), "{}", ran.stderr);
    assert_eq!(info(&folder, "sphereflake.nff")["objects"], 7382);
    assert_eq!(folder.names(), ["scene.nff", "sphereflake.nff"]);
}

#[test]
fn the_default_name_has_the_extension_of_the_format() {
    let folder = Folder::with(EMPTY);
    for (words, names) in [
        ("tree --format nff", &["scene.nff", "tree.nff"][..]),
        ("tree --format toml", &["scene.nff", "tree.nff", "tree.toml"]),
        ("knot --format ply", &["knot.ply", "scene.nff", "tree.nff", "tree.toml"]),
        (
            "tetra --format toml",
            &["knot.ply", "scene.nff", "tetra.ply", "tetra.toml", "tree.nff", "tree.toml"],
        ),
    ] {
        folder.done(&format!("generate {words} --size 1 -q"));
        assert_eq!(folder.names(), names, "{words}");
    }
    assert_eq!(info(&folder, "tree.toml")["objects"], info(&folder, "tree.nff")["objects"]);
    assert_eq!(info(&folder, "tetra.toml")["objects"], 4);
}

#[test]
fn quiet_says_nothing_and_the_databases_names_are_known() {
    let folder = Folder::with(EMPTY);
    for (name, own) in [("balls", "sphereflake.nff"), ("mount", "mountain.nff")] {
        let ran = folder.run(&format!("generate {name} --size 1 --quiet"));
        assert_eq!((ran.status, ran.stdout.len(), ran.stderr.as_str()), (Some(0), 0, ""));
        assert!(!folder.read(own).is_empty());
    }
}

#[test]
fn the_standard_output_gets_the_same_bytes_as_a_file() {
    let folder = Folder::with(EMPTY);
    for (what, words) in [("tree --size 2", ""), ("tree --size 2", "--format toml"), ("knot --size 300", "")]
    {
        let extension = if words.is_empty() { "nff" } else { "toml" };
        folder.done(&format!("generate {what} -o a.{extension} -q"));
        let out = folder.done(&format!("generate {what} {words} -o -"));
        assert_eq!(folder.read(&format!("a.{extension}")), out, "{what} {words}");
    }
    folder.done("generate knot --size 300 -o a.ply -q");
    assert_eq!(folder.done("generate knot --size 300 --format ply -o -"), folder.read("a.ply"));
}

#[test]
fn a_ply_file_has_the_triangles_only() {
    let folder = Folder::with(EMPTY);
    for (what, size, shape, triangles) in
        [("tetra", 3, "triangle", 64), ("mountain", 2, "triangle", 32), ("knot", 301, "smooth triangle", 306)]
    {
        folder.done(&format!("generate {what} --size {size} -o a.ply -q"));
        assert_eq!(info(&folder, "a.ply")["by_shape"], serde_json::json!({ shape: triangles }), "{what}");
    }
}

#[test]
fn the_mesh_of_a_scene_in_toml_is_in_a_file_beside_it() {
    let folder = Folder::with(EMPTY);
    let ran = folder.run("generate knot --size 301 -o my.toml");
    assert!(ran.stderr.starts_with("strahl: my.toml and my.ply: 306 objects, "), "{}", ran.stderr);
    assert_eq!(folder.names(), ["my.ply", "my.toml", "scene.nff"]);
    assert!(String::from_utf8(folder.read("my.toml")).unwrap().contains("file = \"my.ply\""));
    assert_eq!(info(&folder, "my.toml")["objects"], 306);
}

#[test]
fn objects_without_a_head_make_a_scene_together_with_one() {
    let folder = Folder::with(EMPTY);
    for (extension, head) in [("nff", EMPTY), ("toml", "background = { color = \"ivory\" }\n")] {
        let objects = folder.done(&format!("generate sphereflake --size 1 --bare --format {extension} -o -"));
        let name = format!("a.{extension}");
        folder.write(&name, [head.as_bytes(), &objects].concat());
        let it = info(&folder, &name);
        assert_eq!((&it["objects"], &it["lights"]), (&11.into(), &u64::from(extension == "toml").into()));
    }
}

#[test]
fn what_cannot_be_made_is_reported_and_nothing_is_written() {
    let folder = Folder::with(EMPTY);
    for (words, says) in [
        ("generate", "<WHAT>"),
        ("generate cube", "[possible values: sphereflake,"),
        ("generate tetra --size 0", "strahl: tetra: the size must be 1 or more\n"),
        ("generate tetra --size -1", "-1"),
        ("generate tetra --size 2.5", "2.5"),
        (
            "generate sphereflake --size 8",
            "sphereflake: size 8 has 48,427,562 objects; the limit is 16,777,216, which is size 7",
        ),
        ("generate tree --size 4000000000", "has more than 2^64 objects"),
        ("generate tree -o tree.obj", "tree.obj does not end in .nff, .toml or .ply"),
        ("generate tree -o tree", "use --format"),
        ("generate tree -o tree.ply", "tree has shapes other than triangles, which PLY cannot store"),
        ("generate knot --format toml -o -", "name an output file, or use --format nff"),
    ] {
        folder.run(words).failed(2, says);
        assert_eq!(folder.names(), ["scene.nff"], "{words}");
    }
    folder.run("generate tree -o no/tree.nff").failed(74, "folder no does not exist");
}

/// The databases, when they lie beside the project.
fn databases() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/spd");
    folder.is_dir().then_some(folder)
}

#[test]
fn the_scenes_of_the_databases_are_theirs_object_by_object() {
    let Some(databases) = databases() else { return };
    let folder = Folder::with(EMPTY);
    for (what, theirs) in [("sphereflake", "balls"), ("tetra", "tetra"), ("rings", "rings"), ("tree", "tree")]
    {
        folder.done(&format!("generate {what} -o a.nff -q"));
        let ours = load(&folder.path("a.nff")).unwrap();
        let theirs = load(&databases.join(theirs).with_extension("nff")).unwrap();
        // They are written with six digits, as the view is.
        let near = |a: f32, b: f32| (a - b).abs() <= 6e-6 * (1.0 + b.abs());
        let all_near = |a: &[f32], b: &[f32]| a.iter().zip(b).all(|(a, b)| near(*a, *b));
        assert_eq!(ours.objects.len(), theirs.objects.len(), "{what}");
        assert!(
            all_near(&ours.camera.from, &theirs.camera.from) && all_near(&ours.camera.at, &theirs.camera.at)
        );
        assert_eq!((ours.lights.len(), ours.ambient), (theirs.lights.len(), theirs.ambient));
        assert_eq!(ours.materials.len(), theirs.materials.len());
        for (place, (a, b)) in ours.objects.iter().zip(&theirs.objects).enumerate() {
            let same = match (a.shape, b.shape) {
                (
                    ShapeDescription::Sphere { center: a, radius: r },
                    ShapeDescription::Sphere { center: b, radius: s },
                ) => all_near(&a, &b) && near(r, s),
                (
                    ShapeDescription::Cone { base, base_radius, end, end_radius, capped },
                    ShapeDescription::Cone { base: b, base_radius: br, end: e, end_radius: er, capped: c },
                ) => {
                    let radii = near(base_radius, br) && near(end_radius, er);
                    all_near(&base, &b) && all_near(&end, &e) && radii && capped == c
                }
                (a, b) => a == b,
            };
            assert!(same && a.material == b.material, "{what}, object {place}: {a:?} and {b:?}");
        }
        assert_eq!(ours.vertices.len(), theirs.vertices.len());
        for (a, b) in ours.vertices.iter().zip(&theirs.vertices) {
            // The wall of rings is 21 wide, and its exact size is not documented.
            let far = a.iter().any(|x| x.abs() > 5.0);
            assert!(all_near(a, b) || far && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-4), "{what}");
        }
    }
}
