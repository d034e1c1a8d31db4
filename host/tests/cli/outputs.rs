//! Where outputs go, and that they are complete or absent.

use std::fs;
use std::process::Stdio;

use crate::program::{BALL, EMPTY, Folder, Running};

/// A picture that takes days, for errors that must be reported before tracing starts.
const ENDLESS: &str = "--size 4096x4096 --sampler regular:256";

#[test]
fn the_picture_has_the_name_of_the_scene_and_lies_in_the_current_folder() {
    let folder = Folder::with(EMPTY);
    fs::create_dir(folder.path("scenes")).unwrap();
    folder.write("scenes/red.ball.NFF", EMPTY);
    folder.done("render scenes/red.ball.NFF");
    folder.done("render ./scene.nff");
    assert_eq!(folder.names(), ["red.ball.png", "scene.nff", "scene.png", "scenes"]);
    assert_eq!(fs::read_dir(folder.path("scenes")).unwrap().count(), 1);
}

#[test]
fn an_output_in_another_folder_is_written_there() {
    let folder = Folder::with(EMPTY);
    fs::create_dir(folder.path("out")).unwrap();
    folder.done("render scene.nff -o out/a.png --stats-file out/a.json");
    assert_eq!(folder.names(), ["out", "scene.nff"]);
    assert!(folder.read("out/a.png").starts_with(b"\x89PNG"));
    assert!(folder.read("out/a.json").starts_with(b"{"));
}

#[test]
fn an_output_that_cannot_be_written_is_reported_with_status_74_before_anything_is_traced() {
    let folder = Folder::with(BALL);
    fs::create_dir(folder.path("folder.png")).unwrap();
    folder.write("locked.png", "before");
    let mut locked = fs::metadata(folder.path("locked.png")).unwrap().permissions();
    locked.set_readonly(true);
    fs::set_permissions(folder.path("locked.png"), locked).unwrap();

    for (words, name) in [
        ("-o missing/a.png", "missing/a.png"),
        ("-o folder.png", "folder.png"),
        ("-o scene.nff/a.png", "scene.nff/a.png"),
        ("-o locked.png", "locked.png"),
        ("-o a.png --stats-file missing/a.json", "missing/a.json"),
        ("-o - --stats-file folder.png", "folder.png"),
    ] {
        let mut command = folder.command(&format!("render scene.nff {words} {ENDLESS}"));
        let mut said = tempfile::tempfile().unwrap();
        let running = Running::start(command.stdout(Stdio::null()).stderr(said.try_clone().unwrap()));
        assert_eq!(running.end().code(), Some(74), "{words}");
        let mut stderr = String::new();
        std::io::Seek::rewind(&mut said).unwrap();
        std::io::Read::read_to_string(&mut said, &mut stderr).unwrap();
        assert!(stderr.starts_with(&format!("strahl: cannot write {name}: ")), "{stderr}");
        assert_eq!(folder.names(), ["folder.png", "locked.png", "scene.nff"], "{words}");
    }
    assert_eq!(folder.read("locked.png"), b"before");
}

#[cfg(unix)]
#[test]
fn a_standard_output_that_nobody_reads_is_reported_with_status_74() {
    let folder = Folder::with(EMPTY);
    for words in ["render scene.nff -o -", "render scene.nff --stats text"] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let ended = folder.command(words).stdout(writer).stderr(Stdio::piped()).spawn().unwrap();
        let ended = ended.wait_with_output().unwrap();
        let stderr = String::from_utf8(ended.stderr).unwrap();
        assert_eq!(ended.status.code(), Some(74), "{stderr}");
        assert!(stderr.starts_with("strahl: cannot write to the standard output: "), "{stderr}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_is_no_text_is_not_written_to_a_terminal() {
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    let folder = Folder::with(BALL);
    let near = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&near).unwrap();
    unlockpt(&near).unwrap();
    let far = ptsname(&near, Vec::new()).unwrap().into_string().unwrap();
    let ended = |words: &str| {
        let terminal = fs::OpenOptions::new().read(true).write(true).open(&far).unwrap();
        let ended = folder.command(words).stdout(terminal).stderr(Stdio::piped()).spawn().unwrap();
        let ended = ended.wait_with_output().unwrap();
        (ended.status.code(), String::from_utf8(ended.stderr).unwrap())
    };
    for (words, what) in [
        ("render scene.nff -o -", "the picture"),
        ("bake scene.nff -o -", "the baked scene"),
        ("generate knot --size 3 --format ply -o -", "the PLY file"),
    ] {
        let says = format!("strahl: {what} would be written to the terminal; redirect it or name a file\n");
        assert_eq!(ended(words), (Some(2), says), "{words}");
    }
    // Text is what a terminal is for.
    assert_eq!(ended("explain scene.nff 1,1 --svg - -q"), (Some(0), String::new()));
    assert_eq!(folder.names(), ["scene.nff"]);
}

#[test]
fn a_picture_on_the_standard_output_is_all_that_is_there() {
    let folder = Folder::with(BALL);
    folder.done("render scene.nff -o a.png");
    assert_eq!(folder.done("render scene.nff -o - --stats-file a.json"), folder.read("a.png"));
    assert_eq!(folder.names(), ["a.json", "a.png", "scene.nff"]);
}

#[test]
fn only_results_come_on_the_standard_output() {
    let folder = Folder::with(&format!("{EMPTY}f 1 1 1 1 0 0 0 0\np 3 0 0 0 0 0 0 0 0 0\n"));
    let ran = folder.run("render scene.nff");
    assert_eq!((ran.status, ran.stdout.as_slice()), (Some(0), b"".as_slice()));
    let said: Vec<_> = ran.stderr.lines().collect();
    let begins = [
        "strahl: scene.nff: warning: 1 polygon has zero area",
        "scene.png  4 x 3",
        "  time      load ",
        "  rays      12 camera, 0 reflected, 0 transmitted, 0 shadow",
        "  accel     list with boxes, few items: 1 region, 48 B",
        "  unused    shadows, reflection, transmission, colored-shadows, penumbra, lens, gloss, motion",
        "  note      no camera ray hits anything",
    ];
    assert_eq!(said.len(), begins.len(), "{said:#?}");
    for (line, begin) in said.iter().zip(begins) {
        assert!(line.starts_with(begin), "`{begin}` does not begin {line}");
        assert!(!line.contains('\u{1b}'), "colours where there is no terminal: {line:?}");
    }
}

#[test]
fn what_one_ray_in_a_pixel_makes_noise_of_is_reported() {
    let folder = Folder::with(EMPTY);
    let soft = "render = { size = [8, 6] }\n[[sphere_light]]\nposition = [2, 4, 2]\nradius = 0.5\n\
        [[sphere]]\ncenter = [0, 1, 0]\nradius = 1\n";
    folder.write("soft.toml", soft);
    let note = "penumbra is noisy with one ray per pixel; use --sampler stochastic:64";
    for (words, is_reported) in [("", true), ("--sampler stochastic:4", false), ("--without penumbra", false)]
    {
        let ran = folder.run(&format!("render soft.toml {words}"));
        assert_eq!(ran.status, Some(0), "{}", ran.stderr);
        assert_eq!(ran.stderr.contains(note), is_reported, "{words}: {}", ran.stderr);
    }
}

#[test]
fn a_quiet_program_says_nothing_but_errors() {
    let folder = Folder::with(&format!("{EMPTY}f 1 1 1 1 0 0 0 0\np 3 0 0 0 0 0 0 0 0 0\n"));
    for words in ["--quiet", "-q", "-q --stats-file a.json"] {
        let ran = folder.run(&format!("render scene.nff {words}"));
        assert_eq!((ran.status, ran.stdout.len(), ran.stderr.as_str()), (Some(0), 0, ""));
    }
    folder.run("render missing.nff --quiet").failed(66, "missing.nff");
}

#[test]
fn an_old_output_is_replaced_by_a_new_one_and_stays_if_the_command_fails() {
    let folder = Folder::with(EMPTY);
    folder.write("a.png", "before");
    folder.write("a.json", "before");
    folder.write("wrong.nff", "?");
    folder.run("render wrong.nff -o a.png --stats-file a.json").failed(65, "wrong.nff:1: ");
    assert_eq!((folder.read("a.png"), folder.read("a.json")), (b"before".to_vec(), b"before".to_vec()));
    folder.done("render scene.nff -o a.png --stats-file a.json");
    assert!(folder.read("a.png").starts_with(b"\x89PNG") && folder.read("a.json").starts_with(b"{"));
    assert_eq!(folder.names(), ["a.json", "a.png", "scene.nff", "wrong.nff"]);
}

#[cfg(unix)]
#[test]
fn an_output_through_a_link_replaces_the_file_behind_it() {
    let folder = Folder::with(EMPTY);
    fs::create_dir(folder.path("behind")).unwrap();
    folder.write("behind/a.png", "before");
    std::os::unix::fs::symlink("behind/a.png", folder.path("link.png")).unwrap();
    std::os::unix::fs::symlink("behind", folder.path("link")).unwrap();
    folder.done("render scene.nff -o link.png");
    folder.done("render scene.nff -o link/b.png");
    assert!(fs::symlink_metadata(folder.path("link.png")).unwrap().is_symlink());
    assert!(fs::symlink_metadata(folder.path("link")).unwrap().is_symlink());
    assert!(folder.read("behind/a.png").starts_with(b"\x89PNG"));
    assert_eq!(folder.read("behind/a.png"), folder.read("behind/b.png"));
    assert_eq!(fs::read_dir(folder.path("behind")).unwrap().count(), 2);
    assert_eq!(folder.names(), ["behind", "link", "link.png", "scene.nff"]);
}

#[cfg(unix)]
#[test]
fn an_output_to_a_device_leaves_the_device() {
    use std::os::unix::fs::FileTypeExt;
    let folder = Folder::with(EMPTY);
    std::os::unix::fs::symlink("/dev/null", folder.path("null.png")).unwrap();
    folder.done("render scene.nff -o null.png --stats-file /dev/null");
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    assert!(fs::symlink_metadata(folder.path("null.png")).unwrap().is_symlink());
    assert_eq!(folder.names(), ["null.png", "scene.nff"]);
}

#[cfg(target_os = "linux")]
#[test]
fn an_output_for_which_there_is_no_room_is_reported_with_status_74() {
    let folder = Folder::with(EMPTY);
    std::os::unix::fs::symlink("/dev/full", folder.path("full.png")).unwrap();
    folder.run("render scene.nff -o full.png").failed(74, "strahl: cannot write full.png: ");
    folder.run("render scene.nff --stats-file /dev/full").failed(74, "strahl: cannot write /dev/full: ");
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let ended = folder.command("render scene.nff --stats json").stdout(full).status().unwrap();
    assert_eq!(ended.code(), Some(74));
}

#[cfg(unix)]
#[test]
fn an_output_has_the_permissions_of_the_old_one_or_of_any_new_file() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::with(EMPTY);
    let mode = |name: &str| fs::metadata(folder.path(name)).unwrap().permissions().mode();
    folder.write("secret.png", "before");
    fs::set_permissions(folder.path("secret.png"), fs::Permissions::from_mode(0o600)).unwrap();
    folder.done("render scene.nff -o secret.png");
    folder.done("render scene.nff -o new.png");
    assert_eq!(mode("secret.png") & 0o777, 0o600);
    assert_eq!(mode("new.png"), mode("scene.nff"));
}
