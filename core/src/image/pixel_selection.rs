//! The blocks of pixel-selected tracing.

use super::contrast::ContrastThreshold;
use super::corner_cache::StridedSampler;
use super::pixel::{Pixel, Tile};
use super::quadtree::MAX_DEPTH;
use super::sampler::Sampler;

/// Settings of a [`PixelSelector`](super::PixelSelector): the grid of pixels that are traced first, and the
/// contrast up to which the others are interpolated.
///
/// ```
/// use strahl_core::image::{ContrastThreshold, PixelSelection};
///
/// let threshold = ContrastThreshold::new(0.1).unwrap();
/// assert_eq!(PixelSelection::new(8, threshold).unwrap().step(), 8);
/// assert!(PixelSelection::new(6, threshold).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSelection {
    pub(super) depth: u8,
    pub(super) threshold: ContrastThreshold,
}

impl PixelSelection {
    /// Largest step: width and height of a block, in pixels.
    pub const MAX_STEP: u32 = 1 << MAX_DEPTH;

    /// Traces one pixel of each block of `step` times `step` first; `None` if `step` is not a power of two in
    /// `2..=`[`PixelSelection::MAX_STEP`].
    pub fn new(step: u32, threshold: ContrastThreshold) -> Option<Self> {
        let is_step = step >= 2 && step <= Self::MAX_STEP && step.is_power_of_two();
        is_step.then_some(PixelSelection { depth: step.trailing_zeros() as u8, threshold })
    }

    /// Width and height of a block, in pixels.
    pub fn step(&self) -> u32 {
        1 << self.depth
    }

    /// Sides of the squares of each refinement pass, in pixels: from whole blocks down to 1.
    pub fn refinement_sides(&self) -> impl Iterator<Item = u32> + use<> {
        let depth = self.depth;
        (0..=depth).map(move |pass| 1 << (depth - pass))
    }

    /// The rectangle of blocks that have pixels of `tile`, in block coordinates.
    pub fn block_range(&self, tile: Tile) -> Tile {
        let Tile { top_left: first, width, height } = tile;
        // From the block of the first pixel to that of the last.
        let overlap = |first: u32, length: u32| {
            let start = first >> self.depth;
            (start, if length > 0 { ((first + length - 1) >> self.depth) + 1 - start } else { 0 })
        };
        let ((x, width), (y, height)) = (overlap(first.x, width), overlap(first.y, height));
        Tile { top_left: Pixel { x, y }, width, height }
    }

    /// The rectangle of the pixels of a rectangle of blocks. `blocks`: in block coordinates.
    pub fn pixels_of(&self, blocks: Tile) -> Tile {
        let [x, y, width, height] = [blocks.top_left.x, blocks.top_left.y, blocks.width, blocks.height]
            .map(|blocks| blocks << self.depth);
        Tile { top_left: Pixel { x, y }, width, height }
    }

    /// A sampler for a first pass over the blocks: the pixel at block coordinates `(x, y)` is the upper left
    /// pixel of that block, sampled with `sampler`.
    ///
    /// Render [`PretracedCorners::corner_tile`] with it into a buffer, and pass the buffer to
    /// [`PretracedCorners::new`].
    ///
    /// [`PretracedCorners::corner_tile`]: super::PretracedCorners::corner_tile
    /// [`PretracedCorners::new`]: super::PretracedCorners::new
    pub fn first_pass_sampler<S: Sampler>(&self, sampler: S) -> StridedSampler<S> {
        StridedSampler { sampler, stride: self.step() }
    }
}
