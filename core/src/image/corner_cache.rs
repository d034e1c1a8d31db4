//! The corners of cells, which neighbours share. A cell is a pixel in adaptive supersampling,
//! and a block of pixels in pixel-selected tracing.
//!
//! `w` times `h` cells have `(w + 1) (h + 1)` corners. Two ways to trace none of them twice:
//! with memory for all of them ([`Lattice`], which is filled in any order, tile by tile if need
//! be), or with memory for one row ([`CornerRow`]). Or nothing is kept here ([`Loose`]) and
//! everything comes from the sampler's own memory of places, which suits scattered cells.

use super::pixel::{Pixel, Tile};
use super::sampler::Sampler;
use crate::trace::{PixelSample, RayTracer};

/// Somebody who knows what is seen at the corners of cells.
///
/// A cell is named like a pixel, a corner like the cell whose upper left corner it is.
pub trait CornerCache {
    /// Upper left, upper right, lower left and lower right corner of `cell`. `find` says what is
    /// seen at a corner.
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4];

    /// A new picture begins: what was kept of another is forgotten.
    fn reset(&mut self) {}
}

/// The names of a cell's corners, from the upper left to the lower right.
fn corner_pixels(Pixel { x, y }: Pixel) -> [Pixel; 4] {
    [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)].map(|(x, y)| Pixel { x, y })
}

/// Keeps nothing.
#[derive(Clone, Copy, Debug)]
pub struct Uncached;

impl CornerCache for Uncached {
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4] {
        corner_pixels(cell).map(find)
    }
}

/// The corners of all cells of a rectangle, already traced.
#[derive(Clone, Copy, Debug)]
pub struct CornerGrid<'m> {
    tile: Tile,
    corners: &'m [PixelSample],
}

impl<'m> CornerGrid<'m> {
    /// The rectangle of all corners of the cells `cells`: one wider and higher.
    pub fn corner_tile(cells: Tile) -> Tile {
        Tile { width: cells.width + 1, height: cells.height + 1, ..cells }
    }

    /// The corners of `cells`, row by row; none when they are not as many as
    /// [`Lattice::tile`] has.
    pub fn new(cells: Tile, corners: &'m [PixelSample]) -> Option<Self> {
        let tile = Self::corner_tile(cells);
        (corners.len() == tile.len()).then_some(CornerGrid { tile, corners })
    }
}

impl CornerCache for CornerGrid<'_> {
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4] {
        corner_pixels(cell).map(|corner| {
            let kept = self.tile.index_of(corner).and_then(|place| self.corners.get(place));
            kept.copied().unwrap_or_else(|| find(corner))
        })
    }
}

/// The corners of one row of cells, in lent memory.
///
/// Cells that come row by row, each row from its first to its last, share all their corners.
/// In any other order they are right as well, but some corners are found again.
#[derive(Debug)]
pub struct CornerRow<'m> {
    /// The corners above the cells to come, and below those that have been.
    row: &'m mut [PixelSample],
    /// The cell that shares corners with the last one.
    expected_cell: Option<Pixel>,
    first_x: u32,
    /// Whether `row` holds the corners above the cells to come.
    has_row_above: bool,
    /// The last cell's lower right corner.
    previous_lower_right: PixelSample,
}

impl<'m> CornerRow<'m> {
    /// For rows of `row.len() - 1` cells. With less than two corners it remembers nothing, and
    /// asks for all four of every cell.
    pub fn new(row: &'m mut [PixelSample]) -> Self {
        CornerRow {
            row,
            expected_cell: None,
            first_x: 0,
            has_row_above: false,
            previous_lower_right: PixelSample::BLACK,
        }
    }

    fn at(&self, place: u32) -> PixelSample {
        self.row.get(place as usize).copied().unwrap_or(PixelSample::BLACK)
    }

    fn set(&mut self, place: u32, sample: PixelSample) {
        if let Some(slot) = self.row.get_mut(place as usize) {
            *slot = sample;
        }
    }
}

impl CornerCache for CornerRow<'_> {
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4] {
        let width = self.row.len().saturating_sub(1) as u32;
        if self.expected_cell != Some(cell) {
            // A new beginning: only the corners of this cell are needed, and none is known.
            (self.first_x, self.has_row_above) = (cell.x, false);
        }
        let [upper_left, upper_right, lower_left, lower_right] = corner_pixels(cell);
        let place = cell.x.saturating_sub(self.first_x);
        let begins = place == 0;
        let upper_left = match (self.has_row_above, begins) {
            (false, true) => find(upper_left),
            _ => self.at(place),
        };
        let upper_right = if self.has_row_above { self.at(place + 1) } else { find(upper_right) };
        let lower_left = if begins { find(lower_left) } else { self.previous_lower_right };
        let lower_right = find(lower_right);

        self.set(place, lower_left);
        self.previous_lower_right = lower_right;
        self.expected_cell = if place + 1 < width {
            // The upper left corner of the next cell.
            self.set(place + 1, upper_right);
            Some(Pixel { x: cell.x + 1, y: cell.y })
        } else if width > 0 {
            self.set(place + 1, lower_right);
            self.has_row_above = true;
            Some(Pixel { x: self.first_x, y: cell.y + 1 })
        } else {
            None // there is no room to remember anything
        };
        [upper_left, upper_right, lower_left, lower_right]
    }

    fn reset(&mut self) {
        self.expected_cell = None;
    }
}

/// What fills a [`Lattice`]: what `S` sees in the pixel that is the upper left corner of each
/// cell of `side` times `side` pixels.
#[derive(Clone, Copy, Debug)]
pub struct StridedSampler<S> {
    /// Sees.
    pub sampler: S,
    /// Pixels along one side of a cell.
    pub stride: u32,
}

impl<S: Sampler> Sampler for StridedSampler<S> {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, Pixel { x, y }: Pixel, tracer: &mut R) -> PixelSample {
        self.sampler
            .sample_pixel(Pixel { x: x.wrapping_mul(self.stride), y: y.wrapping_mul(self.stride) }, tracer)
    }

    fn reset(&mut self) {
        self.sampler.reset();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Real, Rgb};
    use crate::trace::HitId;

    fn sample(Pixel { x, y }: Pixel) -> PixelSample {
        PixelSample { color: Rgb::new((x * y) as Real, x as Real, (y * y) as Real), hit: HitId::Nothing }
    }

    fn truth(cell: Pixel) -> [PixelSample; 4] {
        corner_pixels(cell).map(sample)
    }

    #[test]
    fn a_row_of_memory_finds_each_corner_once() {
        for (w, h) in [(1, 1), (1, 4), (4, 1), (5, 3)] {
            let mut memory = [PixelSample::BLACK; 8];
            let mut row = CornerRow::new(&mut memory[..w as usize + 1]);
            let mut found = 0;
            let tile = Tile { top_left: Pixel { x: 2, y: 7 }, width: w, height: h };
            for cell in tile.pixels() {
                let mut find = |corner| {
                    found += 1;
                    sample(corner)
                };
                assert_eq!(row.corners(cell, &mut find), truth(cell), "{cell:?} of {w}x{h}");
            }
            assert_eq!(found, (w + 1) * (h + 1));
        }
    }

    #[test]
    fn a_row_of_memory_is_right_in_any_order() {
        let mut memory = [PixelSample::BLACK; 4];
        let mut row = CornerRow::new(&mut memory);
        for (x, y) in [(1, 0), (2, 0), (0, 1), (2, 0), (3, 0), (4, 0), (2, 1), (3, 1), (1, 2), (9, 9)] {
            let cell = Pixel { x, y };
            assert_eq!(row.corners(cell, &mut sample), truth(cell), "{cell:?}");
        }
    }

    #[test]
    fn a_lattice_gives_the_same_and_finds_only_what_lies_outside() {
        let cells = Tile { top_left: Pixel { x: 5, y: 1 }, width: 3, height: 2 };
        let mut memory = [PixelSample::BLACK; 12];
        for (slot, corner) in memory.iter_mut().zip(CornerGrid::corner_tile(cells).pixels()) {
            *slot = sample(corner);
        }
        let mut lattice = CornerGrid::new(cells, &memory).unwrap();
        for cell in cells.pixels() {
            assert_eq!(lattice.corners(cell, &mut |_| unreachable!()), truth(cell));
        }
        let outside = Pixel { x: 0, y: 0 };
        assert_eq!(lattice.corners(outside, &mut sample), truth(outside));
        assert!(CornerGrid::new(cells, &memory[..11]).is_none());
    }
}
