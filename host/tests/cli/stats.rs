//! Reports on the work.

use serde_json::Value;

use crate::program::{BALL, EMPTY, Folder};

/// Every place of a report that scripts may rely on. A number follows a `#`.
const PROMISED: &[&str] = &[
    "/scene/objects#",
    "/scene/triangles#",
    "/scene/lights#",
    "/scene/effects/0",
    "/plan/0/effect",
    "/plan/0/asked_by",
    "/plan/0/line#",
    "/plan/0/simulated",
    "/picture/width#",
    "/picture/height#",
    "/precision",
    "/rays/camera#",
    "/rays/camera_hits#",
    "/rays/reflected#",
    "/rays/transmitted#",
    "/rays/shadow#",
    "/tests/boxes#",
    "/tests/shapes#",
    "/tests/by_shape/sphere#",
    "/tests/by_ray/camera/boxes#",
    "/tests/by_ray/camera/shapes#",
    "/tests/by_ray/camera/regions#",
    "/tests/by_ray/reflected/boxes#",
    "/tests/by_ray/reflected/shapes#",
    "/tests/by_ray/reflected/regions#",
    "/tests/by_ray/transmitted/boxes#",
    "/tests/by_ray/transmitted/shapes#",
    "/tests/by_ray/transmitted/regions#",
    "/tests/by_ray/shadow/boxes#",
    "/tests/by_ray/shadow/shapes#",
    "/tests/by_ray/shadow/regions#",
    "/accelerator/kind",
    "/accelerator/bytes#",
    "/accelerator/regions#",
    "/tests/by_ray/shadow/mailbox_skips#",
    "/accelerator/choice",
    "/accelerator/reason",
    "/accelerator/items_per_region#",
    "/accelerator/mailbox_skips#",
    "/shadow_cache/asked#",
    "/shadow_cache/hits#",
    "/seconds/load#",
    "/seconds/build#",
    "/seconds/trace#",
    "/seconds/trace_cpu#",
    "/seconds/write#",
    "/digest",
];

/// The report on a scene that is rendered with these words.
fn report(scene: &str, words: &str) -> Value {
    let folder = Folder::with(scene);
    let json = folder.done(&format!("render scene.nff -q --stats json {words}"));
    assert_eq!(folder.names(), ["scene.nff", "scene.png"]);
    assert!(json.ends_with(b"}\n"));
    serde_json::from_slice(&json).unwrap()
}

/// The number at a place of a report.
fn count(report: &Value, place: &str) -> u64 {
    let found = report.pointer(place).and_then(Value::as_u64);
    found.unwrap_or_else(|| panic!("no integer at {place} in {report:#}"))
}

#[test]
fn a_report_has_everything_that_is_promised() {
    let it = report(BALL, "");
    for promised in PROMISED {
        let (place, is_number) = match promised.strip_suffix('#') {
            Some(place) => (place, true),
            None => (*promised, false),
        };
        let found = it.pointer(place).unwrap_or_else(|| panic!("no {place} in {it:#}"));
        assert_eq!(found.is_number(), is_number, "{place}: {found}");
        assert!(!is_number || found.as_f64().is_some_and(|number| number >= 0.0), "{place}: {found}");
    }
    assert!(it["plan"][0]["simulated"].is_boolean());
}

#[test]
fn a_report_says_what_is_in_the_scene() {
    let it = report(BALL, "--size 8x6");
    assert_eq!(it["scene"]["objects"], 3);
    assert_eq!(it["scene"]["triangles"], 1);
    assert_eq!(it["scene"]["lights"], 2);
    assert_eq!(it["scene"]["effects"], serde_json::json!(["shadows", "reflection", "transmission"]));
    let step = |effect: &str, by: &str, line: u32, objects: Option<u32>| serde_json::json!({ "effect": effect, "asked_by": by, "line": line, "objects": objects, "simulated": true });
    assert_eq!(
        it["plan"],
        Value::Array(vec![
            step("shadows", "light", 3, None),
            step("shadows", "light", 4, None),
            step("reflection", "material", 5, Some(1)),
            step("transmission", "material", 7, Some(2)),
        ])
    );
    assert_eq!(it["picture"], serde_json::json!({ "width": 8, "height": 6 }));
}

#[test]
fn a_scene_without_effects_requires_none() {
    let it = report(&format!("{EMPTY}f 1 1 1 1 0 0 0 0\ns 0 0 0 1\n"), "");
    assert_eq!((&it["scene"]["effects"], &it["plan"]), (&Value::Array(vec![]), &Value::Array(vec![])));
}

#[test]
fn the_rays_of_an_empty_scene_are_those_of_its_samples() {
    for (sampler, rays) in [("single", 12), ("regular:1", 12), ("regular:3", 108), ("adaptive:0:0", 20)] {
        let it = report(EMPTY, &format!("--sampler {sampler}"));
        assert_eq!(count(&it, "/rays/camera"), rays, "{sampler}");
        for place in ["/rays/camera_hits", "/rays/reflected", "/rays/shadow", "/tests/shapes", "/tests/boxes"]
        {
            assert_eq!(count(&it, place), 0, "{sampler} {place}");
        }
    }
}

#[test]
fn inside_a_mirror_every_level_has_as_many_rays_as_the_first() {
    // From the center of a sphere with a mirror inside, every ray hits and is reflected to the center, and every hit
    // sends a shadow ray to each of the two lights, which are inside, too.
    let scene = "v from 0 0 0 at 0 0 -1 up 0 1 0 angle 30 resolution 4 3\n\
                 l 0.1 0 0\nl 0 0.1 0\nf 1 1 1 1 1 0 0 0\ns 0 0 0 10\n";
    for levels in [1, 2, 5, 64] {
        let it = report(scene, &format!("--levels {levels} --cutoff 0"));
        assert_eq!(count(&it, "/rays/camera"), 12);
        assert_eq!(count(&it, "/rays/camera_hits"), 12);
        assert_eq!(count(&it, "/rays/reflected"), 12 * (levels - 1));
        assert_eq!(count(&it, "/rays/transmitted"), 0);
        assert_eq!(count(&it, "/rays/shadow"), 2 * 12 * levels);
    }
}

#[test]
fn the_tests_of_all_kinds_of_rays_and_of_all_shapes_are_all_tests() {
    let it = report(BALL, "");
    let sum = |field: &str| {
        let kinds = ["camera", "reflected", "transmitted", "shadow"];
        kinds.map(|kind| count(&it, &format!("/tests/by_ray/{kind}/{field}"))).iter().sum::<u64>()
    };
    assert_eq!(sum("boxes"), count(&it, "/tests/boxes"));
    assert_eq!(sum("shapes"), count(&it, "/tests/shapes"));
    let by_shape = it["tests"]["by_shape"].as_object().unwrap();
    assert_eq!(by_shape.values().map(|n| n.as_u64().unwrap()).sum::<u64>(), count(&it, "/tests/shapes"));
    assert_eq!(by_shape.keys().collect::<Vec<_>>(), ["sphere", "triangle"]);
}

#[test]
fn a_report_is_the_same_with_any_number_of_threads_but_for_the_seconds() {
    for sampler in ["single", "adaptive:0:0"] {
        let timeless = |threads: u32| {
            let mut it = report(BALL, &format!("--size 101x75 --sampler {sampler} --threads {threads}"));
            it.as_object_mut().unwrap().remove("seconds").unwrap();
            it
        };
        let one = timeless(1);
        assert!(count(&one, "/rays/transmitted") > 0 && count(&one, "/rays/reflected") > 0);
        for threads in [1, 2, 7] {
            assert_eq!(timeless(threads), one, "{sampler} {threads}");
        }
    }
}

#[test]
fn every_accelerator_makes_the_same_picture_with_other_work() {
    let mut reports = Vec::new();
    for (words, kind, choice) in [
        ("--accel list", "list", "list with boxes"),
        ("--accel list --bounds none", "list", "list without bounds"),
        ("--accel grid", "grid", "grid with a mailbox of 64"),
        ("--accel grid --mailbox 8", "grid", "grid with a mailbox of 8"),
        ("--accel grid --mailbox 0", "grid", "grid without mailbox"),
        ("--accel octree", "octree", "octree with a mailbox of 64"),
        ("--accel octree --mailbox 8", "octree", "octree with a mailbox of 8"),
        ("--accel octree --mailbox 0", "octree", "octree without mailbox"),
        ("--accel bvh", "bvh", "bvh with a stack"),
        ("--accel bvh --walk heap", "bvh", "bvh with a heap of 64"),
        ("--accel bvh --heap 0", "bvh", "bvh with a heap of 0"),
        ("--accel bvh --heap 1", "bvh", "bvh with a heap of 1"),
        ("--accel bvh --heap 4", "bvh", "bvh with a heap of 4"),
    ] {
        for precision in ["single", "double"] {
            let it = report(BALL, &format!("--size 20x15 {words} --precision {precision}"));
            assert_eq!(
                (&it["accelerator"]["kind"], &it["accelerator"]["choice"]),
                (&kind.into(), &choice.into())
            );
            assert_eq!(it["accelerator"]["reason"], "as requested");
            assert_eq!(it["precision"], precision);
            reports.push(it);
        }
    }
    let digests: Vec<_> = reports.iter().map(|it| it["digest"].as_str().unwrap()).collect();
    assert!(digests.iter().step_by(2).all(|digest| *digest == digests[0]), "{digests:?}");
    assert!(digests.iter().skip(1).step_by(2).all(|digest| *digest == digests[1]), "{digests:?}");
    assert_ne!(digests[0], digests[1], "the precisions differ somewhere in the last bits");
    for it in &reports {
        assert_eq!(it["rays"], reports[0]["rays"]);
        assert!(count(it, "/tests/shapes") > 0);
    }
    let list = count(&reports[2], "/tests/shapes");
    assert!(
        reports.iter().all(|it| count(it, "/tests/shapes") <= list),
        "no accelerator tests more than the list"
    );
}

#[test]
fn a_mailbox_skips_items_that_a_ray_has_been_tested_against() {
    // Long things lie in many cells.
    let mut scene = BALL.to_owned();
    for i in 0..40 {
        scene += &format!("c\n-5 {y} -3\n0.02\n5 {y} -3.5\n0.02\n", y = 0.1 * f64::from(i) - 2.0);
    }
    for accel in ["grid", "octree"] {
        let tests = |mailbox: u32| {
            let it = report(&scene, &format!("--accel {accel} --mailbox {mailbox}"));
            let tests = count(&it, "/tests/shapes") + count(&it, "/tests/boxes");
            (tests, count(&it, "/accelerator/mailbox_skips"))
        };
        let (without, none) = tests(0);
        assert_eq!(none, 0, "{accel}");
        for slots in [8, 64] {
            let (with, skips) = tests(slots);
            assert!(skips > 0 && with < without, "{accel} {slots}: {with} of {without}, {skips} skipped");
        }
    }
}

#[test]
fn a_scene_may_ask_for_what_the_command_line_can_and_the_command_line_wins() {
    let folder = Folder::with(EMPTY);
    let scene = "[render]\nsize = [8, 6]\naccel = \"grid\"\nmailbox = 8\nheap = 4\nprecision = \"double\"\n[[sphere]]\nradius = 1\n";
    folder.write("asks.toml", scene);
    for (words, choice, precision) in [
        ("", "grid with a mailbox of 8", "double"),
        ("--mailbox 0 --precision single", "grid without mailbox", "single"),
        ("--accel octree", "octree with a mailbox of 8", "double"),
        ("--accel bvh", "bvh with a heap of 4", "double"),
        ("--accel bvh --walk heap", "bvh with a heap of 64", "double"),
        ("--accel bvh --walk stack", "bvh with a stack", "double"),
        ("--accel auto", "list with boxes", "double"),
    ] {
        let json = folder.done(&format!("render asks.toml -q --stats json {words}"));
        let it: Value = serde_json::from_slice(&json).unwrap();
        assert_eq!(
            (&it["accelerator"]["choice"], &it["precision"]),
            (&choice.into(), &precision.into()),
            "{words}"
        );
    }
}

#[test]
fn the_digest_is_blake3_of_the_linear_picture() {
    // Twelve pixels of the background.
    let pixel = [0.25_f32, 0.5, 1.0].map(f32::to_le_bytes).concat();
    let expected = blake3::hash(&pixel.repeat(12)).to_hex();
    for words in ["", "--threads 7", "--sampler regular:2", "--sampler adaptive:0:0"] {
        assert_eq!(report(EMPTY, words)["digest"], expected.as_str(), "{words}");
    }
    // One step of the last digit, which eight bits do not show.
    let other = report(&EMPTY.replace("0.25", "0.25000003"), "");
    assert_ne!(other["digest"], expected.as_str());
}

#[test]
fn counting_does_not_change_the_picture() {
    let folder = Folder::with(BALL);
    folder.done("render scene.nff -o counted.png --stats json");
    folder.done("render scene.nff -o plain.png");
    assert_eq!(folder.read("counted.png"), folder.read("plain.png"));
}

#[test]
fn a_report_for_people_says_the_same() {
    let folder = Folder::with(BALL);
    let json: Value = serde_json::from_slice(&folder.done("render scene.nff --stats json")).unwrap();
    let text = String::from_utf8(folder.done("render scene.nff --stats text")).unwrap();
    for said in [
        "40 x 30".to_owned(),
        "3 objects (1 triangle), 2 lights".to_owned(),
        "shadows, required by light in line 3 and 1 more".to_owned(),
        format!("{}, {} of them hit", json["rays"]["camera"], json["rays"]["camera_hits"]),
        format!("reflected     {}\n", json["rays"]["reflected"]),
        format!("shadow rays   {}\n", json["rays"]["shadow"]),
        format!("{} of boxes, {} of shapes", json["tests"]["boxes"], json["tests"]["shapes"]),
        json["digest"].as_str().unwrap().to_owned(),
    ] {
        assert!(text.contains(&said), "`{said}` is not in\n{text}");
    }
}

#[test]
fn a_report_in_a_file_is_not_on_the_standard_output() {
    let folder = Folder::with(BALL);
    for words in ["--stats-file report", "--stats json --stats-file report"] {
        assert_eq!(folder.done(&format!("render scene.nff {words}")), b"", "{words}");
        let it: Value = serde_json::from_slice(&folder.read("report")).unwrap();
        assert_eq!(it["picture"]["width"], 40, "{words}");
    }
    assert_eq!(folder.done("render scene.nff --stats text --stats-file report"), b"");
    assert!(folder.read("report").starts_with(b"picture "));
    assert!(!folder.done("render scene.nff --stats-file -").is_empty());
    assert_eq!(folder.names(), ["report", "scene.nff", "scene.png"]);
}
