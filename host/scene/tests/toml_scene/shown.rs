//! Mistakes as they are shown, kept as files in `shown/`. `STRAHL_ACCEPT=1` writes them anew.

use std::path::Path;

use strahl_scene::diagnostics::{Diagnostics, TerminalFeatures, TerminalStyle};

use crate::text::faults;

/// A first scene with five mistakes.
const FIVE: &str = r#"[camera]
from = [3, 2, 6]
at = [0, 1, 0]
up = [-3, -1, -6]

[[plane]]
material = { checker = { even = "ivori" } }

[[sphere]]
centre = [0, 1, 0]
radius = 0
material = "tomato"
"#;

/// The same on every machine: without the folder's name.
fn shown(text: &str, screen: TerminalStyle) -> String {
    let list = faults(text.as_bytes()).list().to_vec();
    Diagnostics::new(Path::new("first.toml"), text, list).render(screen) + "\n"
}

fn assert_kept(name: &str, shown: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/toml_scene/shown").join(name);
    if std::env::var_os("STRAHL_ACCEPT").is_some() {
        std::fs::write(&path, shown).unwrap();
    }
    assert_eq!(shown, std::fs::read_to_string(&path).unwrap_or_default(), "{name}");
}

#[test]
fn five_mistakes_are_shown_in_plain_text() {
    assert_kept("five.txt", &shown(FIVE, TerminalStyle::PLAIN));
}

#[test]
fn a_narrow_screen_is_kept_to() {
    let screen = TerminalStyle { width: 40, features: TerminalFeatures::Unicode };
    let text = shown(FIVE, screen);
    assert!(text.lines().all(|line| line.chars().count() <= 40), "{text}");
    assert_kept("narrow.txt", &text);
}

#[test]
fn two_places_of_one_mistake_are_both_shown() {
    let text = "[[material]]\nname = \"a\"\n\n\n\n\n[[material]]\nname = \"a\"\n";
    assert_kept("twice.txt", &shown(text, TerminalStyle { width: 100, features: TerminalFeatures::Unicode }));
}

#[test]
fn only_a_screen_with_colours_gets_them() {
    let has_colors = |drawing| shown(FIVE, TerminalStyle { width: 80, features: drawing }).contains('\u{1b}');
    assert!(has_colors(TerminalFeatures::UnicodeColor) && has_colors(TerminalFeatures::AsciiColor));
    assert!(!has_colors(TerminalFeatures::Unicode) && !has_colors(TerminalFeatures::Ascii));
    assert!(shown(FIVE, TerminalStyle::PLAIN).is_ascii());
}

#[test]
fn a_thousand_mistakes_are_counted_and_the_first_are_shown() {
    let text = faults("[[sphere]]\nradius = -1\n".repeat(1000).as_bytes()).to_string();
    assert!(text.ends_with("a.toml: 1,000 errors, the first 50 shown"));
    assert_eq!(text.matches("must be more than 0").count(), 50);
}
