//! Everything that is wrong in a text.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::diagnostic::Diagnostic;
use super::lines::LineIndex;
use super::visible::{sanitized, visible_span};

/// More than anybody reads.
const MAX_SHOWN: usize = 50;

/// Everything that is wrong in a text.
#[derive(Clone, Debug)]
pub struct Diagnostics {
    pub(super) path: PathBuf,
    pub(super) text: String,
    pub(super) lines: LineIndex,
    /// The first of them.
    pub(super) list: Vec<Diagnostic>,
    /// How many there are.
    pub(super) total: usize,
}

impl Diagnostics {
    /// The faults of the text of a file, in the order of their places.
    pub fn new(path: &Path, text: &str, list: impl IntoIterator<Item = Diagnostic>) -> Self {
        let text = sanitized(text);
        let lines = LineIndex::new(&text);
        let mut list: Vec<Diagnostic> = list.into_iter().collect();
        list.sort_by_key(|fault| fault.span.start);
        let count = list.len();
        list.truncate(MAX_SHOWN);
        let mut faults = Diagnostics { path: path.to_owned(), text, lines, list, total: count };
        for fault in &mut faults.list {
            fault.span = visible_span(&faults.text, &fault.span);
            if let Some((span, _)) = &mut fault.related {
                *span = visible_span(&faults.text, span);
            }
        }
        faults
    }

    /// The same, where more have been found than were kept.
    pub fn with_total(mut self, count: usize) -> Self {
        self.total = self.total.max(count);
        self
    }

    /// The first of them, as many as are shown.
    pub fn list(&self) -> &[Diagnostic] {
        &self.list
    }

    /// The line and the column of a fault, counted from 1.
    pub fn line_and_column(&self, fault: &Diagnostic) -> (usize, usize) {
        (self.lines.line_number(fault.span.start), self.column(fault.span.start) + 1)
    }

    /// The characters before a place in its line.
    pub(super) fn column(&self, place: usize) -> usize {
        let start = self.lines.0[self.lines.index(place)];
        self.text[start..place].chars().filter(|c| *c != '\u{feff}').count()
    }

    /// The line at this index without its end.
    pub(super) fn line_range(&self, index: usize) -> Range<usize> {
        let start = self.lines.0[index];
        let end = self.lines.0.get(index + 1).map_or(self.text.len(), |next| next - 1);
        start..start + self.text[start..end].trim_end_matches('\r').len()
    }
}
