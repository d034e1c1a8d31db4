//! The settings in force, and who has set them.

use clap::CommandFactory;
use strahl::args::Args;

use crate::program::{BALL, Folder};

const SCENE: &str = "[[sphere]]\nradius = 1\n[render]\nlevels = 3\n# more\nsize = [24, 16]\n";

fn folder() -> Folder {
    let folder = Folder::with(BALL);
    folder.write("scene.toml", SCENE);
    folder
}

fn printed(folder: &Folder, words: &str) -> String {
    String::from_utf8(folder.done(&format!("render {words} --print-settings"))).unwrap()
}

/// The line that begins with `start`, spaces as one.
fn line(text: &str, start: &str) -> String {
    let line = text.lines().find(|line| line.starts_with(start));
    let line = line.unwrap_or_else(|| panic!("nothing begins with {start} in {text}"));
    line.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_setting_is_printed_with_its_source_and_no_picture_is_made() {
    let folder = folder();
    let before = folder.names();
    let text = printed(&folder, "scene.toml --cutoff 0.25 --threads 3");
    assert_eq!(line(&text, "size"), "size = [24, 16] # scene.toml:6");
    assert_eq!(line(&text, "levels"), "levels = 3 # scene.toml:4");
    assert_eq!(line(&text, "cutoff"), "cutoff = 0.25 # command line");
    assert_eq!(line(&text, "sampler"), "sampler = \"single\" # default");
    assert_eq!(line(&text, "# --threads"), "# --threads 3 # command line");
    assert_eq!(line(&text, "# --output"), "# --output scene.png # default");
    assert_eq!(folder.names(), before);
    // The command line wins.
    assert_eq!(line(&printed(&folder, "scene.toml --levels 9"), "levels"), "levels = 9 # command line");
    assert_eq!(line(&printed(&folder, "scene.nff"), "size"), "size = [40, 30] # scene.nff:1");
}

#[test]
fn what_is_printed_may_stand_in_a_scene_and_on_a_command_line() {
    let folder = folder();
    let text = printed(&folder, "scene.toml --cutoff 0.125 --sampler regular:2 --levels 7 --size 20x10");
    let values = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| line.contains(" = ") || line.starts_with("# --"));
        lines.map(|line| line.rsplit_once("  # ").unwrap().0.trim_end().to_owned()).collect()
    };
    let command = text.lines().next().unwrap().strip_prefix("# strahl render ").unwrap();
    assert_eq!(values(&printed(&folder, command)), values(&text));
    // In a scene it is as good as on the command line.
    folder.write("other.toml", format!("{text}\n[[sphere]]\nradius = 1\n"));
    let other = printed(&folder, "other.toml -o scene.png");
    assert_eq!(values(&other), values(&text));
    assert!(line(&other, "sampler").contains("other.toml:"), "{other}");
}

#[test]
fn what_has_no_meaning_for_an_accelerator_is_not_in_force() {
    let folder = folder();
    folder.write("grid.toml", "[render]\naccel = \"grid\"\nmailbox = 8\nheap = 4\n[[sphere]]\nradius = 1\n");
    let text = printed(&folder, "grid.toml");
    assert_eq!(line(&text, "accel"), "accel = \"grid\" # grid.toml:2");
    assert_eq!(line(&text, "mailbox"), "mailbox = 8 # grid.toml:3");
    assert!(!text.contains("heap") && !text.contains("walk") && !text.contains("bounds"), "{text}");
    let text = printed(&folder, "grid.toml --accel bvh");
    assert_eq!(line(&text, "heap"), "heap = 4 # grid.toml:4");
    assert_eq!(line(&text, "walk"), "walk = \"heap\" # default");
    assert!(!text.contains("mailbox"), "{text}");
}

#[test]
fn a_shadow_cache_that_a_scene_turns_off_is_off_on_the_command_line_that_is_printed() {
    let folder = folder();
    folder.write("off.toml", "[render]\nshadow_cache = false\n[[sphere]]\nradius = 1\n");
    let text = printed(&folder, "off.toml");
    assert_eq!(line(&text, "shadow_cache"), "shadow_cache = false # off.toml:2");
    assert!(text.lines().next().unwrap().contains(" --no-shadow-cache"), "{text}");
    let disabled = printed(&folder, "scene.toml --no-shadow-cache");
    assert_eq!(line(&disabled, "shadow_cache"), "shadow_cache = false # command line");
    assert!(disabled.lines().next().unwrap().contains(" --no-shadow-cache --threads "), "{disabled}");
    let on = printed(&folder, "scene.toml");
    assert_eq!(line(&on, "shadow_cache"), "shadow_cache = true # default");
    assert!(!on.contains("--no-shadow-cache"), "{on}");
}

#[test]
fn shadows_that_a_scene_colors_are_reported() {
    let folder = folder();
    folder.write("glass.toml", "[render]\ncolored_shadows = true\n[[sphere]]\nradius = 1\n");
    assert_eq!(line(&printed(&folder, "glass.toml"), "colored"), "colored_shadows = true # glass.toml:2");
    assert_eq!(line(&printed(&folder, "scene.toml"), "colored"), "colored_shadows = false # default");
    let without = printed(&folder, "glass.toml --without colored-shadows");
    assert_eq!(line(&without, "colored"), "colored_shadows = false # command line");
    assert_eq!(line(&without, "# --without"), "# --without colored-shadows # command line");
    assert!(!without.contains("--colored"), "{without}");
}

#[test]
fn no_key_of_a_scene_is_forgotten() {
    let folder = folder();
    let schema: serde_json::Value = serde_json::from_slice(&folder.done("schema")).unwrap();
    let keys = schema["$defs"]["Render"]["properties"].as_object().unwrap();
    assert!(keys.len() >= 14, "{keys:?}");
    let text = printed(&folder, "scene.toml --walk heap");
    let is_alias =
        |key: &&String| keys[*key]["description"].as_str().is_some_and(|text| text.starts_with("Alias of "));
    for key in keys.keys().filter(|key| !is_alias(key)) {
        assert!(text.contains(&format!("\n{key} = ")), "{key} is not in\n{text}");
    }
}

#[test]
fn no_option_is_forgotten() {
    let folder = folder();
    folder.done("render scene.toml --quiet");
    let text = printed(
        &folder,
        "scene.toml --select 4:0.1 --region 1,2,8x4 --mask scene.png --walk heap --without lens \
         --no-shadow-cache",
    );
    assert_eq!(line(&text, "# --region"), "# --region 1,2,8x4 # command line");
    // Options of the statistics are not settings of the picture.
    let others = [
        "stats",
        "stats-file",
        "quiet",
        "print-settings",
        "cost",
        "target-error",
        "verify",
        "time-limit",
        "help",
    ];
    let program = Args::command();
    let render = program.find_subcommand("render").unwrap();
    for option in render.get_arguments().filter_map(|option| option.get_long()) {
        let key = if option == "no-shadow-cache" { "shadow_cache" } else { option };
        let is_printed = text.contains(&format!("\n{key} = ")) || text.contains(&format!("# --{option} "));
        assert!(is_printed != others.contains(&option), "--{option} is not in\n{text}");
    }
}
