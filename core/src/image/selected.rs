//! Pixel-selected tracing: a coarse raster of pixels is traced, and where the corners of a block
//! agree, what lies between them is interpolated; else the block is quartered, and its quarters
//! again ("Pixel-Selected Ray Tracing", Akimoto, Mase, Suenaga, IEEE CG&A 1991).
//!
//! Blocks begin at multiples of their side from the picture's corner, and a pixel belongs to
//! the block of which it is not the right or lower edge. So a pixel depends on its own block
//! alone, and a part of the picture is the same as in the whole. The last blocks may look one
//! block beyond the picture's edge.
//!
//! For a display that is looked at while it is drawn, the same picture comes coarse at first: whole
//! blocks, then quarters of those that do not agree, and so on ([`Selected::refine_block`]). It takes no
//! memory for the picture, and puts no pixel anew that has not changed.

use super::contrast::ContrastThreshold;
use super::corner_cache::{CornerCache, StridedSampler};
use super::pixel::{Pixel, Tile};
use super::quadtree::{MAX_DEPTH, Square, subdivide};
use super::sample_cache::{CacheEntry, SampleCache};
use super::sampler::Sampler;
use crate::math::Real;
use crate::trace::{PixelSample, RayTracer};

/// The raster of pixels that are traced first, and when what lies between may be guessed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Selection {
    depth: u8,
    threshold: ContrastThreshold,
}

impl Selection {
    /// The widest raster, in pixels.
    pub const MAX_STEP: u32 = 1 << MAX_DEPTH;

    /// A raster of one pixel in `step` times `step`; none when that is no power of two in
    /// `2..=`[`Selection::MOST`].
    pub fn new(step: u32, agreement: ContrastThreshold) -> Option<Self> {
        let is_step = step >= 2 && step <= Self::MAX_STEP && step.is_power_of_two();
        is_step.then_some(Selection { depth: step.trailing_zeros() as u8, threshold: agreement })
    }

    /// Pixels along one side of a block.
    pub fn step(&self) -> u32 {
        1 << self.depth
    }

    /// The sides of the parts that blocks come in, from whole blocks to pixels: one for each pass of
    /// a picture that is refined.
    pub fn refinement_sides(&self) -> impl Iterator<Item = u32> + use<> {
        let depth = self.depth;
        (0..=depth).map(move |pass| 1 << (depth - pass))
    }

    /// The blocks that have pixels of `tile`, named like pixels.
    pub fn blocks(&self, tile: Tile) -> Tile {
        let Tile { top_left: first, width, height } = tile;
        // From the block of the first pixel to beyond that of the last.
        let span = |first: u32, length: u32| {
            let begin = first >> self.depth;
            (begin, if length > 0 { ((first + length - 1) >> self.depth) + 1 - begin } else { 0 })
        };
        let ((x, width), (y, height)) = (span(first.x, width), span(first.y, height));
        Tile { top_left: Pixel { x, y }, width, height }
    }

    /// The pixels of a rectangle of blocks.
    pub fn pixels_of(&self, blocks: Tile) -> Tile {
        let [x, y, width, height] = [blocks.top_left.x, blocks.top_left.y, blocks.width, blocks.height]
            .map(|blocks| blocks << self.depth);
        Tile { top_left: Pixel { x, y }, width, height }
    }

    /// What fills a [`Lattice`](super::Lattice) of blocks.
    pub fn corner_sampler<S: Sampler>(&self, sampler: S) -> StridedSampler<S> {
        StridedSampler { sampler, stride: self.step() }
    }
}

/// Sees some pixels and guesses the others.
#[derive(Debug)]
pub struct PixelSelector<'m, C, S> {
    selection: Selection,
    sampler: S,
    corner_cache: C,
    sample_cache: SampleCache<'m>,
}

impl<'m, C: CornerCache, S: Sampler> PixelSelector<'m, C, S> {
    /// Pixels are seen by `sampler`. `corners` knows those of the coarse raster. The others are
    /// kept in `lent`, of any length: the more, the fewer are traced again.
    pub fn new(selection: Selection, sampler: S, corners: C, lent: &'m mut [CacheEntry]) -> Self {
        PixelSelector { selection, sampler, corner_cache: corners, sample_cache: SampleCache::new(lent) }
    }

    /// Which pixels are traced first, and when the others are guessed.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// A new picture begins: what was kept of another is forgotten.
    pub fn reset(&mut self) {
        self.sampler.reset();
        self.corner_cache.reset();
        self.sample_cache.clear();
    }

    /// The pixels of one block, handed to `put` part by part. Those at its right and lower
    /// end may lie outside the picture.
    pub fn sample_block(
        &mut self,
        block: Pixel,
        tracer: &mut (impl RayTracer + ?Sized),
        put: &mut impl FnMut(Pixel, PixelSample),
    ) {
        self.sample_squares(block, 1, self.selection.step(), tracer, put);
    }

    /// Of one block what changes when its parts may be as small as `side` pixels, one of
    /// [`Selection::sides`], and no longer twice as large: the pixels of those that are. The first
    /// pass is that of the block's own side, and after the last, of side 1, every pixel is what
    /// [`Selected::sample_block`] makes of it.
    ///
    /// What was kept of the passes before is not traced again, for a picture that begins once
    /// ([`Selected::begin`]).
    pub fn refine_block(
        &mut self,
        block: Pixel,
        side: u32,
        tracer: &mut (impl RayTracer + ?Sized),
        put: &mut impl FnMut(Pixel, PixelSample),
    ) {
        self.sample_squares(block, side, side, tracer, put);
    }

    /// The parts whose sides are from `least` to `most`.
    fn sample_squares(
        &mut self,
        block: Pixel,
        least: u32,
        most: u32,
        tracer: &mut (impl RayTracer + ?Sized),
        put: &mut impl FnMut(Pixel, PixelSample),
    ) {
        let PixelSelector { selection, sampler, corner_cache: corners, sample_cache: memory } = self;
        let depth = selection.depth;
        let mut find = |x, y| memory.get_or_trace(x, y, || sampler.sample_pixel(Pixel { x, y }, tracer));
        let corners = corners.corners(block, &mut |corner| find(corner.x << depth, corner.y << depth));
        let whole = Square { x: block.x << depth, y: block.y << depth, side: 1 << depth, corners };
        subdivide(whole, &selection.threshold, least, &mut find, &mut |part| {
            let [corner, ..] = part.corners;
            let Square { x, y, side, .. } = *part;
            if side > most {
                return;
            }
            let step = 1.0 / side as Real;
            for pixel in (Tile { top_left: Pixel { x, y }, width: side, height: side }).pixels() {
                let (right, down) = (pixel.x - x, pixel.y - y);
                let sample = if right == 0 && down == 0 {
                    corner
                } else {
                    let color = part.interpolate(right as Real * step, down as Real * step);
                    PixelSample { color, hit: part.hit() }
                };
                put(pixel, sample);
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::{CenterSampler, CornerGrid, CornerRow, Uncached};
    use crate::math::Rgb;
    use crate::scene::CameraSample;
    use crate::trace::HitId;

    /// A bright disc on a slope.
    fn scene(sample: CameraSample) -> PixelSample {
        let (x, y) = (sample.point.x - 20.0, sample.point.y - 15.0);
        let slope = 0.2 + 0.004 * sample.point.x;
        let inside = x * x + y * y < 40.0;
        PixelSample { color: Rgb::gray(if inside { 0.9 } else { slope }), hit: HitId::Nothing }
    }

    fn selection(step: u32, threshold: Real) -> Selection {
        Selection::new(step, ContrastThreshold::new(threshold).unwrap()).unwrap()
    }

    const PICTURE: Tile = Tile { top_left: Pixel { x: 0, y: 0 }, width: 37, height: 29 };

    /// The pixels of `tile`, and how many were traced.
    fn selected(selection: Selection, tile: Tile, slots: usize) -> ([Option<PixelSample>; 37 * 29], usize) {
        let mut lent = [CacheEntry::EMPTY; 2000];
        let mut picture = [None; 37 * 29];
        let mut rays = 0;
        let mut selected = PixelSelector::new(selection, CenterSampler, Uncached, &mut lent[..slots]);
        for block in selection.blocks(tile).pixels() {
            selected.sample_block(
                block,
                &mut |sample| {
                    rays += 1;
                    scene(sample)
                },
                &mut |pixel, sample| {
                    if let (Some(_), Some(place)) = (tile.index_of(pixel), PICTURE.index_of(pixel)) {
                        assert!(picture[place].is_none(), "{pixel:?} comes twice");
                        picture[place] = Some(sample);
                    }
                },
            );
        }
        (picture, rays)
    }

    #[test]
    fn every_pixel_comes_once_and_few_are_traced() {
        let (picture, rays) = selected(selection(8, 0.1), PICTURE, 2000);
        assert!(picture.iter().all(Option::is_some));
        assert!(rays < picture.len() / 2, "{rays} of {}", picture.len());
        let mut most: Real = 0.0;
        for (sample, pixel) in picture.iter().zip(PICTURE.pixels()) {
            let truth = CenterSampler.sample_pixel(pixel, &mut scene);
            most = crate::math::max(most, (sample.unwrap().color.r - truth.color.r).abs());
        }
        assert!(most < 0.01, "{most}");
    }

    #[test]
    fn with_nothing_to_agree_on_every_pixel_is_traced_and_true() {
        let none = Selection::new(4, ContrastThreshold::new(0.0).unwrap()).unwrap();
        let (picture, _) = selected(none, PICTURE, 2000);
        for (sample, pixel) in picture.iter().zip(PICTURE.pixels()) {
            assert_eq!(*sample, Some(CenterSampler.sample_pixel(pixel, &mut scene)), "{pixel:?}");
        }
    }

    #[test]
    fn a_part_is_the_same_as_in_the_whole_whatever_is_kept() {
        let selection = selection(8, 0.05);
        let (whole, _) = selected(selection, PICTURE, 2000);
        for (x, y, width, height) in [(0, 0, 5, 5), (13, 9, 11, 17), (36, 28, 1, 1)] {
            let tile = Tile { top_left: Pixel { x, y }, width, height };
            for slots in [0, 3, 2000] {
                let (part, _) = selected(selection, tile, slots);
                for pixel in tile.pixels() {
                    let place = PICTURE.index_of(pixel).unwrap();
                    assert_eq!(part[place], whole[place], "{pixel:?}");
                }
            }
        }
    }

    #[test]
    fn a_lattice_of_blocks_gives_the_same() {
        let selection = selection(8, 0.1);
        let (whole, _) = selected(selection, PICTURE, 0);
        let blocks = selection.blocks(PICTURE);
        let mut corners = [PixelSample::BLACK; 6 * 5];
        for (slot, corner) in corners.iter_mut().zip(CornerGrid::corner_tile(blocks).pixels()) {
            *slot = selection.corner_sampler(CenterSampler).sample_pixel(corner, &mut scene);
        }
        let mut lattice =
            PixelSelector::new(selection, CenterSampler, CornerGrid::new(blocks, &corners).unwrap(), &mut []);
        for block in blocks.pixels() {
            lattice.sample_block(block, &mut scene, &mut |pixel, sample| {
                if let Some(place) = PICTURE.index_of(pixel) {
                    assert_eq!(Some(sample), whole[place]);
                }
            });
        }
    }

    #[test]
    fn a_refined_picture_is_the_same_in_the_end_and_traces_little_more() {
        let selection = selection(8, 0.1);
        let (truth, once) = selected(selection, PICTURE, 2000);
        for slots in [0, 50, 2000] {
            let mut lent = [CacheEntry::EMPTY; 2000];
            let mut row = [PixelSample::BLACK; 6];
            let mut picture = [None; 37 * 29];
            let (mut rays, mut puts) = (0, [0; 4]);
            let mut selected =
                PixelSelector::new(selection, CenterSampler, CornerRow::new(&mut row), &mut lent[..slots]);
            selected.reset();
            for (side, puts) in selection.refinement_sides().zip(&mut puts) {
                for block in selection.blocks(PICTURE).pixels() {
                    selected.refine_block(
                        block,
                        side,
                        &mut |sample| {
                            rays += 1;
                            scene(sample)
                        },
                        &mut |pixel, sample| {
                            if let Some(place) = PICTURE.index_of(pixel) {
                                picture[place] = Some(sample);
                                *puts += 1;
                            }
                        },
                    );
                }
                // After the first pass everything is there, only coarse.
                assert!(picture.iter().all(Option::is_some), "{side}");
            }
            assert!(picture == truth, "{slots}");
            assert_eq!(puts[0], picture.len(), "whole blocks");
            assert!(puts[3] < puts[2] && puts[2] < puts[1] && puts[1] < puts[0] / 2, "{puts:?}");
            match slots {
                // But for places that share a slot.
                2000 => assert!(rays >= once && rays < once + once / 10, "{rays} {once}"),
                // Without memory: what all passes trace, each a part of the next.
                _ => assert!(rays > once && rays < 4 * once, "{rays} {once}"),
            }
        }
        assert!(selection.refinement_sides().eq([8, 4, 2, 1]));
    }

    #[test]
    fn rasters_are_powers_of_two() {
        let agreement = ContrastThreshold::new(0.1).unwrap();
        for step in [0, 1, 3, 6, 128, u32::MAX] {
            assert!(Selection::new(step, agreement).is_none(), "{step}");
        }
        assert_eq!(Selection::new(64, agreement).unwrap().step(), 64);
        assert!(ContrastThreshold::new(-0.1).is_none() && ContrastThreshold::new(Real::NAN).is_none());
    }
}
