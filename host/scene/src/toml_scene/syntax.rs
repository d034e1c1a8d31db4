//! TOML syntax errors.
//!
//! The parser continues after an error, so that all errors are reported; but one error may cause others. Only the first
//! error in a line and in a value is reported, and errors in values only if they do not overlap a syntax error.

use std::ops::Range;

use toml::de::{DeTable, DeValue, Error};

use crate::diagnostics::{Diagnostic, LineIndex};

/// The maximum number of syntax errors that are kept.
const MAX_ERRORS: usize = 100;

/// The syntax errors that do not follow from others, and the errors in `read` that do not follow from syntax errors.
pub fn diagnostics(
    text: &str,
    document: &DeValue<'_>,
    errors: Vec<Error>,
    read: Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    let lines = LineIndex::new(text);
    let mut values = Vec::new();
    if let DeValue::Table(table) = document {
        collect(table, &mut values);
    }
    let mut errors = errors;
    errors.sort_by_key(start);

    // The lines that each error affects, and those that follow a damaged table header.
    let mut damaged: Vec<Range<usize>> = Vec::new();
    let mut homeless: Vec<Range<usize>> = Vec::new();
    let mut list = Vec::new();
    // Errors after this line are dropped.
    let mut horizon = usize::MAX;
    let is_header: Vec<bool> = text.lines().map(|line| line.trim_start().starts_with('[')).collect();
    for error in errors {
        let (place, line) = (start(&error), lines.line_number(start(&error)));
        if damaged.last().is_some_and(|damaged| line < damaged.end) {
            continue;
        }
        if list.len() == MAX_ERRORS {
            horizon = line;
            break;
        }
        let touches = |value: &&Range<usize>| value.start <= place && place <= value.end;
        let last = values.iter().filter(touches).map(|value| lines.line_number(value.end)).max();
        if is_header.get(line - 1) == Some(&true) {
            let next = (line..is_header.len()).find(|index| is_header[*index]);
            homeless.push(line..next.unwrap_or(is_header.len()) + 1);
        }
        damaged.push(line..last.unwrap_or(line).max(line) + 1);
        list.push(diagnostic(text, &error));
    }
    let is_sound = |diagnostic: &Diagnostic| {
        let (first, last) =
            (lines.line_number(diagnostic.span.start), lines.line_number(diagnostic.span.end));
        let apart = |damaged: &Range<usize>| last < damaged.start || first >= damaged.end;
        first < horizon && damaged.iter().chain(&homeless).all(apart)
    };
    list.extend(read.into_iter().filter(is_sound));
    list
}

fn start(error: &Error) -> usize {
    error.span().map_or(0, |span| span.start)
}

/// The spans of all values, and of table headers.
fn collect(table: &DeTable<'_>, values: &mut Vec<Range<usize>>) {
    for (_, value) in table.iter() {
        values.push(value.span());
        match value.get_ref() {
            DeValue::Table(table) => collect(table, values),
            DeValue::Array(list) => {
                for value in list.iter() {
                    values.push(value.span());
                    if let DeValue::Table(table) = value.get_ref() {
                        collect(table, values);
                    }
                }
            }
            _ => {}
        }
    }
}

fn diagnostic(text: &str, error: &Error) -> Diagnostic {
    let span = error.span().unwrap_or(0..0);
    let word = text.get(span.clone()).unwrap_or_default();
    let diagnostic = Diagnostic::new(span, error.message());
    let is_word = !word.is_empty() && word.chars().all(|c| c.is_alphanumeric() || "_-#".contains(c));
    if error.message().starts_with("string values must be quoted") && is_word {
        diagnostic.with_help(format!("write \"{word}\""))
    } else if error.message().starts_with("duplicate key") {
        diagnostic.with_help("a key may appear only once in a table; [[name]] starts another one")
    } else {
        diagnostic
    }
}
