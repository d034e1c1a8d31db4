//! Pixel-selected tracing: a coarse grid of pixels is traced; where the corners of a block differ little, the
//! pixels between them are interpolated; else the block is quartered, and its quarters again.
//!
//! Blocks start at multiples of their side from the upper left corner of the picture, and a pixel belongs to
//! the block of which it is not the right or lower edge. A pixel therefore depends on its own block alone,
//! and a region equals the same pixels of the whole picture. The last blocks can trace pixels up to one block
//! beyond the edges of the picture.
//!
//! For interactive display, the same picture can be refined: whole blocks first, then the quarters of those
//! above the threshold, and so on ([`PixelSelector::refine_block`]). Refinement stores no picture, and draws
//! only pixels that change.
//!
//! Source: Akimoto, Mase and Suenaga, "Pixel-Selected Ray Tracing", IEEE Computer Graphics and Applications
//! 1991.

use super::corner_cache::CornerCache;
use super::pixel::{Pixel, Tile};
use super::pixel_selection::PixelSelection;
use super::quadtree::{Square, subdivide};
use super::sample_cache::{CacheEntry, SampleCache};
use super::sampler::Sampler;
use crate::math::Real;
use crate::trace::{PixelSample, RayTracer};

/// Traces some pixels of a block with the sampler `S`, and interpolates the others where the traced ones
/// are similar.
///
/// * `C`: cache of the corners of blocks.
///
/// ```
/// use strahl_core::Rgb;
/// use strahl_core::image::{CenterSampler, ContrastThreshold, Pixel, PixelSelector, PixelSelection, UncachedCorners};
/// use strahl_core::scene::CameraSample;
/// use strahl_core::trace::{HitId, PixelSample};
///
/// let selection = PixelSelection::new(8, ContrastThreshold::new(0.1).unwrap()).unwrap();
/// let mut selector = PixelSelector::new(selection, CenterSampler, UncachedCorners, &mut []);
/// let (mut rays, mut pixels) = (0, 0);
/// let mut trace = |_: CameraSample| {
///     rays += 1;
///     PixelSample { color: Rgb::WHITE, hit: HitId::Nothing }
/// };
/// selector.sample_block(Pixel { x: 0, y: 0 }, &mut trace, &mut |_, _| pixels += 1);
/// assert_eq!((rays, pixels), (4, 64));
/// ```
#[derive(Debug)]
pub struct PixelSelector<'m, C, S> {
    selection: PixelSelection,
    sampler: S,
    corner_cache: C,
    sample_cache: SampleCache<'m>,
}

impl<'m, C: CornerCache, S: Sampler> PixelSelector<'m, C, S> {
    /// Samples pixels with `sampler`, and caches the corners of blocks in `corner_cache` and other pixels in
    /// `entries`.
    ///
    /// `entries`: caller-provided buffer of any length, also empty. The longer, the fewer pixels are traced
    /// again.
    pub fn new(
        selection: PixelSelection,
        sampler: S,
        corner_cache: C,
        entries: &'m mut [CacheEntry],
    ) -> Self {
        PixelSelector { selection, sampler, corner_cache, sample_cache: SampleCache::new(entries) }
    }

    /// The settings: grid and contrast threshold.
    pub fn selection(&self) -> &PixelSelection {
        &self.selection
    }

    /// Removes all cached samples, before another picture.
    pub fn reset(&mut self) {
        self.sampler.reset();
        self.corner_cache.reset();
        self.sample_cache.clear();
    }

    /// Samples a block and passes all its pixels to `put`, square by square. At the right and lower edges of
    /// the picture these include pixels outside of it, which the caller ignores.
    ///
    /// `block_coordinates`: those of the block's pixels, divided by the step; [`PixelSelection::block_range`]
    /// has them for a tile.
    pub fn sample_block(
        &mut self,
        block_coordinates: Pixel,
        tracer: &mut (impl RayTracer + ?Sized),
        put: &mut impl FnMut(Pixel, PixelSample),
    ) {
        self.sample_squares(block_coordinates, 1, self.selection.step(), tracer, put);
    }

    /// One refinement pass of a block: passes the pixels of squares with this `side` to `put`.
    ///
    /// `side`: one of [`PixelSelection::refinement_sides`], in their order. The first pass has whole blocks. After
    /// the last pass, with side 1, all pixels equal those of [`PixelSelector::sample_block`]. Samples that
    /// are still cached from the passes before are not traced again, so [`PixelSelector::reset`] is called
    /// before the first pass only.
    pub fn refine_block(
        &mut self,
        block_coordinates: Pixel,
        side: u32,
        tracer: &mut (impl RayTracer + ?Sized),
        put: &mut impl FnMut(Pixel, PixelSample),
    ) {
        self.sample_squares(block_coordinates, side, side, tracer, put);
    }

    /// Passes the pixels of squares with sides from `min_side` to `max_side` to `put`.
    fn sample_squares(
        &mut self,
        block: Pixel,
        min_side: u32,
        max_side: u32,
        tracer: &mut (impl RayTracer + ?Sized),
        put: &mut impl FnMut(Pixel, PixelSample),
    ) {
        let PixelSelector { selection, sampler, corner_cache, sample_cache } = self;
        let depth = selection.depth;
        let mut sample_at =
            |x, y| sample_cache.get_or_trace(x, y, || sampler.sample_pixel(Pixel { x, y }, tracer));
        let corners =
            corner_cache.corners(block, &mut |corner| sample_at(corner.x << depth, corner.y << depth));
        let whole = Square { x: block.x << depth, y: block.y << depth, side: 1 << depth, corners };
        subdivide(whole, &selection.threshold, min_side, &mut sample_at, &mut |square| {
            let [corner, ..] = square.corners;
            let Square { x, y, side, .. } = *square;
            if side > max_side {
                return;
            }
            let step = 1.0 / side as Real;
            for pixel in (Tile { top_left: Pixel { x, y }, width: side, height: side }).pixels() {
                let (right, down) = (pixel.x - x, pixel.y - y);
                let sample = if right == 0 && down == 0 {
                    corner
                } else {
                    let color = square.interpolate(right as Real * step, down as Real * step);
                    PixelSample { color, hit: square.hit() }
                };
                put(pixel, sample);
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::{CenterSampler, ContrastThreshold, CornerRowCache, PretracedCorners, UncachedCorners};
    use crate::math::Rgb;
    use crate::scene::CameraSample;
    use crate::trace::HitId;

    /// A bright disc on a linear gradient.
    fn test_image(sample: CameraSample) -> PixelSample {
        let (x, y) = (sample.point.x - 20.0, sample.point.y - 15.0);
        let slope = 0.2 + 0.004 * sample.point.x;
        let inside = x * x + y * y < 40.0;
        PixelSample { color: Rgb::gray(if inside { 0.9 } else { slope }), hit: HitId::Nothing }
    }

    fn selection(step: u32, threshold: Real) -> PixelSelection {
        PixelSelection::new(step, ContrastThreshold::new(threshold).unwrap()).unwrap()
    }

    const PICTURE: Tile = Tile { top_left: Pixel { x: 0, y: 0 }, width: 37, height: 29 };

    /// The pixels of `tile`, and the number of rays.
    fn selected(
        selection: PixelSelection,
        tile: Tile,
        length: usize,
    ) -> ([Option<PixelSample>; 37 * 29], usize) {
        let mut entries = [CacheEntry::EMPTY; 2000];
        let mut picture = [None; 37 * 29];
        let mut rays = 0;
        let mut selected =
            PixelSelector::new(selection, CenterSampler, UncachedCorners, &mut entries[..length]);
        for block in selection.block_range(tile).pixels() {
            selected.sample_block(
                block,
                &mut |sample| {
                    rays += 1;
                    test_image(sample)
                },
                &mut |pixel, sample| {
                    if let (Some(_), Some(index)) = (tile.index_of(pixel), PICTURE.index_of(pixel)) {
                        assert!(picture[index].is_none(), "{pixel:?} is put twice");
                        picture[index] = Some(sample);
                    }
                },
            );
        }
        (picture, rays)
    }

    #[test]
    fn every_pixel_is_put_once_and_few_are_traced() {
        let (picture, rays) = selected(selection(8, 0.1), PICTURE, 2000);
        assert!(picture.iter().all(Option::is_some));
        assert!(rays < picture.len() / 2, "{rays} of {}", picture.len());
        let mut max_error: Real = 0.0;
        for (sample, pixel) in picture.iter().zip(PICTURE.pixels()) {
            let expected = CenterSampler.sample_pixel(pixel, &mut test_image);
            max_error = crate::math::max(max_error, (sample.unwrap().color.r - expected.color.r).abs());
        }
        assert!(max_error < 0.01, "{max_error}");
    }

    #[test]
    fn with_threshold_zero_every_pixel_equals_the_reference() {
        let none = PixelSelection::new(4, ContrastThreshold::new(0.0).unwrap()).unwrap();
        let (picture, _) = selected(none, PICTURE, 2000);
        for (sample, pixel) in picture.iter().zip(PICTURE.pixels()) {
            assert_eq!(*sample, Some(CenterSampler.sample_pixel(pixel, &mut test_image)), "{pixel:?}");
        }
    }

    #[test]
    fn a_region_equals_the_same_pixels_of_the_whole_picture() {
        let selection = selection(8, 0.05);
        let (whole, _) = selected(selection, PICTURE, 2000);
        for (x, y, width, height) in [(0, 0, 5, 5), (13, 9, 11, 17), (36, 28, 1, 1)] {
            let tile = Tile { top_left: Pixel { x, y }, width, height };
            for length in [0, 3, 2000] {
                let (region, _) = selected(selection, tile, length);
                for pixel in tile.pixels() {
                    let index = PICTURE.index_of(pixel).unwrap();
                    assert_eq!(region[index], whole[index], "{pixel:?}");
                }
            }
        }
    }

    #[test]
    fn a_corner_grid_gives_the_same_pixels() {
        let selection = selection(8, 0.1);
        let (whole, _) = selected(selection, PICTURE, 0);
        let block_tile = selection.block_range(PICTURE);
        let mut corners = [PixelSample::BLACK; 6 * 5];
        for (slot, corner) in corners.iter_mut().zip(PretracedCorners::corner_tile(block_tile).pixels()) {
            *slot = selection.first_pass_sampler(CenterSampler).sample_pixel(corner, &mut test_image);
        }
        let mut grid = PixelSelector::new(
            selection,
            CenterSampler,
            PretracedCorners::new(block_tile, &corners).unwrap(),
            &mut [],
        );
        for block in block_tile.pixels() {
            grid.sample_block(block, &mut test_image, &mut |pixel, sample| {
                if let Some(index) = PICTURE.index_of(pixel) {
                    assert_eq!(Some(sample), whole[index]);
                }
            });
        }
    }

    #[test]
    fn a_refined_picture_is_the_same_after_the_last_pass_and_traces_few_more_rays() {
        let selection = selection(8, 0.1);
        let (expected, once) = selected(selection, PICTURE, 2000);
        for length in [0, 50, 2000] {
            let mut entries = [CacheEntry::EMPTY; 2000];
            let mut row = [PixelSample::BLACK; 6];
            let mut picture = [None; 37 * 29];
            let (mut rays, mut puts) = (0, [0; 4]);
            let mut selected = PixelSelector::new(
                selection,
                CenterSampler,
                CornerRowCache::new(&mut row),
                &mut entries[..length],
            );
            selected.reset();
            for (side, puts) in selection.refinement_sides().zip(&mut puts) {
                for block in selection.block_range(PICTURE).pixels() {
                    selected.refine_block(
                        block,
                        side,
                        &mut |sample| {
                            rays += 1;
                            test_image(sample)
                        },
                        &mut |pixel, sample| {
                            if let Some(index) = PICTURE.index_of(pixel) {
                                picture[index] = Some(sample);
                                *puts += 1;
                            }
                        },
                    );
                }
                // After each pass the picture is complete.
                assert!(picture.iter().all(Option::is_some), "{side}");
            }
            assert!(picture == expected, "{length}");
            assert_eq!(puts[0], picture.len(), "whole block_tile");
            assert!(puts[3] < puts[2] && puts[2] < puts[1] && puts[1] < puts[0] / 2, "{puts:?}");
            match length {
                // Except for pixels that share a cache entry.
                2000 => assert!(rays >= once && rays < once + once / 10, "{rays} {once}"),
                // Without a cache, each pass traces the pixels of all passes before again.
                _ => assert!(rays > once && rays < 4 * once, "{rays} {once}"),
            }
        }
        assert!(selection.refinement_sides().eq([8, 4, 2, 1]));
    }

    #[test]
    fn steps_are_powers_of_two() {
        let threshold = ContrastThreshold::new(0.1).unwrap();
        for step in [0, 1, 3, 6, 128, u32::MAX] {
            assert!(PixelSelection::new(step, threshold).is_none(), "{step}");
        }
        assert_eq!(PixelSelection::new(64, threshold).unwrap().step(), 64);
        assert!(ContrastThreshold::new(-0.1).is_none() && ContrastThreshold::new(Real::NAN).is_none());
    }
}
