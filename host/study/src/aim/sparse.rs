//! Some pixels that stand for all of a picture.
//!
//! The picture is cut into equal cells, and in each a square of four times four pixels is looked at,
//! somewhere: so the squares lie evenly and follow no raster. Within a square the corners of pixels
//! are shared, so that it costs what it costs in the whole picture.

use strahl_core::image::Pixel;
use strahl_core::math::{Dimension, SobolSequence};
use strahl_core::{Resolution, Rgb, Tile};
use strahl_engine::cost_map::ChosenPixels;
use strahl_engine::{CostMap, Mask, RenderOptions};
use strahl_picture::srgb::encode;
use strahl_settings::Settings;

/// Pixels along a side of a square.
const BLOCK_SIDE: u32 = 4;
/// How many squares there are, about.
const BLOCK_COUNT: f64 = 512.0;
/// A picture of so few pixels is looked at as a whole.
const SMALL_PICTURE: usize = 3 * 4096;
/// How many standard errors the mean square may be more than it was on the sample: a confidence of
/// 95 %.
const Z_95: f64 = 1.6449;

/// Some pixels of a picture.
pub struct SparsePixels {
    mask: Mask,
    subset: ChosenPixels,
    /// Their places in the picture, square by square.
    blocks: Vec<Vec<usize>>,
    /// Which share of all pixels they are.
    sampled_fraction: f64,
}

/// An error, as far as some pixels tell it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorEstimate {
    /// The root of the mean square of sRGB-encoded differences.
    pub error: f64,
    /// What that of the whole picture is at most, with a confidence of 95 %.
    pub upper_bound: f64,
}

impl SparsePixels {
    /// Of the pixels that are requested.
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
            let places = tile.pixels().filter(|pixel| options.is_requested(*pixel));
            places.filter_map(|pixel| area.index_of(pixel)).collect::<Vec<_>>()
        };
        let squares: Vec<_> = tiles.into_iter().map(inside).filter(|places| !places.is_empty()).collect();
        let count: usize = squares.iter().map(Vec::len).sum();
        let mask = mask(settings.size, area, &squares);
        let chosen = ChosenPixels::by(&mask);
        SparsePixels {
            mask,
            subset: chosen,
            blocks: squares,
            sampled_fraction: count as f64 / all.max(1) as f64,
        }
    }

    /// How many they are.
    pub fn pixel_count(&self) -> usize {
        self.blocks.iter().map(Vec::len).sum()
    }

    /// These pixels.
    pub fn mask(&self) -> &Mask {
        &self.mask
    }

    /// How far a picture is from another. Squares that differ much from each other make it uncertain.
    pub fn error_estimate(&self, picture: &[Rgb], reference: &[Rgb]) -> ErrorEstimate {
        let (mut sum, mut squares, mut pixels) = (0.0, 0.0, 0.0);
        for square in &self.blocks {
            let differences =
                square.iter().map(|place| squared_difference(picture[*place], reference[*place]));
            let of_square: f64 = differences.sum();
            sum += of_square;
            pixels += square.len() as f64;
            squares += of_square * of_square;
        }
        let count = self.blocks.len().max(1) as f64;
        let mean = sum / (3.0 * pixels.max(1.0));
        // Of the sum over squares; what was looked at is no longer uncertain.
        let variance = (squares / count - (sum / count) * (sum / count)).max(0.0)
            * (1.0 - self.sampled_fraction).max(0.0);
        let spread = (variance / count).sqrt() * count / (3.0 * pixels.max(1.0));
        ErrorEstimate { error: mean.sqrt(), upper_bound: (mean + Z_95 * spread).sqrt() }
    }

    /// A map of the costs of these pixels.
    pub fn cost_map(&self) -> CostMap {
        CostMap::only(self.mask.size, &self.subset)
    }
}

/// The sum of the squares of the differences of a pixel's encoded channels.
fn squared_difference(a: Rgb, b: Rgb) -> f64 {
    let square = |a: f32, b: f32| {
        let difference = encode(a) - encode(b);
        difference * difference
    };
    square(a.r, b.r) + square(a.g, b.g) + square(a.b, b.b)
}

/// The root of the mean square of the differences of all pixels.
pub fn rmse(a: &[Rgb], b: &[Rgb]) -> f64 {
    let sum: f64 = a.iter().zip(b).map(|(a, b)| squared_difference(*a, *b)).sum();
    (sum / (3 * a.len().max(1)) as f64).sqrt()
}

/// A square somewhere in a cell.
fn block_in_cell(cell: Tile, area: Tile) -> Tile {
    let Tile { top_left: Pixel { x, y }, width, height } = cell;
    let [u, v] = SobolSequence::new(x, y, 0, 0).sample_2d(Dimension::PIXEL);
    let place = |first: u32, length: u32, chance: f32| {
        first + (length.saturating_sub(BLOCK_SIDE - 1) as f32 * chance) as u32
    };
    let first = Pixel { x: place(x, width, u), y: place(y, height, v) };
    Tile { top_left: first, width: BLOCK_SIDE, height: BLOCK_SIDE }.intersection(area)
}

fn mask(size: Resolution, area: Tile, squares: &[Vec<usize>]) -> Mask {
    let whole = Tile::full(size);
    let mut pixels = vec![false; whole.len()];
    for place in squares.iter().flatten() {
        let (x, y) = (*place as u32 % area.width, *place as u32 / area.width);
        if let Some(place) = whole.index_of(Pixel { x: area.top_left.x + x, y: area.top_left.y + y }) {
            pixels[place] = true;
        }
    }
    Mask { size, pixels }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_small_picture_is_looked_at_as_a_whole_and_its_error_is_certain() {
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
    fn some_pixels_of_a_large_picture_tell_its_error_within_what_they_say() {
        let size = Resolution::new(640, 480).unwrap();
        let sparse = SparsePixels::new(&Settings { size, ..Settings::default() }, &RenderOptions::default());
        let pixels = sparse.pixel_count();
        assert!((6000..12000).contains(&pixels), "{pixels}");
        // Much error in a fifth of the picture, and little elsewhere.
        let truth = vec![Rgb::BLACK; 640 * 480];
        let mut picture = truth.clone();
        for (place, color) in picture.iter_mut().enumerate() {
            let (x, y) = (place % 640, place / 640);
            *color = Rgb::gray(if x * 2 + y < 420 { 0.1 } else { 0.001 * (x % 3) as f32 });
        }
        let (estimate, all) = (sparse.error_estimate(&picture, &truth), rmse(&picture, &truth));
        assert!(
            estimate.error < estimate.upper_bound && estimate.upper_bound < 1.2 * estimate.error,
            "{estimate:?}"
        );
        assert!(all < estimate.upper_bound && all > 0.9 * estimate.error, "{all} {estimate:?}");
    }

    #[test]
    fn no_pixel_is_looked_at_that_is_not_wanted() {
        let size = Resolution::new(300, 200).unwrap();
        let region = Tile { top_left: Pixel { x: 20, y: 10 }, width: 200, height: 150 };
        let settings = Settings { size, region: Some(region), ..Settings::default() };
        let sparse = SparsePixels::new(&settings, &RenderOptions::default());
        let mask = sparse.mask();
        let asked: Vec<Pixel> = Tile::full(size).pixels().filter(|pixel| mask.has(*pixel)).collect();
        assert!(asked.len() > 2000 && asked.iter().all(|pixel| region.index_of(*pixel).is_some()));
    }
}
