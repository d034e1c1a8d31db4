//! Output of `info`.

use serde_json::{Value, json};

use crate::program::{BALL, EMPTY, Folder};

const EFFECTS: [&str; 8] =
    ["shadows", "reflection", "transmission", "colored-shadows", "penumbra", "lens", "gloss", "motion"];

/// A scene that asks for every effect, and for each but the last by one thing alone.
const ALL: &str = "\
[camera]
from = [0, 2, 8]
at = [0, 0, 0]
lens_radius = 0.1
[render]
size = [16, 12]
colored_shadows = true
[[sphere_light]]
name = \"lamp\"
position = [2, 5, 3]
radius = 0.5
[[sphere]]
radius = 1
velocity = [0.5, 0, 0]
material = { transmission = 0.9 }
[[plane]]
point = [0, -1, 0]
material = { mirror = 0.5, roughness = 0.3 }
";

#[test]
fn every_effect_is_reported_with_its_line_and_can_be_disabled() {
    let folder = Folder::with(EMPTY);
    folder.write("all.toml", ALL);
    let it: Value = serde_json::from_slice(&folder.done("info all.toml --json")).unwrap();
    let reasons = [
        "light `lamp` (line 8)",
        "material (line 18) on 1 object",
        "material (line 15) on 1 object",
        "render (line 7)",
        "light `lamp` (line 8)",
        "camera (line 1)",
        "material (line 18) on 1 object",
        "sphere (line 12)",
    ];
    let plan: Vec<Value> = EFFECTS
        .iter()
        .zip(reasons)
        .map(|(effect, reason)| json!({ "effect": effect, "asked_by": [reason] }))
        .collect();
    assert_eq!(it["plan"], Value::Array(plan));

    let report = |words: &str| -> Value {
        let words = format!("render all.toml -q -o all.png --stats json {words}");
        serde_json::from_slice(&folder.done(&words)).unwrap()
    };
    let all = report("");
    assert_eq!(all["scene"]["effects"], json!(EFFECTS));
    for effect in EFFECTS {
        let it = report(&format!("--without {effect}"));
        let simulated: Vec<&str> =
            it["scene"]["effects"].as_array().unwrap().iter().map(|e| e.as_str().unwrap()).collect();
        assert!(!simulated.contains(&effect), "{effect}");
        let left_out = it["plan"].as_array().unwrap().iter().find(|step| step["simulated"] == false).unwrap();
        assert_eq!(left_out["effect"], effect);
        assert_ne!(it["digest"], all["digest"], "without {effect} it is the same");
    }
    let none = report(&format!("--without {}", EFFECTS.join(",")));
    assert_eq!(none["scene"]["effects"], json!([]));
    for kind in ["reflected", "transmitted", "shadow"] {
        assert_eq!(none["rays"][kind], 0);
    }
    let cut = report("--levels 1")["cut"]["share_by_levels"].as_f64().unwrap();
    assert!(cut > 0.1 && cut < 1.0, "{cut}");

    let said = folder.run("render all.toml -o all.png --without gloss,lens");
    let text = said.stderr;
    for said in ["  disabled  gloss: material (line 18) on 1 object\n", "  disabled  lens: camera (line 1)\n"]
    {
        assert!(text.contains(said), "`{said}` is not in\n{text}");
    }
    folder.run("render all.toml --without glass").failed(2, "colored-shadows");
}

#[test]
fn a_scene_is_reported_with_everything_that_requires_an_effect() {
    let folder = Folder::with(BALL);
    let it: Value = serde_json::from_slice(&folder.done("info scene.nff --json")).unwrap();
    assert_eq!(it["objects"], 3);
    assert_eq!(it["by_shape"], json!({ "sphere": 2, "triangle": 1 }));
    assert_eq!((&it["lights"], &it["materials"], &it["textures"]), (&json!(2), &json!(2), &json!(0)));
    let step = |effect: &str, asked_by: &[&str]| json!({ "effect": effect, "asked_by": asked_by });
    assert_eq!(
        it["plan"],
        json!([
            step("shadows", &["light (line 3)", "light (line 4)"]),
            step("reflection", &["material (line 5) on 1 object"]),
            step("transmission", &["material (line 7) on 2 objects"]),
        ])
    );
    assert_eq!(it["not_called_for"], json!(["colored-shadows", "penumbra", "lens", "gloss", "motion"]));
    assert_eq!(folder.names(), ["scene.nff"], "nothing is written");
}

#[test]
fn the_bounds_hold_everything_and_little_more() {
    let folder = Folder::with(&format!("{EMPTY}f 1 1 1 1 0 0 0 0\ns 1 2 3 0.5\n"));
    let it: Value = serde_json::from_slice(&folder.done("info scene.nff --json")).unwrap();
    for (end, sign) in [(0, -1.0), (1, 1.0)] {
        for (axis, center) in [1.0, 2.0, 3.0].into_iter().enumerate() {
            let extent = sign * (it["bounds"][end][axis].as_f64().unwrap() - center);
            assert!((0.5..0.500_001).contains(&extent), "{extent}");
        }
    }
}

#[test]
fn an_empty_scene_has_no_bounds_and_requires_no_effect() {
    let folder = Folder::with(EMPTY);
    let it: Value = serde_json::from_slice(&folder.done("info scene.nff --json")).unwrap();
    assert_eq!((&it["objects"], &it["bounds"], &it["plan"]), (&json!(0), &Value::Null, &json!([])));
    assert_eq!(it["not_called_for"], json!(EFFECTS));
}

#[test]
fn every_accelerator_is_reported_with_what_it_takes_and_how_it_is_cut() {
    let mut scene = EMPTY.to_owned() + "f 1 1 1 1 0 0 0 0\n";
    for i in 0..1000 {
        scene += &format!("s {} {} {} 0.25\n", i % 10, i / 10 % 10, i / 100);
    }
    let folder = Folder::with(&scene);
    let it: Value = serde_json::from_slice(&folder.done("info scene.nff --json")).unwrap();
    let accelerators = it["memory"]["accelerators"].as_array().unwrap();
    let kinds: Vec<_> = accelerators.iter().map(|it| it["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["list", "grid", "octree", "bvh"]);
    for it in accelerators {
        assert!(it["bytes"].as_u64().unwrap() > 4 * 1000, "{it}");
        assert!(it["build_seconds"].as_f64().unwrap() > 0.0, "{it}");
        let items = it["items_per_region"].as_f64().unwrap() * it["regions"].as_f64().unwrap();
        assert!(items >= 999.5, "every item is in some region: {it}");
        assert_eq!(
            it["depth"].is_number(),
            ["octree", "bvh"].contains(&it["kind"].as_str().unwrap()),
            "{it}"
        );
    }
    // 1000 items in groups of 16; at most eight in a leaf, four parts to a node.
    assert_eq!(accelerators[0]["regions"], 63);
    assert!((125..=1000).contains(&accelerators[3]["regions"].as_u64().unwrap()), "{it:#}");
    assert!((4..=64).contains(&accelerators[3]["depth"].as_u64().unwrap()), "{it:#}");
    assert_eq!(it["auto"]["kind"], "bvh");
    let text = String::from_utf8(folder.done("info scene.nff")).unwrap();
    for kind in kinds {
        assert!(
            text.lines().any(|line| line.contains(&format!(" {kind} ")) && line.contains(" regions of ")),
            "{text}"
        );
    }
    assert!(text.contains("auto selects bvh: "), "{text}");
}

#[test]
fn the_text_has_the_same_contents() {
    let folder = Folder::with(BALL);
    let text = String::from_utf8(folder.done("info scene.nff")).unwrap();
    for said in
        ["scene.nff\n", "2 spheres\n", "shadows\n", "  light (line 3)\n", "material (line 7) on 2 objects\n"]
    {
        assert!(text.contains(said), "`{said}` is not in\n{text}");
    }
}

#[test]
fn a_wrong_scene_has_no_contents() {
    let folder = Folder::with("v from");
    folder.run("info scene.nff").failed(65, "scene.nff:1: ");
    folder.run("info missing.nff").failed(66, "missing.nff");
}
