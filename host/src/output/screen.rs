//! Features of the terminal on which diagnostics are printed.

use std::io::{self, IsTerminal};

use strahl_scene::diagnostics::{TerminalFeatures, TerminalStyle};

/// Style of standard error. Colors are used on a terminal, unless `NO_COLOR` is set or the terminal is dumb.
pub fn of_stderr() -> TerminalStyle {
    if !io::stderr().is_terminal() {
        return TerminalStyle::PLAIN;
    }
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let has_colors = !is_set("NO_COLOR") && std::env::var("TERM").as_deref() != Ok("dumb");
    let drawing = match (is_utf8_locale(), has_colors) {
        (false, false) => TerminalFeatures::Ascii,
        (false, true) => TerminalFeatures::AsciiColor,
        (true, false) => TerminalFeatures::Unicode,
        (true, true) => TerminalFeatures::UnicodeColor,
    };
    let width = terminal_size::terminal_size_of(io::stderr()).map_or(80, |(width, _)| width.0.into());
    TerminalStyle { width, features: drawing }
}

/// Whether the locale supports UTF-8.
fn is_utf8_locale() -> bool {
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"].iter().find_map(|name| {
        let value = std::env::var(name).unwrap_or_default();
        (!value.is_empty()).then_some(value.to_ascii_uppercase())
    });
    match locale {
        Some(locale) => locale.contains("UTF-8") || locale.contains("UTF8"),
        None => cfg!(windows),
    }
}
