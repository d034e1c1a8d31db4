//! A sample of pixels that represents the picture.
//!
//! The picture is divided into equal cells, with one block of 4 x 4 pixels at a pseudorandom position in each (stratified
//! sampling). Pixels of a block share corners, so that their cost is that of pixels in the whole picture.

use strahl_core::image::Pixel;
use strahl_core::math::{Dimension, SobolSequence};
use strahl_core::{Resolution, Rgb, Tile};
use strahl_engine::cost_map::PixelSubset;
use strahl_engine::{CostMap, Mask, RenderOptions};
use strahl_picture::srgb::encode;
use strahl_settings::Settings;

/// Side length of a block, in pixels.
const BLOCK_SIDE: u32 = 4;
/// Approximate number of blocks.
const BLOCK_COUNT: f64 = 512.0;
/// Pictures of at most this number of pixels are used as a whole.
const SMALL_PICTURE: usize = 3 * 4096;
/// The 95 % quantile of the standard normal distribution.
const Z_95: f64 = 1.6449;

/// A sample of the pixels of a picture.
pub struct SparsePixels {
    mask: Mask,
    subset: PixelSubset,
    /// Pixel indices in the region, block by block.
    blocks: Vec<Vec<usize>>,
    /// Fraction of all requested pixels.
    sampled_fraction: f64,
}

/// An error estimated from sampled pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorEstimate {
    /// RMSE of sRGB-encoded values.
    pub error: f64,
    /// Upper bound of the RMSE of the whole picture, with 95 % confidence.
    pub upper_bound: f64,
}

impl SparsePixels {
    /// A sample of the requested pixels.
    pub fn new(settings: &Settings, options: &RenderOptions<'_>) -> Self {
        let area = settings.region_or_all();
        let all = area.pixels().filter(|pixel| options.is_requested(*pixel)).count();
        let tiles: Vec<Tile> = if all <= SMALL_PICTURE {
            area.tiles(BLOCK_SIDE).collect()
        } else {
            let cell = ((area.len() as f64 / BLOCK_COUNT).sqrt() as u32).max(BLOCK_SIDE);
            area.tiles(cell).map(|cell| block_in_cell(cell, area)).collect()
        };
        let inside = |tile: Tile| {
            let pixels = tile.pixels().filter(|pixel| options.is_requested(*pixel));
            pixels.filter_map(|pixel| area.index_of(pixel)).collect::<Vec<_>>()
        };
        let blocks: Vec<_> = tiles.into_iter().map(inside).filter(|indices| !indices.is_empty()).collect();
        let count: usize = blocks.iter().map(Vec::len).sum();
        let mask = block_mask(settings.size, area, &blocks);
        let subset = PixelSubset::of_mask(&mask);
        SparsePixels { mask, subset, blocks, sampled_fraction: count as f64 / all.max(1) as f64 }
    }

    /// Number of sampled pixels.
    pub fn pixel_count(&self) -> usize {
        self.blocks.iter().map(Vec::len).sum()
    }

    /// The sampled pixels.
    pub fn mask(&self) -> &Mask {
        &self.mask
    }

    /// Estimates the error of a picture. The bound follows from the variance between blocks.
    pub fn error_estimate(&self, picture: &[Rgb], reference: &[Rgb]) -> ErrorEstimate {
        let (mut sum, mut squares, mut pixels) = (0.0, 0.0, 0.0);
        for block in &self.blocks {
            let differences =
                block.iter().map(|index| squared_difference(picture[*index], reference[*index]));
            let of_block: f64 = differences.sum();
            sum += of_block;
            pixels += block.len() as f64;
            squares += of_block * of_block;
        }
        let count = self.blocks.len().max(1) as f64;
        let mean = sum / (3.0 * pixels.max(1.0));
        // Variance of the sum over blocks; the sampled fraction is known exactly.
        let variance = (squares / count - (sum / count) * (sum / count)).max(0.0)
            * (1.0 - self.sampled_fraction).max(0.0);
        let spread = (variance / count).sqrt() * count / (3.0 * pixels.max(1.0));
        ErrorEstimate { error: mean.sqrt(), upper_bound: (mean + Z_95 * spread).sqrt() }
    }

    /// An empty cost map for the sampled pixels.
    pub fn cost_map(&self) -> CostMap {
        CostMap::for_subset(self.mask.size, &self.subset)
    }
}

/// Sum of the squared differences of the sRGB-encoded channels of a pixel.
fn squared_difference(a: Rgb, b: Rgb) -> f64 {
    let square = |a: f32, b: f32| {
        let difference = encode(a) - encode(b);
        difference * difference
    };
    square(a.r, b.r) + square(a.g, b.g) + square(a.b, b.b)
}

/// RMSE of sRGB-encoded values over all pixels.
pub fn rmse(a: &[Rgb], b: &[Rgb]) -> f64 {
    let sum: f64 = a.iter().zip(b).map(|(a, b)| squared_difference(*a, *b)).sum();
    (sum / (3 * a.len().max(1)) as f64).sqrt()
}

/// A block at a pseudorandom position in a cell.
fn block_in_cell(cell: Tile, area: Tile) -> Tile {
    let Tile { top_left: Pixel { x, y }, width, height } = cell;
    let [u, v] = SobolSequence::new(x, y, 0, 0).sample_2d(Dimension::PIXEL);
    let place = |first: u32, length: u32, chance: f32| {
        first + (length.saturating_sub(BLOCK_SIDE - 1) as f32 * chance) as u32
    };
    let first = Pixel { x: place(x, width, u), y: place(y, height, v) };
    Tile { top_left: first, width: BLOCK_SIDE, height: BLOCK_SIDE }.intersection(area)
}

fn block_mask(size: Resolution, area: Tile, blocks: &[Vec<usize>]) -> Mask {
    let whole = Tile::full(size);
    let mut pixels = vec![false; whole.len()];
    for index in blocks.iter().flatten() {
        let (x, y) = (*index as u32 % area.width, *index as u32 / area.width);
        if let Some(index) = whole.index_of(Pixel { x: area.top_left.x + x, y: area.top_left.y + y }) {
            pixels[index] = true;
        }
    }
    Mask { size, pixels }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_of_a_small_picture_is_exact() {
        let settings = Settings { size: Resolution::new(101, 37).unwrap(), ..Settings::default() };
        let sparse = SparsePixels::new(&settings, &RenderOptions::default());
        assert_eq!(sparse.pixel_count(), 101 * 37);
        let (black, gray) = (vec![Rgb::BLACK; 101 * 37], vec![Rgb::gray(0.2140411); 101 * 37]);
        let estimate = sparse.error_estimate(&black, &gray);
        assert!((estimate.error - 0.5).abs() < 1e-5, "{estimate:?}");
        assert_eq!(estimate.error, estimate.upper_bound);
        assert!((rmse(&black, &gray) - estimate.error).abs() < 1e-12);
    }

    #[test]
    fn the_bound_holds_for_a_large_picture() {
        let size = Resolution::new(640, 480).unwrap();
        let sparse = SparsePixels::new(&Settings { size, ..Settings::default() }, &RenderOptions::default());
        let pixels = sparse.pixel_count();
        assert!((6000..12000).contains(&pixels), "{pixels}");
        // A large error in a fifth of the picture, a small one elsewhere.
        let reference = vec![Rgb::BLACK; 640 * 480];
        let mut picture = reference.clone();
        for (place, color) in picture.iter_mut().enumerate() {
            let (x, y) = (place % 640, place / 640);
            *color = Rgb::gray(if x * 2 + y < 420 { 0.1 } else { 0.001 * (x % 3) as f32 });
        }
        let (estimate, all) = (sparse.error_estimate(&picture, &reference), rmse(&picture, &reference));
        assert!(
            estimate.error < estimate.upper_bound && estimate.upper_bound < 1.2 * estimate.error,
            "{estimate:?}"
        );
        assert!(all < estimate.upper_bound && all > 0.9 * estimate.error, "{all} {estimate:?}");
    }

    #[test]
    fn only_requested_pixels_are_sampled() {
        let size = Resolution::new(300, 200).unwrap();
        let region = Tile { top_left: Pixel { x: 20, y: 10 }, width: 200, height: 150 };
        let settings = Settings { size, region: Some(region), ..Settings::default() };
        let sparse = SparsePixels::new(&settings, &RenderOptions::default());
        let mask = sparse.mask();
        let sampled: Vec<Pixel> = Tile::full(size).pixels().filter(|pixel| mask.contains(*pixel)).collect();
        assert!(sampled.len() > 2000 && sampled.iter().all(|pixel| region.index_of(*pixel).is_some()));
    }
}
