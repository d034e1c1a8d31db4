//! The tree of rays of one pixel.

use crate::program::{BALL, Folder};

const SCENE: &str = "\
ambient_light = { color = 0.1 }
background = { color = 0.5 }

[[point_light]]
position = [0, 9, 9]

[[sphere]]
radius = 1
material = { color = \"red\", mirror = 0.5 }

[[plane]]
point = [0, -1, 0]
material = { color = \"white\" }

[camera]
from = [0, 1, 6]
at = [0, 0, 0]

[render]
size = [24, 16]
";

fn folder() -> Folder {
    let folder = Folder::with(BALL);
    folder.write("scene.toml", SCENE);
    folder
}

fn explained(folder: &Folder, words: &str) -> String {
    String::from_utf8(folder.done(&format!("explain {words}"))).unwrap()
}

#[test]
fn a_pixel_is_reported_with_lines_lights_and_what_was_cut() {
    let folder = folder();
    let text = explained(&folder, "scene.toml 12,8");
    for part in [
        "scene.toml: pixel 12,8 of 24x16",
        "camera ray 1, level 1, weight 1",
        "hits sphere (line 7)",
        "light (line 4): ",
        "└─ reflected ray 2, level 2, weight 0.5",
        "the pixel is this sample: ",
    ] {
        assert!(text.contains(part), "`{part}` is missing in {text}");
    }
    let text = explained(&folder, "scene.toml 12,8 --levels 1");
    assert!(text.contains("reflected ray not traced, weight 0.5: last level reached"), "{text}");
    let text = explained(&folder, "scene.toml 12,8 --cutoff 0.5");
    assert!(text.contains("weight is not above the cutoff"), "{text}");
    assert!(!explained(&folder, "scene.toml 12,8 --without reflection").contains("reflected ray"));
}

#[test]
fn one_of_several_samples_can_be_printed() {
    let folder = folder();
    let text = explained(&folder, "scene.toml 12,8 --sampler regular:2");
    assert!(text.contains("sample 4 of 4") && text.contains("samples times 0.25"), "{text}");
    let text = explained(&folder, "scene.toml 12,8 --sampler regular:2 --sample 2");
    assert!(text.contains("sample 2 of 4") && !text.contains("sample 1 of 4"), "{text}");
    let beyond = folder.run("explain scene.toml 12,8 --sampler regular:2 --sample 5");
    beyond.failed(2, "sample 5 does not exist: the pixel has 4");
}

#[test]
fn the_tree_becomes_json_and_a_picture() {
    let folder = folder();
    let json: serde_json::Value =
        serde_json::from_str(&explained(&folder, "scene.toml 12,8 --json --svg tree.svg")).unwrap();
    assert_eq!(json["version"], 1);
    assert_eq!(json["samples"][0]["rays"][0]["hit"]["line"], 7);
    let svg = String::from_utf8(folder.read("tree.svg")).unwrap();
    assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"), "{svg}");
    // A box for each ray, and nothing from elsewhere.
    assert!(svg.matches("class=\"box").count() >= 2 && !svg.contains("href"), "{svg}");
    assert_eq!(explained(&folder, "scene.toml 12,8 --svg -"), svg);
}

#[test]
fn a_pixel_outside_the_picture_is_wrong_usage() {
    let folder = folder();
    for (words, says) in [
        ("scene.toml 24,0", "24,0 is outside the picture of 24x16, whose last pixel is 23,15\n"),
        ("scene.toml 1", "must be X,Y, two integers from 0"),
        ("scene.toml -1,3", "must be X,Y, two integers from 0"),
        ("scene.toml 1,-3", "must be X,Y, two integers from 0"),
        ("-q scene.toml -1,-3", "must be X,Y, two integers from 0"),
        ("scene.toml 1,1 --sample -1", "an integer from 1"),
        ("scene.toml 1,1 --svg - --json", "standard output"),
        ("scene.toml 1,1 --svg scene.toml", "would overwrite"),
    ] {
        folder.run(&format!("explain {words}")).failed(2, says);
    }
}
