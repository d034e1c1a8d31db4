//! A picture that follows its scene.

use std::fs::File;
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::program::{BALL, Folder, Running};

const MESH: &str = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";

fn scene(color: &str) -> String {
    format!(
        "[render]\nsize = [24, 16]\n[[mesh]]\nfile = \"parts/a.obj\"\nmaterial = {{ color = \"{color}\" }}\n"
    )
}

/// A folder with a scene that names a mesh.
fn folder() -> Folder {
    let folder = Folder::with(BALL);
    folder.write("scene.toml", scene("gold"));
    std::fs::create_dir(folder.path("parts")).unwrap();
    folder.write("parts/a.obj", MESH);
    folder
}

/// The program that watches, what it says in the file `said`.
fn watching(folder: &Folder, words: &str) -> Running {
    let said = File::create(folder.path("said")).unwrap();
    Running::start(folder.command(&format!("watch {words}")).stdout(Stdio::null()).stderr(said))
}

fn said(folder: &Folder) -> String {
    String::from_utf8(folder.read("said")).unwrap()
}

/// A picture in which the leftmost pixels of each row are white, and the others black.
fn mask(width: usize, height: usize, white: usize) -> String {
    let row = "255 255 255\n".repeat(white) + &"0 0 0\n".repeat(width - white);
    format!("P3 {width} {height} 255\n{}", row.repeat(height))
}

/// Waits until the picture is the one that `render` makes of what is in the folder now.
fn until_current(running: &mut Running, folder: &Folder) {
    until_current_with(running, folder, "");
}

/// The same with these options.
fn until_current_with(running: &mut Running, folder: &Folder, options: &str) {
    folder.done(&format!("render scene.toml --quiet -o expected.png {options}"));
    let expected = folder.read("expected.png");
    running.until(|| std::fs::read(folder.path("scene.png")).is_ok_and(|picture| picture == expected));
}

fn kill(running: &Running, signal: &str) {
    let kill = format!("kill -s {signal} {}", running.number());
    assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
}

#[test]
fn every_save_of_the_scene_and_of_what_it_names_gives_a_new_picture() {
    let folder = folder();
    let mut running = watching(&folder, "scene.toml --quiet");
    until_current(&mut running, &folder);
    folder.write("scene.toml", scene("navy"));
    until_current(&mut running, &folder);
    folder.write("parts/a.obj", MESH.replace("v 0 1", "v 0.5 0.25"));
    until_current(&mut running, &folder);
    // As editors save: another file in the same place.
    folder.write("new", scene("tomato"));
    std::fs::rename(folder.path("new"), folder.path("scene.toml")).unwrap();
    until_current(&mut running, &folder);
    assert_eq!(said(&folder), "");
}

#[test]
fn every_save_of_the_mask_gives_a_new_picture() {
    const WITH: &str = "--mask masks/a.ppm";
    let folder = folder();
    std::fs::create_dir(folder.path("masks")).unwrap();
    folder.write("masks/a.ppm", mask(24, 16, 12));
    let mut running = watching(&folder, &format!("scene.toml --quiet {WITH}"));
    until_current_with(&mut running, &folder, WITH);
    let half = folder.read("scene.png");
    folder.write("masks/a.ppm", mask(24, 16, 18));
    until_current_with(&mut running, &folder, WITH);
    assert_ne!(folder.read("scene.png"), half);
    folder.write("scene.toml", scene("navy"));
    until_current_with(&mut running, &folder, WITH);
    folder.write("new", mask(24, 16, 15));
    std::fs::rename(folder.path("new"), folder.path("masks/a.ppm")).unwrap();
    until_current_with(&mut running, &folder, WITH);
    assert_eq!(said(&folder), "");
}

#[test]
fn a_mask_that_does_not_fit_or_is_gone_is_reported_and_waited_for() {
    const WITH: &str = "--mask a.ppm";
    let folder = folder();
    folder.write("a.ppm", mask(24, 16, 12));
    let mut running = watching(&folder, &format!("scene.toml --quiet {WITH}"));
    until_current_with(&mut running, &folder, WITH);
    let before = folder.read("scene.png");
    folder.write("a.ppm", mask(12, 16, 12));
    running.until(|| said(&folder).contains("a.ppm: the mask is 12x16 pixels, but the picture is 24x16"));
    std::fs::remove_file(folder.path("a.ppm")).unwrap();
    running.until(|| said(&folder).contains("cannot read a.ppm"));
    assert_eq!(folder.read("scene.png"), before);
    folder.write("a.ppm", mask(24, 16, 18));
    until_current_with(&mut running, &folder, WITH);
    assert_ne!(folder.read("scene.png"), before);
}

#[test]
fn what_is_wrong_is_reported_and_the_picture_waits_until_it_is_right() {
    let folder = folder();
    let mut running = watching(&folder, "scene.toml");
    until_current(&mut running, &folder);
    let before = folder.read("scene.png");
    folder.write("scene.toml", scene("gold").replace("size", "siez"));
    running.until(|| said(&folder).contains("scene.toml: 1 error"));
    // A file that is named and missing is waited for, and its folder too.
    std::fs::remove_dir_all(folder.path("parts")).unwrap();
    folder.write("scene.toml", scene("navy"));
    running.until(|| said(&folder).contains("cannot load this mesh"));
    assert_eq!(folder.read("scene.png"), before);
    std::fs::create_dir(folder.path("parts")).unwrap();
    folder.write("parts/a.obj", MESH);
    until_current(&mut running, &folder);
}

#[test]
fn nothing_happens_when_a_file_is_saved_as_it_was() {
    let folder = folder();
    let mut running = watching(&folder, "scene.toml");
    until_current(&mut running, &folder);
    folder.write("scene.toml", scene("gold"));
    std::thread::sleep(Duration::from_millis(300));
    folder.write("scene.toml", scene("navy"));
    until_current(&mut running, &folder);
    running.until(|| said(&folder).matches("rays  ").count() >= 2);
    kill(&running, "INT");
    running.end();
    let text = said(&folder);
    assert_eq!(text.matches("scene.png").count(), 2, "{text}");
}

#[test]
fn a_coarse_picture_comes_first_and_a_change_ends_the_work_on_the_full_one() {
    let folder = Folder::with(BALL);
    // The full picture would take days.
    let mut running = watching(&folder, "scene.nff --size 512x384 --sampler regular:255");
    let picture = || image::open(folder.path("scene.png")).ok().map(|picture| picture.to_rgb8());
    running.until(|| picture().is_some());
    let draft = picture().unwrap();
    assert_eq!(draft.dimensions(), (512, 384));
    for (x, y, pixel) in draft.enumerate_pixels() {
        assert_eq!(pixel, draft.get_pixel(x / 4 * 4, y / 4 * 4), "{x} {y}");
    }
    folder.write("scene.nff", BALL.replace("b 0.25 0.5 1", "b 1 0 0"));
    running.until(|| picture().is_some_and(|now| now != draft));
}

#[test]
fn an_interrupt_ends_it_with_130_and_a_request_to_terminate_with_75() {
    for (signal, status) in [("INT", 130), ("TERM", 75)] {
        let folder = folder();
        let mut running = watching(&folder, "scene.toml --quiet");
        until_current(&mut running, &folder);
        kill(&running, signal);
        assert_eq!(running.end().code(), Some(status));
        assert_eq!(said(&folder), "");
        assert!(folder.names().iter().all(|name| !name.starts_with('.')), "{:?}", folder.names());
    }
}

#[test]
fn what_cannot_be_watched_is_refused() {
    let folder = folder();
    folder.run("watch none.toml").failed(66, "cannot read none.toml");
    folder.run("watch scene.toml -o -").failed(2, "needs an output file");
    folder.run("watch /dev/null").failed(2, "not a regular file");
    folder.run("watch scene.toml -o none/a.png").failed(74, "none/a.png");
    folder.run("watch scene.toml --mask none.ppm").failed(66, "cannot read none.ppm");
    folder.run("watch scene.toml --mask -").failed(2, "needs a mask file");
    folder.run("watch scene.toml --mask /dev/null").failed(2, "not a regular file");
    // Each picture would be the mask of the next.
    folder.done("render scene.toml -q");
    folder.done("render scene.toml -q -o a.ppm");
    folder.run("watch scene.toml --mask scene.png").failed(2, "would overwrite");
    folder.run("watch scene.toml --mask a.ppm -o ./a.ppm").failed(2, "would overwrite");
}
