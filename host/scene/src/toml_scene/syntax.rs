//! What is wrong with a text that is no TOML.
//!
//! The parser goes on after a mistake, so all of them are told; but one mistake may make it
//! stumble again. Of the mistakes in one line and in one value only the first is told, and of
//! what was read nothing that touches such a place.

use std::ops::Range;

use toml::de::{DeTable, DeValue, Error};

use crate::diagnostics::{Diagnostic, LineIndex};

/// More mistakes of the parser than anybody reads.
const MAX_ERRORS: usize = 100;

/// The parser's mistakes that count, and those of what `read` found wrong that do not follow
/// from them.
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

    // The lines that each mistake damages, and those that a damaged header leaves without a table.
    let mut damaged: Vec<Range<usize>> = Vec::new();
    let mut homeless: Vec<Range<usize>> = Vec::new();
    let mut list = Vec::new();
    // Beyond it nothing is known.
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
    let is_sound = |fault: &Diagnostic| {
        let (first, last) = (lines.line_number(fault.span.start), lines.line_number(fault.span.end));
        let apart = |damaged: &Range<usize>| last < damaged.start || first >= damaged.end;
        first < horizon && damaged.iter().chain(&homeless).all(apart)
    };
    list.extend(read.into_iter().filter(is_sound));
    list
}

fn start(error: &Error) -> usize {
    error.span().map_or(0, |span| span.start)
}

/// The places of all values, and of the headers of tables.
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
    let fault = Diagnostic::new(span, error.message());
    let is_word = !word.is_empty() && word.chars().all(|c| c.is_alphanumeric() || "_-#".contains(c));
    if error.message().starts_with("string values must be quoted") && is_word {
        fault.with_help(format!("write \"{word}\""))
    } else if error.message().starts_with("duplicate key") {
        fault.with_help("a key stands only once in a table; [[name]] begins another table of the same kind")
    } else {
        fault
    }
}
