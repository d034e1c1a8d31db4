//! The program from outside.

use std::process::{Command, Output};

fn strahl(folder: &std::path::Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_strahl")).args(args).current_dir(folder).output().unwrap()
}

#[test]
fn a_wrong_scene_has_a_status_and_plain_text_where_there_is_no_terminal() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.toml"), "[[sphere]]\nradius = -1\n[[plan]]\n").unwrap();
    let done = strahl(folder.path(), &["render", "a.toml"]);
    assert_eq!(done.status.code(), Some(65));
    assert!(done.stdout.is_empty());
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.is_ascii() && !said.contains('\u{1b}'), "{said}");
    for part in ["a.toml:2:10", "a.toml:3:3", "did you mean `plane`?", "\na.toml: 2 errors\n"] {
        assert!(said.contains(part), "{said}");
    }
    assert!(!folder.path().join("a.png").exists());
}

#[test]
fn a_scene_of_a_few_lines_becomes_a_picture_without_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let text = "[[sphere]]\nradius = 1\n[render]\nsize = [8, 6]\n";
    std::fs::write(folder.path().join("a.toml"), text).unwrap();
    let done = strahl(folder.path(), &["render", "a.toml", "--quiet"]);
    assert_eq!(done.status.code(), Some(0));
    assert!(done.stderr.is_empty(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(folder.path().join("a.png").exists());
}

#[test]
fn the_schema_is_printed() {
    let done = strahl(std::path::Path::new("."), &["schema"]);
    assert_eq!(done.status.code(), Some(0));
    assert_eq!(String::from_utf8(done.stdout).unwrap(), strahl_scene::toml_scene::schema());
}
