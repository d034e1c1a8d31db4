//! Adaptive supersampling: rays through the corners of a pixel; where their colors differ, the pixel is
//! quartered, and its quarters again.
//!
//! Corners have coordinates in a grid that is the same for the whole picture, and the sample of a corner
//! depends on these alone. Neighboring pixels therefore share corners, and tracing a corner once or twice
//! gives the same sample.
//!
//! Source: Whitted, "An Improved Illumination Model for Shaded Display", CACM 1980.

use super::contrast::ContrastThreshold;
use super::corner_cache::CornerCache;
use super::pixel::Pixel;
use super::quadtree::{MAX_DEPTH, Square, subdivide};
use super::sample_cache::{CacheEntry, SampleCache};
use super::sampler::Sampler;
use crate::math::{Real, Rgb, SobolSequence};
use crate::scene::{CameraSample, FilmPoint};
use crate::trace::{PixelSample, RayTracer};

/// Settings of an [`AdaptiveSampler`]: the contrast above which a square is quartered, how often, and the
/// seed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subdivision {
    depth: u8,
    threshold: ContrastThreshold,
    seed: u32,
}

impl Subdivision {
    /// Largest depth: a pixel is quartered at most this often.
    pub const MAX_DEPTH: u8 = MAX_DEPTH;

    /// Quarters a pixel, and its quarters again, up to `depth` times where the corners do not meet
    /// `threshold`. With a depth of 0, only the corners of the pixel are traced.
    ///
    /// `None` if `depth` is more than [`Subdivision::MAX_DEPTH`].
    pub fn new(depth: u8, threshold: ContrastThreshold) -> Option<Self> {
        (depth <= MAX_DEPTH).then_some(Subdivision { depth, threshold, seed: 0 })
    }

    /// The same subdivision with this seed of the random numbers, 0 by default.
    pub fn with_seed(self, seed: u32) -> Self {
        Subdivision { seed, ..self }
    }

    /// The sample at grid coordinates `x` and `y`, in steps of `2^-depth` pixels from the upper left corner
    /// of the picture.
    fn sample(&self, x: u32, y: u32) -> CameraSample {
        let step = 1.0 / (1_u32 << self.depth) as Real;
        let point = FilmPoint { x: x as Real * step, y: y as Real * step };
        // In steps of the largest depth, so that the sequence does not depend on this depth.
        let shift = MAX_DEPTH - self.depth;
        CameraSample { point, sequence: SobolSequence::new(x << shift, y << shift, 0, self.seed) }
    }
}

/// Samples a pixel with one ray through its upper left corner.
///
/// Used for a pass before an [`AdaptiveSampler`]: the caller renders the pixels of
/// [`PretracedCorners::corner_tile`] with this sampler into a buffer, and passes the buffer to
/// [`PretracedCorners::new`], so that all workers share the corners.
///
/// [`PretracedCorners`]: super::PretracedCorners
/// [`PretracedCorners::corner_tile`]: super::PretracedCorners::corner_tile
/// [`PretracedCorners::new`]: super::PretracedCorners::new
#[derive(Clone, Copy, Debug)]
pub struct UpperLeftCornerSampler(
    /// That of the [`AdaptiveSampler`], so that both trace the same ray through a corner.
    pub Subdivision,
);

impl Sampler for UpperLeftCornerSampler {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let UpperLeftCornerSampler(subdivision) = self;
        tracer.trace(subdivision.sample(pixel.x << subdivision.depth, pixel.y << subdivision.depth))
    }
}

/// Adaptive sampler: traces rays through the corners of a pixel, and quarters it where their contrast is
/// high (Whitted).
///
/// * `C`: cache of the corners of pixels.
///
/// ```
/// use strahl_core::Rgb;
/// use strahl_core::image::{AdaptiveSampler, CacheEntry, ContrastThreshold, Pixel, Sampler};
/// use strahl_core::image::{Subdivision, UncachedCorners};
/// use strahl_core::scene::CameraSample;
/// use strahl_core::trace::{HitId, PixelSample};
///
/// // An edge at x = 0.5.
/// let mut edge = |sample: CameraSample| {
///     PixelSample { color: Rgb::gray(if sample.point.x < 0.5 { 0.0 } else { 1.0 }), hit: HitId::Nothing }
/// };
/// let subdivision = Subdivision::new(3, ContrastThreshold::new(0.1).unwrap()).unwrap();
/// let mut entries = [CacheEntry::EMPTY; 64];
/// let mut sampler = AdaptiveSampler::new(subdivision, UncachedCorners, &mut entries);
/// let gray = sampler.sample_pixel(Pixel { x: 0, y: 0 }, &mut edge).color.r;
/// assert!((gray - 0.5).abs() < 0.1);
/// ```
#[derive(Debug)]
#[doc(alias = "antialiasing")]
#[doc(alias = "supersampling")]
pub struct AdaptiveSampler<'m, C> {
    subdivision: Subdivision,
    corner_cache: C,
    sample_cache: SampleCache<'m>,
}

impl<'m, C: CornerCache> AdaptiveSampler<'m, C> {
    /// Caches the corners of pixels in `corner_cache`, and all other corners in `entries`.
    ///
    /// `entries`: caller-provided buffer of any length, also empty. The longer, the fewer corners are traced
    /// again.
    pub fn new(subdivision: Subdivision, corner_cache: C, entries: &'m mut [CacheEntry]) -> Self {
        AdaptiveSampler { subdivision, corner_cache, sample_cache: SampleCache::new(entries) }
    }
}

/// A square part of a pixel that is not quartered further. Its weight in the color of the pixel is its
/// area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subpixel {
    /// Upper left corner.
    pub top_left: FilmPoint,
    /// Length of the sides, in pixels, in `(0, 1]`.
    pub side: Real,
    /// Samples at the corners: upper left, upper right, lower left, lower right.
    pub corners: [PixelSample; 4],
}

impl<C: CornerCache> AdaptiveSampler<'_, C> {
    /// Samples `pixel` as [`Sampler::sample_pixel`] does, and passes each of its subpixels to `visit`.
    ///
    /// The color of the pixel is the sum of `mean * side^2` in this order, where `mean` is `((a + b) + (c +
    /// d)) / 4` of the corners.
    pub fn sample_subpixels(
        &mut self,
        pixel: Pixel,
        tracer: &mut (impl RayTracer + ?Sized),
        visit: &mut impl FnMut(Subpixel),
    ) -> PixelSample {
        let AdaptiveSampler { subdivision, corner_cache, sample_cache } = self;
        let depth = subdivision.depth;
        let mut sample_at = |x, y| sample_cache.get_or_trace(x, y, || tracer.trace(subdivision.sample(x, y)));
        let corners =
            corner_cache.corners(pixel, &mut |corner| sample_at(corner.x << depth, corner.y << depth));
        let whole = Square { x: pixel.x << depth, y: pixel.y << depth, side: 1 << depth, corners };

        let (mut sum, mut hit) = (Rgb::BLACK, whole.hit());
        let steps = whole.side as Real;
        subdivide(whole, &subdivision.threshold, 1, &mut sample_at, &mut |square| {
            let side = square.side as Real / steps;
            sum += square.mean() * (side * side);
            hit = hit.same_or_mixed(square.hit());
            let top_left = FilmPoint { x: square.x as Real / steps, y: square.y as Real / steps };
            visit(Subpixel { top_left, side, corners: square.corners });
        });
        PixelSample { color: sum, hit }
    }
}

impl<C: CornerCache> Sampler for AdaptiveSampler<'_, C> {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        self.sample_subpixels(pixel, tracer, &mut |_| {})
    }

    fn reset(&mut self) {
        self.corner_cache.reset();
        self.sample_cache.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::{CornerRowCache, PretracedCorners, Tile, UncachedCorners};
    use crate::trace::HitId;

    /// White above a slanted line, black below it.
    fn half(sample: CameraSample) -> PixelSample {
        let inside = sample.point.y < 2.3 + 0.37 * sample.point.x;
        PixelSample { color: if inside { Rgb::WHITE } else { Rgb::BLACK }, hit: HitId::Nothing }
    }

    fn subdivision(depth: u8, threshold: Real) -> Subdivision {
        Subdivision::new(depth, ContrastThreshold::new(threshold).unwrap()).unwrap()
    }

    const CELLS: Tile = Tile { top_left: Pixel { x: 1, y: 0 }, width: 5, height: 6 };

    #[test]
    fn pixels_do_not_depend_on_corner_cache_or_sample_cache() {
        let subdivision = subdivision(4, 0.1);
        let mut empty = [CacheEntry::EMPTY; 0];
        let mut uncached = AdaptiveSampler::new(subdivision, UncachedCorners, &mut empty);
        let mut expected = [PixelSample::BLACK; 30];
        let mut rays_uncached = 0;
        for (slot, pixel) in expected.iter_mut().zip(CELLS.pixels()) {
            *slot = uncached.sample_pixel(pixel, &mut |sample: CameraSample| {
                rays_uncached += 1;
                half(sample)
            });
        }

        let mut grid = [PixelSample::BLACK; 42];
        for (slot, corner) in grid.iter_mut().zip(PretracedCorners::corner_tile(CELLS).pixels()) {
            *slot = UpperLeftCornerSampler(subdivision).sample_pixel(corner, &mut half);
        }
        let mut rays = 42;
        for length in [1, 1000] {
            let mut entries = [CacheEntry::EMPTY; 1000];
            let mut row_entries = [CacheEntry::EMPTY; 1000];
            let mut row = [PixelSample::BLACK; 6];
            let mut with_grid = AdaptiveSampler::new(
                subdivision,
                PretracedCorners::new(CELLS, &grid).unwrap(),
                &mut entries[..length],
            );
            let mut with_row =
                AdaptiveSampler::new(subdivision, CornerRowCache::new(&mut row), &mut row_entries[..length]);
            for (expected, pixel) in expected.iter().zip(CELLS.pixels()) {
                let sampled = with_grid.sample_pixel(pixel, &mut |sample: CameraSample| {
                    rays += i32::from(length == 1000);
                    half(sample)
                });
                assert_eq!(sampled, *expected, "{pixel:?}");
                assert_eq!(with_row.sample_pixel(pixel, &mut half), *expected, "{pixel:?}");
            }
        }
        assert!(4 * rays < 3 * rays_uncached, "{rays} of {rays_uncached}");
    }

    #[test]
    fn the_color_of_a_pixel_on_an_edge_is_its_coverage() {
        // The line crosses the pixel (1, 2) from (1, 2.67) to (1.892, 3).
        let mut entries = [CacheEntry::EMPTY; 300];
        let pixel = Pixel { x: 1, y: 2 };
        let dark = 0.33 * 0.892 / 2.0;
        for (depth, tolerance) in [(2, 0.1), (4, 0.02), (6, 0.005)] {
            let sampled = AdaptiveSampler::new(subdivision(depth, 0.1), UncachedCorners, &mut entries)
                .sample_pixel(pixel, &mut half);
            assert!((sampled.color.r - (1.0 - dark)).abs() < tolerance, "{depth}: {}", sampled.color.r);
        }
    }

    #[test]
    fn subpixels_cover_the_pixel_and_sum_to_its_color() {
        let pixel = Pixel { x: 1, y: 2 };
        let (mut sum, mut area, mut count) = (Rgb::BLACK, 0.0, 0);
        let sampled = AdaptiveSampler::new(subdivision(4, 0.1), UncachedCorners, &mut []).sample_subpixels(
            pixel,
            &mut half,
            &mut |Subpixel { top_left, side, corners: [a, b, c, d] }| {
                assert!(top_left.x >= 1.0 && top_left.x + side <= 2.0);
                assert!(top_left.y >= 2.0 && top_left.y + side <= 3.0);
                let mean = ((a.color + b.color) + (c.color + d.color)) * 0.25;
                sum += mean * (side * side);
                area += side * side;
                count += 1;
            },
        );
        assert_eq!((sum, area), (sampled.color, 1.0));
        assert!(count > 10, "{count}");
    }

    #[test]
    fn at_depth_zero_a_pixel_is_the_mean_of_its_corners() {
        let mut rays = 0;
        let sampled = AdaptiveSampler::new(subdivision(0, 0.0), UncachedCorners, &mut []).sample_pixel(
            Pixel { x: 3, y: 5 },
            &mut |sample: CameraSample| {
                rays += 1;
                PixelSample { color: Rgb::new(sample.point.x, sample.point.y, 1.0), hit: HitId::Nothing }
            },
        );
        assert_eq!((rays, sampled.color), (4, Rgb::new(3.5, 5.5, 1.0)));
        assert!(Subdivision::new(Subdivision::MAX_DEPTH + 1, ContrastThreshold::new(0.0).unwrap()).is_none());
    }

    #[test]
    fn equal_colors_of_different_items_subdivide_only_with_items() {
        let two = |sample: CameraSample| {
            let hit = HitId::Item(crate::geometry::ItemId(u32::from(sample.point.x > 0.3)));
            PixelSample { color: Rgb::WHITE, hit }
        };
        let rays = |threshold| {
            let mut rays = 0;
            let subdivision = Subdivision::new(3, threshold).unwrap();
            AdaptiveSampler::new(subdivision, UncachedCorners, &mut []).sample_pixel(
                Pixel { x: 0, y: 0 },
                &mut |sample: CameraSample| {
                    rays += 1;
                    two(sample)
                },
            );
            rays
        };
        let colors = ContrastThreshold::new(0.0).unwrap();
        assert_eq!(rays(colors), 4);
        assert!(rays(colors.with_items()) > 20);
    }
}
