//! Adaptive supersampling: rays through the corners of a pixel; where they do not agree, the
//! pixel is quartered, and its quarters again ("An Improved Illumination Model for Shaded
//! Display", Whitted, CACM 1980).
//!
//! Each corner has its place in a raster that is the same for the whole picture, and its rays
//! follow from that place alone. So neighbours share corners, and whether one is traced once or
//! twice changes nothing but the time.

use super::contrast::ContrastThreshold;
use super::corner_cache::CornerCache;
use super::pixel::Pixel;
use super::quadtree::{MAX_DEPTH, Square, subdivide};
use super::sample_cache::{CacheEntry, SampleCache};
use super::sampler::Sampler;
use crate::math::{Real, Rgb, SobolSequence};
use crate::scene::{CameraSample, FilmPoint};
use crate::trace::{PixelSample, RayTracer};

/// How a pixel is parted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subdivision {
    depth: u8,
    threshold: ContrastThreshold,
    seed: u32,
}

impl Subdivision {
    /// How often a pixel can be quartered, at most.
    pub const MAX_DEPTH: u8 = MAX_DEPTH;

    /// Quartered up to `depth` times, where corners do not agree; none when that is more than
    /// [`Parting::MOST_DEPTH`].
    pub fn new(depth: u8, agreement: ContrastThreshold) -> Option<Self> {
        (depth <= MAX_DEPTH).then_some(Subdivision { depth, threshold: agreement, seed: 0 })
    }

    /// The same in the picture with this seed: what rays leave to chance changes.
    pub fn with_seed(self, seed: u32) -> Self {
        Subdivision { seed, ..self }
    }

    /// The ray through the place that lies `x` and `y` of the finest steps from the picture's
    /// corner.
    fn sample(&self, x: u32, y: u32) -> CameraSample {
        let step = 1.0 / (1_u32 << self.depth) as Real;
        let top_left = FilmPoint { x: x as Real * step, y: y as Real * step };
        // In the steps of the greatest depth, so that the numbers do not depend on this one.
        let shift = MAX_DEPTH - self.depth;
        CameraSample { point: top_left, sequence: SobolSequence::new(x << shift, y << shift, 0, self.seed) }
    }
}

/// One ray through the upper left corner of each pixel: what fills a
/// [`Lattice`](super::Lattice) for [`Adaptive`].
#[derive(Clone, Copy, Debug)]
pub struct CornerSampler(pub Subdivision);

impl Sampler for CornerSampler {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let CornerSampler(parting) = self;
        tracer.trace(parting.sample(pixel.x << parting.depth, pixel.y << parting.depth))
    }
}

/// Rays through the corners of pixels and of their quarters.
#[derive(Debug)]
pub struct AdaptiveSampler<'m, C> {
    subdivision: Subdivision,
    corner_cache: C,
    sample_cache: SampleCache<'m>,
}

impl<'m, C: CornerCache> AdaptiveSampler<'m, C> {
    /// `corners` knows those of whole pixels. The others are kept in `lent`, of any length: the
    /// more, the fewer are traced again.
    pub fn new(parting: Subdivision, corners: C, lent: &'m mut [CacheEntry]) -> Self {
        AdaptiveSampler { subdivision: parting, corner_cache: corners, sample_cache: SampleCache::new(lent) }
    }
}

/// A square part of a pixel. The mean of its corners counts in the pixel as much as its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subpixel {
    /// Its upper left corner.
    pub place: FilmPoint,
    /// The length of its sides, in pixels.
    pub side: Real,
    /// What is seen at its corners: upper left, upper right, lower left, lower right.
    pub corners: [PixelSample; 4],
}

impl<C: CornerCache> AdaptiveSampler<'_, C> {
    /// Samples `pixel` and passes each of its parts to `part_done`: the colour is the sum of
    /// `mean * side^2`, in this order, where `mean` is `((a + b) + (c + d)) / 4` of the corners.
    pub fn sample_subpixels(
        &mut self,
        pixel: Pixel,
        tracer: &mut (impl RayTracer + ?Sized),
        part_done: &mut impl FnMut(Subpixel),
    ) -> PixelSample {
        let AdaptiveSampler { subdivision: parting, corner_cache: corners, sample_cache: memory } = self;
        let depth = parting.depth;
        let mut find = |x, y| memory.get_or_trace(x, y, || tracer.trace(parting.sample(x, y)));
        let corners = corners.corners(pixel, &mut |corner| find(corner.x << depth, corner.y << depth));
        let whole = Square { x: pixel.x << depth, y: pixel.y << depth, side: 1 << depth, corners };

        let (mut sum, mut hit) = (Rgb::BLACK, whole.hit());
        let steps = whole.side as Real;
        subdivide(whole, &parting.threshold, 1, &mut find, &mut |part| {
            let side = part.side as Real / steps;
            sum += part.mean() * (side * side);
            hit = hit.merged(part.hit());
            let place = FilmPoint { x: part.x as Real / steps, y: part.y as Real / steps };
            part_done(Subpixel { place, side, corners: part.corners });
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
    use crate::image::{CornerGrid, CornerRow, Tile, Uncached};
    use crate::trace::HitId;

    /// Half of the plane is white: what lies above a slanted line.
    fn half(sample: CameraSample) -> PixelSample {
        let inside = sample.point.y < 2.3 + 0.37 * sample.point.x;
        PixelSample { color: if inside { Rgb::WHITE } else { Rgb::BLACK }, hit: HitId::Nothing }
    }

    fn parting(depth: u8, threshold: Real) -> Subdivision {
        Subdivision::new(depth, ContrastThreshold::new(threshold).unwrap()).unwrap()
    }

    const CELLS: Tile = Tile { top_left: Pixel { x: 1, y: 0 }, width: 5, height: 6 };

    #[test]
    fn corners_and_memory_of_any_size_give_the_same_pixels() {
        let parting = parting(4, 0.1);
        let mut nothing = [CacheEntry::EMPTY; 0];
        let mut bare = AdaptiveSampler::new(parting, Uncached, &mut nothing);
        let mut truth = [PixelSample::BLACK; 30];
        let mut most = 0;
        for (slot, pixel) in truth.iter_mut().zip(CELLS.pixels()) {
            *slot = bare.sample_pixel(pixel, &mut |sample: CameraSample| {
                most += 1;
                half(sample)
            });
        }

        let mut lattice = [PixelSample::BLACK; 42];
        for (slot, corner) in lattice.iter_mut().zip(CornerGrid::corner_tile(CELLS).pixels()) {
            *slot = CornerSampler(parting).sample_pixel(corner, &mut half);
        }
        let mut rays = 42;
        for slots in [1, 1000] {
            let mut lent = [CacheEntry::EMPTY; 1000];
            let mut lent_too = [CacheEntry::EMPTY; 1000];
            let mut row = [PixelSample::BLACK; 6];
            let mut with_lattice =
                AdaptiveSampler::new(parting, CornerGrid::new(CELLS, &lattice).unwrap(), &mut lent[..slots]);
            let mut with_row =
                AdaptiveSampler::new(parting, CornerRow::new(&mut row), &mut lent_too[..slots]);
            for (truth, pixel) in truth.iter().zip(CELLS.pixels()) {
                let seen = with_lattice.sample_pixel(pixel, &mut |sample: CameraSample| {
                    rays += i32::from(slots == 1000);
                    half(sample)
                });
                assert_eq!(seen, *truth, "{pixel:?}");
                assert_eq!(with_row.sample_pixel(pixel, &mut half), *truth, "{pixel:?}");
            }
        }
        assert!(4 * rays < 3 * most, "{rays} of {most}");
    }

    #[test]
    fn a_pixel_on_an_edge_is_covered_as_much_as_it_is() {
        // The line crosses the pixel (1, 2) from (1, 2.67) to (1.892, 3).
        let mut lent = [CacheEntry::EMPTY; 300];
        let pixel = Pixel { x: 1, y: 2 };
        let dark = 0.33 * 0.892 / 2.0;
        for (depth, tolerance) in [(2, 0.1), (4, 0.02), (6, 0.005)] {
            let seen =
                AdaptiveSampler::new(parting(depth, 0.1), Uncached, &mut lent).sample_pixel(pixel, &mut half);
            assert!((seen.color.r - (1.0 - dark)).abs() < tolerance, "{depth}: {}", seen.color.r);
        }
    }

    #[test]
    fn the_parts_of_a_pixel_cover_it_and_make_its_colour() {
        let pixel = Pixel { x: 1, y: 2 };
        let (mut sum, mut area, mut count) = (Rgb::BLACK, 0.0, 0);
        let seen = AdaptiveSampler::new(parting(4, 0.1), Uncached, &mut []).sample_subpixels(
            pixel,
            &mut half,
            &mut |Subpixel { place, side, corners: [a, b, c, d] }| {
                assert!(place.x >= 1.0 && place.x + side <= 2.0 && place.y >= 2.0 && place.y + side <= 3.0);
                let mean = ((a.color + b.color) + (c.color + d.color)) * 0.25;
                sum += mean * (side * side);
                area += side * side;
                count += 1;
            },
        );
        assert_eq!((sum, area), (seen.color, 1.0));
        assert!(count > 10, "{count}");
    }

    #[test]
    fn at_depth_zero_a_pixel_is_the_mean_of_its_corners() {
        let mut rays = 0;
        let seen = AdaptiveSampler::new(parting(0, 0.0), Uncached, &mut []).sample_pixel(
            Pixel { x: 3, y: 5 },
            &mut |sample: CameraSample| {
                rays += 1;
                PixelSample { color: Rgb::new(sample.point.x, sample.point.y, 1.0), hit: HitId::Nothing }
            },
        );
        assert_eq!((rays, seen.color), (4, Rgb::new(3.5, 5.5, 1.0)));
        assert!(Subdivision::new(Subdivision::MAX_DEPTH + 1, ContrastThreshold::new(0.0).unwrap()).is_none());
    }

    #[test]
    fn items_that_look_alike_part_a_pixel_only_on_request() {
        let two = |sample: CameraSample| {
            let hit = HitId::Item(crate::geometry::ItemId(u32::from(sample.point.x > 0.3)));
            PixelSample { color: Rgb::WHITE, hit }
        };
        let rays = |agreement| {
            let mut rays = 0;
            let parting = Subdivision::new(3, agreement).unwrap();
            AdaptiveSampler::new(parting, Uncached, &mut []).sample_pixel(
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
