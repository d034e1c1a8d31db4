//! Settings that keep an error or a time, and what pixels cost.

use std::time::{Duration, Instant};

use serde_json::Value;

use crate::program::{BALL, Folder};

const SCENE: &str = "\
background = { below = \"ivory\", above = \"skyblue\" }
ambient_light = { color = 0.1 }

[[sphere_light]]
position = [3, 6, 4]
radius = 1

[[sphere]]
radius = 1
material = { color = \"tomato\", mirror = 0.3 }

[[plane]]
point = [0, -1, 0]
material = { color = \"teal\", mirror = 0.2 }

[camera]
from = [0, 1, 6]
at = [0, 0, 0]

[render]
size = [60, 45]
";

fn folder() -> Folder {
    let folder = Folder::with(BALL);
    folder.write("scene.toml", SCENE);
    folder
}

/// Renders with a target, and again with the reported command; the statistics as JSON.
fn twice(folder: &Folder, words: &str) -> Value {
    folder.done(&format!("render {words} --stats-file stats.json -o aimed.png"));
    let json: Value = serde_json::from_slice(&folder.read("stats.json")).unwrap();
    let command = json["aim"]["command"].as_str().unwrap();
    let plain = command.strip_prefix("strahl ").unwrap().replace("--output aimed.png", "--output plain.png");
    assert!(!plain.contains("time") && !plain.contains("target"), "{plain}");
    folder.done(&plain);
    assert!(folder.read("aimed.png") == folder.read("plain.png"), "{command}");
    json
}

#[test]
fn a_target_error_is_reached_and_the_plain_command_makes_the_same_bytes() {
    let folder = folder();
    let errors = [("0.05", 0.05), ("5/255", 5.0 / 255.0)].map(|(word, limit)| {
        let json = twice(&folder, &format!("scene.toml --target-error {word} --verify"));
        let aim = &json["aim"];
        let (estimate, measured) = (aim["estimate"].as_f64().unwrap(), aim["measured"].as_f64().unwrap());
        assert!(estimate <= limit && measured <= limit && aim["kept"] == true, "{aim}");
        // All pixels of so small a picture are looked at.
        assert_eq!(aim["pixels"], 60 * 45);
        json["rays"]["camera"].as_u64().unwrap()
    });
    assert!(errors[0] < errors[1], "{errors:?}");
}

#[test]
fn what_the_command_line_sets_stays_and_an_error_that_cannot_be_reached_is_reported() {
    let folder = folder();
    let ran = folder.run("render scene.toml --target-error 0.005 --sampler single --levels 2 --select 2:0");
    ran.failed(1, "no setting reaches it");
    ran.failed(1, "2 levels");
    ran.failed(1, "the most accurate found");
    // There is a picture all the same.
    assert!(folder.names().contains(&"scene.png".into()));
}

#[test]
fn a_time_limit_is_respected_and_the_plain_command_makes_the_same_bytes() {
    let folder = folder();
    let clock = Instant::now();
    // So many pixels that there is never time for all samples.
    let json = twice(&folder, "scene.toml --size 300x225 --time-limit 1s");
    assert!(json["aim"]["passes"].as_u64().unwrap() >= 2, "{json}");
    assert!(clock.elapsed() > Duration::from_millis(900));
}

#[test]
fn without_any_time_there_is_the_coarsest_picture() {
    let folder = folder();
    let json = twice(&folder, "scene.toml --time-limit 1us");
    assert_eq!(json["aim"]["passes"], 1);
    assert!(json["aim"]["why"].as_str().unwrap().contains("no time for more"), "{json}");
    assert!(json["rays"]["camera"].as_u64().unwrap() <= 4, "{json}");
}

#[test]
fn aims_that_contradict_each_other_are_wrong_usage() {
    let folder = folder();
    for (words, says) in [
        ("--target-error 0.01 --time-limit 2s", "cannot be used with"),
        ("--verify", "--target-error"),
        ("--time-limit 2s --sampler single", "cannot be used with"),
        ("--target-error 0", "more than 0"),
        ("--time-limit 2parsecs", "must be a duration"),
        ("--cost -", "needs a file name"),
        ("--cost scene.png", "would overwrite"),
        ("--print-settings --target-error 0.1", "cannot be used with"),
    ] {
        folder.run(&format!("render scene.toml {words}")).failed(2, says);
    }
}

#[test]
fn what_pixels_cost_is_shown_beside_the_picture() {
    let folder = folder();
    folder.done("render scene.toml -o plain.png");
    folder.done("render scene.toml -o scene.png --cost cost.png --quiet");
    assert!(folder.read("scene.png") == folder.read("plain.png"));
    let cost = image(&folder, "cost.png");
    assert!(cost.0 > 3 * 60 && cost.1 > 45, "{cost:?}");
    folder.done("render scene.toml -o scene.png --cost cost.exr --quiet");
    let bytes = folder.read("cost.exr");
    for name in ["rays.shadow", "tests.boxes", "levels"] {
        assert!(bytes.windows(name.len()).any(|part| part == name.as_bytes()), "{name}");
    }
}

/// Width and height of a PNG.
fn image(folder: &Folder, name: &str) -> (u32, u32) {
    let bytes = folder.read(name);
    let number = |place: usize| u32::from_be_bytes(bytes[place..place + 4].try_into().unwrap());
    (number(16), number(20))
}
