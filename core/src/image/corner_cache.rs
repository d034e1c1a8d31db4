//! Caches of the samples at the corners of cells, which neighboring cells share.
//!
//! A cell is a pixel in adaptive supersampling, and a block of pixels in pixel-selected tracing. `w` times
//! `h` cells have `(w + 1) (h + 1)` corners. [`PretracedCorners`] has all of them, traced before in any order;
//! [`CornerRowCache`] stores one row. With both, no corner is traced twice. [`UncachedCorners`] stores nothing and leaves
//! it to the sampler's own cache, for cells that are not adjacent.

use super::pixel::{Pixel, Tile};
use super::sampler::Sampler;
use crate::trace::{PixelSample, RayTracer};

/// A cache of the samples at the corners of cells.
///
/// Cells have the coordinates of pixels or blocks; a corner has the coordinates of the cell whose upper left
/// corner it is.
pub trait CornerCache {
    /// Samples at the upper left, upper right, lower left and lower right corner of `cell`. `find` traces a
    /// corner.
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4];

    /// Removes all samples, before another picture. By default does nothing.
    fn reset(&mut self) {}
}

/// Coordinates of the corners of a cell, from the upper left to the lower right.
fn corner_pixels(Pixel { x, y }: Pixel) -> [Pixel; 4] {
    [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)].map(|(x, y)| Pixel { x, y })
}

/// A [`CornerCache`] that caches nothing: all four corners are traced for each cell, also those shared with a neighbor.
#[derive(Clone, Copy, Debug)]
pub struct UncachedCorners;

impl CornerCache for UncachedCorners {
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4] {
        corner_pixels(cell).map(find)
    }
}

/// A [`CornerCache`] with the samples at all corners of a rectangle of cells, which the caller has traced
/// before.
///
/// Corners outside of the rectangle are traced when they are needed.
///
/// ```
/// use strahl_core::image::{CornerCache, PretracedCorners, Pixel, Tile};
/// use strahl_core::trace::PixelSample;
///
/// let cells = Tile { top_left: Pixel { x: 0, y: 0 }, width: 2, height: 1 };
/// let corners = [PixelSample::BLACK; 3 * 2];
/// let mut grid = PretracedCorners::new(cells, &corners).unwrap();
/// let [upper_left, ..] = grid.corners(Pixel { x: 1, y: 0 }, &mut |_| unreachable!("all are cached"));
/// assert_eq!(upper_left, PixelSample::BLACK);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PretracedCorners<'m> {
    tile: Tile,
    corners: &'m [PixelSample],
}

impl<'m> PretracedCorners<'m> {
    /// The rectangle of the corners of `cells`: one wider and one higher, from the same upper left cell.
    pub fn corner_tile(cells: Tile) -> Tile {
        Tile { width: cells.width + 1, height: cells.height + 1, ..cells }
    }

    /// The grid of `corners`, row by row; `None` if its length is not that of [`PretracedCorners::corner_tile`].
    pub fn new(cells: Tile, corners: &'m [PixelSample]) -> Option<Self> {
        let tile = Self::corner_tile(cells);
        (corners.len() == tile.len()).then_some(PretracedCorners { tile, corners })
    }
}

impl CornerCache for PretracedCorners<'_> {
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4] {
        corner_pixels(cell).map(|corner| {
            let cached = self.tile.index_of(corner).and_then(|index| self.corners.get(index));
            cached.copied().unwrap_or_else(|| find(corner))
        })
    }
}

/// A [`CornerCache`] of one row of cells, in a caller-provided buffer.
///
/// If cells come row by row from left to right, no corner is traced twice. In any other order the samples
/// are the same, but some corners are traced again.
#[derive(Debug)]
pub struct CornerRowCache<'m> {
    /// Upper corners of the following cells, and lower corners of the preceding ones.
    row: &'m mut [PixelSample],
    /// The cell that shares corners with the previous one.
    expected_cell: Option<Pixel>,
    /// `x` of the first cell of the row.
    first_x: u32,
    /// Whether `row` has the upper corners of the following cells.
    has_row_above: bool,
    /// Sample at the lower right corner of the previous cell.
    previous_lower_right: PixelSample,
}

impl<'m> CornerRowCache<'m> {
    /// A cache for rows of `row.len() - 1` cells. If `row` is shorter than 2, it caches nothing.
    ///
    /// ```
    /// use strahl_core::image::{CornerCache, CornerRowCache, Pixel};
    /// use strahl_core::trace::PixelSample;
    ///
    /// let (mut samples, mut traced) = ([PixelSample::BLACK; 3], 0);
    /// let mut row = CornerRowCache::new(&mut samples);
    /// for x in 0..2 {
    ///     row.corners(Pixel { x, y: 0 }, &mut |_| {
    ///         traced += 1;
    ///         PixelSample::BLACK
    ///     });
    /// }
    /// assert_eq!(traced, 6); // of 8 corners of the two cells
    /// ```
    pub fn new(row: &'m mut [PixelSample]) -> Self {
        CornerRowCache {
            row,
            expected_cell: None,
            first_x: 0,
            has_row_above: false,
            previous_lower_right: PixelSample::BLACK,
        }
    }

    fn at(&self, index: u32) -> PixelSample {
        self.row.get(index as usize).copied().unwrap_or(PixelSample::BLACK)
    }

    fn set(&mut self, index: u32, sample: PixelSample) {
        if let Some(slot) = self.row.get_mut(index as usize) {
            *slot = sample;
        }
    }
}

impl CornerCache for CornerRowCache<'_> {
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4] {
        let width = self.row.len().saturating_sub(1) as u32;
        if self.expected_cell != Some(cell) {
            // No corner of this cell is known.
            (self.first_x, self.has_row_above) = (cell.x, false);
        }
        let [upper_left, upper_right, lower_left, lower_right] = corner_pixels(cell);
        let index = cell.x.saturating_sub(self.first_x);
        let is_first = index == 0;
        let upper_left = match (self.has_row_above, is_first) {
            (false, true) => find(upper_left),
            _ => self.at(index),
        };
        let upper_right = if self.has_row_above { self.at(index + 1) } else { find(upper_right) };
        let lower_left = if is_first { find(lower_left) } else { self.previous_lower_right };
        let lower_right = find(lower_right);

        self.set(index, lower_left);
        self.previous_lower_right = lower_right;
        self.expected_cell = if index + 1 < width {
            // The upper left corner of the next cell.
            self.set(index + 1, upper_right);
            Some(Pixel { x: cell.x + 1, y: cell.y })
        } else if width > 0 {
            self.set(index + 1, lower_right);
            self.has_row_above = true;
            Some(Pixel { x: self.first_x, y: cell.y + 1 })
        } else {
            None // no memory
        };
        [upper_left, upper_right, lower_left, lower_right]
    }

    fn reset(&mut self) {
        self.expected_cell = None;
    }
}

/// Samples the upper left pixel of a block of `stride` times `stride` pixels. Takes block coordinates
/// instead of those of a pixel.
///
/// Used for a pass before a [`PixelSelector`](super::PixelSelector): the caller renders the corners of all
/// blocks with this sampler into a buffer, and passes the buffer to [`PretracedCorners::new`].
#[derive(Clone, Copy, Debug)]
pub struct StridedSampler<S> {
    /// Sampler of the upper left pixels.
    pub sampler: S,
    /// Width and height of a block, in pixels.
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

    fn expected(cell: Pixel) -> [PixelSample; 4] {
        corner_pixels(cell).map(sample)
    }

    #[test]
    fn a_row_traces_each_corner_once() {
        for (w, h) in [(1, 1), (1, 4), (4, 1), (5, 3)] {
            let mut memory = [PixelSample::BLACK; 8];
            let mut row = CornerRowCache::new(&mut memory[..w as usize + 1]);
            let mut found = 0;
            let tile = Tile { top_left: Pixel { x: 2, y: 7 }, width: w, height: h };
            for cell in tile.pixels() {
                let mut find = |corner| {
                    found += 1;
                    sample(corner)
                };
                assert_eq!(row.corners(cell, &mut find), expected(cell), "{cell:?} of {w}x{h}");
            }
            assert_eq!(found, (w + 1) * (h + 1));
        }
    }

    #[test]
    fn a_row_is_correct_in_any_order() {
        let mut memory = [PixelSample::BLACK; 4];
        let mut row = CornerRowCache::new(&mut memory);
        for (x, y) in [(1, 0), (2, 0), (0, 1), (2, 0), (3, 0), (4, 0), (2, 1), (3, 1), (1, 2), (9, 9)] {
            let cell = Pixel { x, y };
            assert_eq!(row.corners(cell, &mut sample), expected(cell), "{cell:?}");
        }
    }

    #[test]
    fn a_grid_traces_only_corners_outside_of_it() {
        let cells = Tile { top_left: Pixel { x: 5, y: 1 }, width: 3, height: 2 };
        let mut memory = [PixelSample::BLACK; 12];
        for (slot, corner) in memory.iter_mut().zip(PretracedCorners::corner_tile(cells).pixels()) {
            *slot = sample(corner);
        }
        let mut grid = PretracedCorners::new(cells, &memory).unwrap();
        for cell in cells.pixels() {
            assert_eq!(grid.corners(cell, &mut |_| unreachable!()), expected(cell));
        }
        let outside = Pixel { x: 0, y: 0 };
        assert_eq!(grid.corners(outside, &mut sample), expected(outside));
        assert!(PretracedCorners::new(cells, &memory[..11]).is_none());
    }
}
