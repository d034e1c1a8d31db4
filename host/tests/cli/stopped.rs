//! Signals: the work ends soon, and nothing is left behind.

use std::process::{Command, Stdio};

use crate::program::{BALL, Folder, Running};

/// The exit status after a signal during a picture that would take days.
fn stopped_by(signal: &str, folder: &Folder, words: &str) -> Option<i32> {
    let before = folder.names();
    let words = format!("render scene.nff --size 4096x4096 --sampler regular:64 {words}");
    let mut running = Running::start(folder.command(&words).stdout(Stdio::null()).stderr(Stdio::null()));
    // When the new file is begun, signals are heard and tracing is about to begin.
    running.until(|| folder.names().iter().any(|name| name.starts_with(".strahl-")));
    let kill = format!("kill -s {signal} {}", running.number());
    assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
    let status = running.end();
    assert_eq!(folder.names(), before);
    status.code()
}

/// A ball of glass inside of a ball of mirror: one ray through the picture leads to 2^63.
const ENDLESS: &str = "\
v from 0 0 9 at 0 0 0 up 0 1 0 angle 30 resolution 8 6
l 5 5 5
f 1 1 1 0 1 0 0 0
s 0 0 0 10
f 1 1 1 0 0.5 0 0.5 1.5
s 0 0 0 8
";

#[test]
fn a_tree_of_rays_without_end_is_left_when_a_signal_comes_or_the_time_is_over() {
    let folder = Folder::with(ENDLESS);
    for (signal, status) in [("INT", 130), ("TERM", 75)] {
        for words in ["", "--select 4:0.1", "--stats text"] {
            let words = format!("--levels 64 --cutoff 0 {words}");
            assert_eq!(stopped_by(signal, &folder, &words), Some(status), "{words}");
        }
    }
    let deep = "scene.nff --levels 64 --cutoff 0";
    folder
        .run(&format!("render {deep} --time-limit 200ms"))
        .failed(75, "time limit exceeded; nothing was written");
    folder.run(&format!("explain {deep} 4,3")).failed(65, "fewer --levels");
    assert_eq!(folder.names(), ["scene.nff"]);
}

#[test]
fn an_interrupt_ends_with_130_and_leaves_nothing_behind() {
    let folder = Folder::with(BALL);
    assert_eq!(stopped_by("INT", &folder, ""), Some(130));
    assert_eq!(stopped_by("INT", &folder, "-o - --stats-file a.json"), Some(130));
}

#[test]
fn a_request_to_terminate_ends_with_75_and_leaves_nothing_behind() {
    let folder = Folder::with(BALL);
    assert_eq!(stopped_by("TERM", &folder, "--stats-file a.json"), Some(75));
    assert_eq!(stopped_by("TERM", &folder, "--threads 1"), Some(75));
}

#[test]
fn an_old_output_stays_when_a_signal_arrives() {
    let folder = Folder::with(BALL);
    folder.write("scene.png", "before");
    assert_eq!(stopped_by("INT", &folder, ""), Some(130));
    assert_eq!(folder.read("scene.png"), b"before");
}

#[test]
fn a_signal_ends_what_waits_for_rays() {
    let folder = Folder::with(BALL);
    for (signal, status) in [("INT", 130), ("TERM", 75)] {
        let mut command = folder.command("cast scene.nff -o hits.csv");
        let mut child = command.stdin(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let rays = child.stdin.take();
        let mut running = Running::of(child);
        running.until(|| folder.names().iter().any(|name| name.starts_with(".strahl-")));
        let kill = format!("kill -s {signal} {}", running.number());
        assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
        assert_eq!(running.end().code(), Some(status));
        assert_eq!(folder.names(), ["scene.nff"]);
        drop(rays);
    }
}
