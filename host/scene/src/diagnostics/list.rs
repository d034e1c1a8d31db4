//! All errors of a text.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::diagnostic::Diagnostic;
use super::lines::LineIndex;
use super::visible::{sanitized, visible_span};

/// The maximum number of errors that are kept and displayed.
const MAX_SHOWN: usize = 50;

/// All errors of a text, with the text.
#[derive(Clone, Debug)]
pub struct Diagnostics {
    pub(super) path: PathBuf,
    pub(super) text: String,
    pub(super) lines: LineIndex,
    /// The first errors, in the order of their locations.
    pub(super) list: Vec<Diagnostic>,
    /// The number of errors found.
    pub(super) total: usize,
}

impl Diagnostics {
    /// The errors in the text of the file at `path`, in any order.
    pub fn new(path: &Path, text: &str, list: impl IntoIterator<Item = Diagnostic>) -> Self {
        let text = sanitized(text);
        let lines = LineIndex::new(&text);
        let mut list: Vec<Diagnostic> = list.into_iter().collect();
        list.sort_by_key(|diagnostic| diagnostic.span.start);
        let count = list.len();
        list.truncate(MAX_SHOWN);
        let mut diagnostics = Diagnostics { path: path.to_owned(), text, lines, list, total: count };
        for diagnostic in &mut diagnostics.list {
            diagnostic.span = visible_span(&diagnostics.text, &diagnostic.span);
            if let Some((span, _)) = &mut diagnostic.related {
                *span = visible_span(&diagnostics.text, span);
            }
        }
        diagnostics
    }

    /// Sets the number of errors found, if it is more than were given.
    pub fn with_total(mut self, count: usize) -> Self {
        self.total = self.total.max(count);
        self
    }

    /// The errors that are displayed: the first 50.
    pub fn list(&self) -> &[Diagnostic] {
        &self.list
    }

    /// The line and the column of an error, counted from 1.
    pub fn line_and_column(&self, diagnostic: &Diagnostic) -> (usize, usize) {
        (self.lines.line_number(diagnostic.span.start), self.column(diagnostic.span.start) + 1)
    }

    /// The number of characters before a byte position in its line.
    pub(super) fn column(&self, place: usize) -> usize {
        let start = self.lines.0[self.lines.index(place)];
        self.text[start..place].chars().filter(|c| *c != '\u{feff}').count()
    }

    /// The byte range of a line, counted from 0, without its line end.
    pub(super) fn line_range(&self, index: usize) -> Range<usize> {
        let start = self.lines.0[index];
        let end = self.lines.0.get(index + 1).map_or(self.text.len(), |next| next - 1);
        start..start + self.text[start..end].trim_end_matches('\r').len()
    }
}
