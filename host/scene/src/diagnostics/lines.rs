//! Line numbers of a text.

/// The start of each line of a text, in bytes.
#[derive(Clone, Debug)]
pub struct LineIndex(pub(super) Vec<usize>);

impl LineIndex {
    /// Finds the lines of `text`.
    pub fn new(text: &str) -> Self {
        LineIndex(std::iter::once(0).chain(text.match_indices('\n').map(|(end, _)| end + 1)).collect())
    }

    /// The line that contains a byte position, counted from 0.
    pub(super) fn index(&self, place: usize) -> usize {
        self.0.partition_point(|start| *start <= place).saturating_sub(1)
    }

    /// The line that contains a byte position, counted from 1.
    pub fn line_number(&self, place: usize) -> usize {
        self.index(place) + 1
    }
}
