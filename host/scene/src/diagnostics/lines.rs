//! The lines of a text.

/// Where the lines of a text begin.
#[derive(Clone, Debug)]
pub struct Lines(pub(super) Vec<usize>);

impl Lines {
    /// Those of `text`.
    pub fn of(text: &str) -> Self {
        Lines(std::iter::once(0).chain(text.match_indices('\n').map(|(end, _)| end + 1)).collect())
    }

    /// The line of a place, counted from 0.
    pub(super) fn index(&self, place: usize) -> usize {
        self.0.partition_point(|start| *start <= place).saturating_sub(1)
    }

    /// The line of a place, counted from 1.
    pub fn line(&self, place: usize) -> usize {
        self.index(place) + 1
    }
}
