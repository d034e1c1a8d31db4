//! Sanitizing of untrusted text, and clipping of spans to it.

use std::ops::Range;

/// The text with control and bidirectional characters replaced by characters of the same length, so that byte positions do
/// not change.
pub fn sanitized(text: &str) -> String {
    let mut output = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let is_bidi_control =
            matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{200e}' | '\u{200f}');
        let is_line_end = matches!(c, '\n' | '\t') || c == '\r' && rest.peek() == Some(&'\n');
        output.push(match c.len_utf8() {
            1 if c.is_control() && !is_line_end => '?',
            2 if c.is_control() => '·',
            3 if is_bidi_control => '\u{fffd}',
            _ => c,
        });
    }
    output
}

/// The part of a span in its first line, at least one character if the text is not empty.
pub fn visible_span(text: &str, span: &Range<usize>) -> Range<usize> {
    let boundary = |position: usize| (0..=position.min(text.len())).rev().find(|p| text.is_char_boundary(*p));
    let mut start = boundary(span.start).unwrap_or(0);
    // A span at the end of a line, or in empty lines at the end of the text, moves to the character before.
    if text[start..].trim_start().is_empty() {
        start = text.trim_end().len();
    }
    if text[start..].is_empty() || text[start..].starts_with(['\r', '\n']) {
        let before = text[..start].chars().next_back().filter(|c| *c != '\n');
        start -= before.map_or(0, char::len_utf8);
    }
    let line = text[start..].lines().next().unwrap_or_default();
    let first = line.chars().next().map_or(0, char::len_utf8);
    let end = boundary(span.end).unwrap_or(0).min(start + line.len());
    start..if end > start { end } else { start + first }
}
