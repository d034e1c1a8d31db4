//! Displayed diagnostics, stored in `shown/`. `STRAHL_ACCEPT=1` writes them.

use std::path::Path;

use strahl_scene::diagnostics::{Diagnostics, TerminalFeatures, TerminalStyle};

use crate::text::diagnostics;

/// A scene with five errors.
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

/// The displayed text without the folder, which depends on the machine.
fn shown(text: &str, screen: TerminalStyle) -> String {
    let list = diagnostics(text.as_bytes()).list().to_vec();
    Diagnostics::new(Path::new("first.toml"), text, list).render(screen) + "\n"
}

fn assert_stored(name: &str, shown: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/toml_scene/shown").join(name);
    if std::env::var_os("STRAHL_ACCEPT").is_some() {
        std::fs::write(&path, shown).unwrap();
    }
    assert_eq!(shown, std::fs::read_to_string(&path).unwrap_or_default(), "{name}");
}

#[test]
fn five_errors_are_displayed_in_plain_text() {
    assert_stored("five.txt", &shown(FIVE, TerminalStyle::PLAIN));
}

#[test]
fn diagnostics_fit_in_a_narrow_terminal() {
    let screen = TerminalStyle { width: 40, features: TerminalFeatures::Unicode };
    let text = shown(FIVE, screen);
    assert!(text.lines().all(|line| line.chars().count() <= 40), "{text}");
    assert_stored("narrow.txt", &text);
}

#[test]
fn both_locations_of_an_error_are_displayed() {
    let text = "[[material]]\nname = \"a\"\n\n\n\n\n[[material]]\nname = \"a\"\n";
    assert_stored(
        "twice.txt",
        &shown(text, TerminalStyle { width: 100, features: TerminalFeatures::Unicode }),
    );
}

#[test]
fn only_a_terminal_with_colors_gets_escape_codes() {
    let has_colors = |drawing| shown(FIVE, TerminalStyle { width: 80, features: drawing }).contains('\u{1b}');
    assert!(has_colors(TerminalFeatures::UnicodeColor) && has_colors(TerminalFeatures::AsciiColor));
    assert!(!has_colors(TerminalFeatures::Unicode) && !has_colors(TerminalFeatures::Ascii));
    assert!(shown(FIVE, TerminalStyle::PLAIN).is_ascii());
}

#[test]
fn a_thousand_errors_are_counted_and_the_first_are_displayed() {
    let text = diagnostics("[[sphere]]\nradius = -1\n".repeat(1000).as_bytes()).to_string();
    assert!(text.ends_with("a.toml: 1,000 errors, the first 50 shown"));
    assert_eq!(text.matches("must be more than 0").count(), 50);
}
