//! The command line, and what the program says to wrong ones and to wrong scenes.

use std::collections::BTreeSet;

use crate::program::{BALL, EMPTY, Folder};

/// Every option of `strahl render` and `strahl watch`; what is not here must not be in the help.
const OPTIONS: &[&str] = &[
    "--output",
    "--size",
    "--levels",
    "--cutoff",
    "--sampler",
    "--filter",
    "--seed",
    "--select",
    "--region",
    "--mask",
    "--without",
    "--precision",
    "--accel",
    "--walk",
    "--heap",
    "--bounds",
    "--mailbox",
    "--no-shadow-cache",
    "--threads",
    "--stats",
    "--stats-file",
    "--quiet",
    "--help",
];

/// Every command with its options.
const COMMANDS: &[(&str, &[&str])] = &[
    ("render", OPTIONS),
    ("watch", OPTIONS),
    (
        "cast",
        &[
            "--rays",
            "--output",
            "--precision",
            "--accel",
            "--walk",
            "--heap",
            "--bounds",
            "--mailbox",
            "--threads",
            "--quiet",
            "--help",
        ],
    ),
    (
        "study",
        &[
            "--output",
            "--size",
            "--full",
            "--time-limit",
            "--threads",
            "--from",
            "--device",
            "--quiet",
            "--help",
        ],
    ),
    ("bake", &["--output", "--accel", "--nodes", "--size", "--levels", "--cutoff", "--quiet", "--help"]),
    ("info", &["--json", "--help"]),
    (
        "explain",
        &[
            "--size",
            "--levels",
            "--cutoff",
            "--sampler",
            "--filter",
            "--seed",
            "--without",
            "--sample",
            "--json",
            "--svg",
            "--quiet",
            "--help",
        ],
    ),
    ("schema", &["--help"]),
    ("compare", &["--limit", "--limit-share", "--json", "--output", "--quiet", "--help"]),
    ("generate", &["--size", "--output", "--format", "--bare", "--quiet", "--help"]),
    ("completions", &["--help"]),
    ("man", &["--help"]),
];

#[test]
fn the_help_lists_every_command_that_is_there_and_no_other() {
    let help = String::from_utf8(Folder::with(EMPTY).done("--help")).unwrap();
    let commands = help.split("Commands:\n").nth(1).unwrap().lines().take_while(|line| !line.is_empty());
    // A line of a command is indented by two, what follows of its description by more.
    let named = commands.filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    let named: BTreeSet<_> = named.filter(|name| !name.is_empty()).collect();
    assert_eq!(named, COMMANDS.iter().map(|(name, _)| *name).chain(["help"]).collect(), "{help}");
}

/// The words of a text that begin with two hyphens.
fn long_options(text: &str) -> BTreeSet<String> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '-';
    let words = text.split(|c: char| !is_part(c)).filter(|word| word.len() > 2 && word.starts_with("--"));
    words.map(str::to_owned).collect()
}

#[test]
fn the_help_lists_every_option_that_is_there_and_no_other() {
    let folder = Folder::with(EMPTY);
    for (command, options) in COMMANDS {
        let mut expected: BTreeSet<_> = options.iter().map(|o| (*o).to_owned()).collect();
        if *command == "render" {
            let alone = ["--print-settings", "--cost", "--target-error", "--verify", "--time-limit"];
            expected.extend(alone.map(String::from));
        }
        for words in ["--help", "-h"] {
            let help = String::from_utf8(folder.done(&format!("{command} {words}"))).unwrap();
            // What stands above may name options of others.
            let (_, help) = help.split_once("Usage: ").unwrap();
            assert_eq!(long_options(help), expected, "{help}");
        }
    }
    let help = String::from_utf8(folder.done("--help")).unwrap();
    assert_eq!(long_options(&help), ["--help", "--version"].map(str::to_owned).into());
}

#[test]
fn every_option_of_the_help_works() {
    let folder = Folder::with(BALL);
    folder.done(
        "render scene.nff --output a.png --size 8x6 --levels 3 --cutoff 0.5 --sampler regular:2 --threads 1 \
         --precision double --accel list --bounds none --stats json --stats-file a.json --quiet",
    );
    folder.done("render scene.nff -o b.png -q --walk heap --heap 4 --mailbox 8");
    folder.done(
        "render scene.nff -o c.png -q --filter tent --sampler stochastic:4..8:0.9 --seed 3 --select 2:0.1 --without lens,gloss \
         --region 1,1,3x2 --mask b.png",
    );
    assert_eq!(folder.names(), ["a.json", "a.png", "b.png", "c.png", "scene.nff"]);
}

#[test]
fn the_version_is_that_of_the_package() {
    for words in ["--version", "-V"] {
        let said = String::from_utf8(Folder::with(EMPTY).done(words)).unwrap();
        assert_eq!(said, format!("strahl {}\n", env!("CARGO_PKG_VERSION")));
    }
}

#[test]
fn wrong_usage_is_reported_with_status_2_and_nothing_is_written() {
    let folder = Folder::with(EMPTY);
    let scene = "render scene.nff";
    for (words, says) in [
        (String::new(), "Usage"),
        ("paint scene.nff".into(), "paint"),
        ("render".into(), "<SCENE>"),
        (format!("{scene} other.nff"), "other.nff"),
        (format!("{scene} --colour"), "--colour"),
        (format!("{scene} --sizes 4x3"), "--sizes"),
        (format!("{scene} --size"), "--size"),
        (format!("{scene} --size 4"), "640x480"),
        (format!("{scene} --size 4x3x2"), "640x480"),
        (format!("{scene} --size 4.5x3"), "640x480"),
        (format!("{scene} --size=-4x3"), "640x480"),
        (format!("{scene} --size -4x3"), "must be WIDTHxHEIGHT"),
        (format!("{scene} --size 4x"), "640x480"),
        (format!("{scene} --size x"), "640x480"),
        (format!("{scene} --size 0x3"), "1 to 65536"),
        (format!("{scene} --size 4x65537"), "1 to 65536"),
        (format!("{scene} --size 65536x65536"), "at most 268435456 pixels"),
        (format!("{scene} --size 4294967297x3"), "640x480"),
        (format!("{scene} --size 4x3 --size 4x3"), "--size"),
        (format!("{scene} --levels 0"), "1 to 64"),
        (format!("{scene} --levels 65"), "1 to 64"),
        (format!("{scene} --levels 256"), "1 to 64"),
        (format!("{scene} --levels many"), "--levels"),
        (format!("{scene} --cutoff 1.5"), "0 to 1"),
        (format!("{scene} --cutoff=-0.5"), "0 to 1"),
        (format!("{scene} --cutoff nan"), "0 to 1"),
        (format!("{scene} --cutoff 1/0"), "0 to 1"),
        (format!("{scene} --sampler rough"), "regular:N"),
        (format!("{scene} --sampler single:1"), "regular:N"),
        (format!("{scene} --sampler regular"), "regular:N"),
        (format!("{scene} --sampler regular:"), "1 to 256"),
        (format!("{scene} --sampler regular:0"), "1 to 256"),
        (format!("{scene} --sampler regular:257"), "1 to 256"),
        (format!("{scene} --sampler regular:1.5"), "1 to 256"),
        (format!("{scene} --sampler regular:70000"), "1 to 256"),
        (format!("{scene} --sampler adaptive:7:0.1"), "DEPTH must be 0 to 6"),
        (format!("{scene} --sampler adaptive:x:y"), "DEPTH must be 0 to 6"),
        (format!("{scene} --sampler adaptive:0"), "threshold is missing"),
        (format!("{scene} --sampler stochastic:1..0:0.5"), "MIN at most MAX"),
        (format!("{scene} --filter cone"), "gaussian"),
        (format!("{scene} --filter tent --sampler adaptive:2:0.1"), "supports only the box filter"),
        (format!("{scene} --seed=-1"), "--seed"),
        (format!("{scene} --seed -1"), "an integer from 0 to 4294967295"),
        (format!("{scene} --levels -1"), "1 to 64"),
        (format!("{scene} --cutoff -0.5"), "0 to 1"),
        (format!("{scene} --threads -1"), "1 to 1024"),
        (format!("{scene} --heap -1"), "must be 0, 1, 4 or 64"),
        (format!("{scene} --mailbox -1"), "must be 0, 8 or 64"),
        (format!("{scene} --region -1,0,4x3"), "must be X,Y,WxH"),
        (format!("{scene} --target-error -1"), "more than 0 and at most 1"),
        (format!("{scene} --time-limit -1s"), "must be a duration"),
        (format!("{scene} --time-limit 1e19"), "at most 1000 days"),
        ("study scene.nff --time-limit 999999999999999s".into(), "at most 1000 days"),
        ("bake scene.nff -o a.strahl --nodes -1".into(), "-1 is not in 1..=4294967295"),
        (
            "bake scene.nff -o a.strahl --accel list --nodes 8".into(),
            "--nodes cannot be used with --accel list",
        ),
        (
            "bake scene.nff -o a.strahl --accel grid --nodes 8".into(),
            "--nodes cannot be used with --accel grid",
        ),
        ("bake scene.nff -o a.rs --accel bvh".into(), "--accel cannot be used with a .rs output"),
        ("bake scene.nff -o a.rs --nodes 8".into(), "--nodes cannot be used with a .rs output"),
        (format!("{scene} --select 3:0.1"), "STEP must be"),
        (format!("{scene} --region 0,0"), "must be X,Y,WxH"),
        (format!("{scene} --region 0,0,4"), "must be X,Y,WxH"),
        (format!("{scene} --region 0,0,0x4"), "1 to 65536"),
        (format!("{scene} --region 1,0,4x3"), "beyond the picture, which is 4x3"),
        (format!("{scene} --region 4294967295,0,4x3"), "beyond the picture, which is 4x3"),
        (format!("{scene} --threads 0"), "1 to 1024"),
        (format!("{scene} --threads 1025"), "1 to 1024"),
        (format!("{scene} --threads two"), "1 to 1024"),
        (format!("{scene} --precision half"), "half"),
        (format!("{scene} --accel tree"), "tree"),
        (format!("{scene} --heap 5"), "must be 0, 1, 4 or 64"),
        (format!("{scene} --mailbox=-1"), "must be 0, 8 or 64"),
        (format!("{scene} --bounds cube"), "cube"),
        (format!("{scene} --walk stack --heap 4"), "--heap requires --walk heap"),
        (format!("{scene} --accel list --mailbox 8"), "--mailbox cannot be used with --accel list"),
        (format!("{scene} --accel grid --walk heap"), "--walk cannot be used with --accel grid"),
        (format!("{scene} --accel octree --heap 4"), "--heap cannot be used with --accel octree"),
        (format!("{scene} --accel bvh --bounds none"), "--bounds cannot be used with --accel bvh"),
        (format!("{scene} --stats yaml"), "yaml"),
        (format!("{scene} -o picture.gif"), "picture.gif has no known picture extension"),
        (format!("{scene} -o picture"), "picture has no known picture extension"),
        (format!("{scene} -o .png"), ".png has no known picture extension"),
        (format!("{scene} -o a.jpg --size 65536x1"), "at most 65535 pixels"),
        (format!("{scene} -o - --stats json"), "use --stats-file"),
        (format!("{scene} -o - --stats-file -"), "use --stats-file"),
        (format!("{scene} -o a.png --stats-file a.png"), "would overwrite"),
        (format!("{scene} -o a.png --stats-file ./a.png"), "would overwrite"),
        (format!("{scene} --stats-file scene.png"), "would overwrite"),
        (format!("{scene} --stats-file scene.nff"), "would overwrite"),
    ] {
        folder.run(&words).failed(2, says);
        assert_eq!(folder.names(), ["scene.nff"], "{words}");
        assert_eq!(folder.read("scene.nff"), EMPTY.as_bytes(), "{words}");
    }
}

#[test]
fn wrong_usage_is_reported_before_the_scene_is_read() {
    Folder::with(EMPTY).run("render missing.nff -o picture.gif").failed(2, "picture.gif");
    Folder::with("?").run("render scene.nff -o - --stats text").failed(2, "--stats-file");
}

#[test]
fn a_wrong_scene_is_reported_with_its_line_and_nothing_is_written() {
    for (text, line) in [
        ("", 1),
        ("# nothing\n", 1),
        ("v\n", 1),
        ("?\n", 1),
        ("b 0 0 0\nv from 0 0 9 at 0 0 0 up 0 1 0 angle 30 resolution 0 3\n", 2),
        ("b 0 0 0\n\n\nf 1 1 1 1 0 0 0 0\ns 0 0 0 nan\n", 5),
        ("b 0 0 0\nl 1 2 3\n", 2),
    ] {
        let folder = Folder::with(text);
        for words in ["-q", "-o picture.ppm --stats-file report.json", "-o - --stats-file report.json"] {
            let ran = folder.run(&format!("render scene.nff {words}"));
            ran.failed(65, "");
            assert!(ran.stderr.starts_with(&format!("strahl: scene.nff:{line}: ")), "{}", ran.stderr);
            assert_eq!(ran.stderr.lines().count(), 1, "{}", ran.stderr);
            assert_eq!(folder.names(), ["scene.nff"], "{words}");
        }
    }
}

#[test]
fn a_file_that_is_no_scene_is_reported_with_status_65() {
    let folder = Folder::with(EMPTY);
    folder.write("scene.toml", "");
    folder.write("picture.nff", b"\x89PNG\r\n\x1a\n");
    folder.run("render scene.toml").failed(65, "scene.toml: ");
    folder.run("render picture.nff").failed(65, "picture.nff:1: ");
    assert_eq!(folder.names(), ["picture.nff", "scene.nff", "scene.toml"]);
}

#[test]
fn a_scene_that_cannot_be_read_is_reported_with_status_66() {
    let folder = Folder::with(EMPTY);
    std::fs::create_dir(folder.path("folder.nff")).unwrap();
    for name in ["missing.nff", "missing.toml", "missing/scene.nff", "scene.nff/scene.nff", "folder.nff", "."]
    {
        folder.run(&format!("render {name} -o a.png")).failed(66, &format!("cannot read {name}: "));
    }
    assert_eq!(folder.names(), ["folder.nff", "scene.nff"]);
}

#[cfg(unix)]
#[test]
fn a_message_that_nobody_can_read_changes_nothing() {
    let unread = || {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        writer
    };
    let folder = Folder::with(EMPTY);
    let status = |words: &str| folder.command(words).stderr(unread()).status().unwrap().code();
    assert_eq!(status("render scene.nff"), Some(0));
    assert_eq!(status("render missing.nff"), Some(66));
    assert_eq!(status("render scene.nff --levels 0"), Some(2));
    // A polygon without area, of which the program warns.
    folder.write("flat.nff", format!("{EMPTY}f 1 1 1 1 0 0 0 0\np 3 0 0 0 0 0 0 0 0 0\n"));
    assert_eq!(status("render flat.nff"), Some(0));
    assert_eq!(folder.names(), ["flat.nff", "flat.png", "scene.nff", "scene.png"]);
}
