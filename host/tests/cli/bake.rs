//! Warnings and summary of `bake`.

use crate::program::{EMPTY, Folder};

const WITH_SETTINGS: &str = "\
[[sphere]]
radius = 1
[render]
size = [24, 16]
sampler = \"stochastic:64\"
filter = \"tent\"
precision = \"double\"
";

#[test]
fn settings_of_a_scene_that_a_baked_scene_cannot_store_are_reported() {
    let folder = Folder::with(EMPTY);
    folder.write("scene.toml", WITH_SETTINGS);
    for output in ["a.strahl", "a.rs"] {
        let ran = folder.run(&format!("bake scene.toml -o {output}"));
        assert_eq!(ran.status, Some(0), "{}", ran.stderr);
        let warnings: Vec<&str> = ran.stderr.lines().filter(|line| line.contains("warning")).collect();
        let begins = ["sampler `stochastic:64`", "filter `tent`", "precision `double`"];
        assert_eq!(warnings.len(), begins.len(), "{}", ran.stderr);
        for (warning, begin) in warnings.iter().zip(begins) {
            assert!(
                warning.starts_with(&format!("strahl: scene.toml: warning: sets {begin}, ")),
                "{warning}"
            );
        }
        assert_eq!(folder.run(&format!("bake scene.toml -o {output} -q")).stderr, "");
    }
    assert!(!folder.run("bake scene.nff -o b.strahl").stderr.contains("warning"));
}

#[test]
fn the_instructions_are_those_for_one_ray_in_a_pixel_and_it_is_said() {
    let folder = Folder::with(EMPTY);
    let said = folder.run("bake scene.nff -o a.strahl").stderr;
    let time = said.lines().find(|line| line.starts_with("  time ")).unwrap();
    assert!(time.contains(" instructions per pixel there with one ray per pixel, "), "{time}");
}
