//! Adaptive supersampling: rays through the corners of a pixel; where they do not agree, the
//! pixel is quartered, and its quarters again ("An Improved Illumination Model for Shaded
//! Display", Whitted, CACM 1980).
//!
//! Each corner has its place in a raster that is the same for the whole picture, and its rays
//! follow from that place alone. So neighbours share corners, and whether one is traced once or
//! twice changes nothing but the time.

use super::agreement::Agreement;
use super::corners::Corners;
use super::kept::{Kept, Memory};
use super::pixel::Pixel;
use super::quarter::{MOST_DEPTH, Square, quarter};
use super::sampler::Sampler;
use crate::math::{Real, Rgb, SobolSequence};
use crate::scene::{CameraSample, FilmPoint};
use crate::trace::{PixelSample, RayTracer};

/// How a pixel is parted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parting {
    depth: u8,
    agreement: Agreement,
    seed: u32,
}

impl Parting {
    /// How often a pixel can be quartered, at most.
    pub const MOST_DEPTH: u8 = MOST_DEPTH;

    /// Quartered up to `depth` times, where corners do not agree; none when that is more than
    /// [`Parting::MOST_DEPTH`].
    pub fn new(depth: u8, agreement: Agreement) -> Option<Self> {
        (depth <= MOST_DEPTH).then_some(Parting { depth, agreement, seed: 0 })
    }

    /// The same in the picture with this seed: what rays leave to chance changes.
    pub fn seeded(self, seed: u32) -> Self {
        Parting { seed, ..self }
    }

    /// The ray through the place that lies `x` and `y` of the finest steps from the picture's
    /// corner.
    fn sample(&self, x: u32, y: u32) -> CameraSample {
        let step = 1.0 / (1_u32 << self.depth) as Real;
        let place = FilmPoint { x: x as Real * step, y: y as Real * step };
        // In the steps of the greatest depth, so that the numbers do not depend on this one.
        let shift = MOST_DEPTH - self.depth;
        CameraSample { point: place, sequence: SobolSequence::new(x << shift, y << shift, 0, self.seed) }
    }
}

/// One ray through the upper left corner of each pixel: what fills a
/// [`Lattice`](super::Lattice) for [`Adaptive`].
#[derive(Clone, Copy, Debug)]
pub struct Corner(pub Parting);

impl Sampler for Corner {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let Corner(parting) = self;
        tracer.trace(parting.sample(pixel.x << parting.depth, pixel.y << parting.depth))
    }
}

/// Rays through the corners of pixels and of their quarters.
#[derive(Debug)]
pub struct Adaptive<'m, C> {
    parting: Parting,
    corners: C,
    memory: Memory<'m>,
}

impl<'m, C: Corners> Adaptive<'m, C> {
    /// `corners` knows those of whole pixels. The others are kept in `lent`, of any length: the
    /// more, the fewer are traced again.
    pub fn new(parting: Parting, corners: C, lent: &'m mut [Kept]) -> Self {
        Adaptive { parting, corners, memory: Memory::new(lent) }
    }
}

/// A square part of a pixel. The mean of its corners counts in the pixel as much as its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Its upper left corner.
    pub place: FilmPoint,
    /// The length of its sides, in pixels.
    pub side: Real,
    /// What is seen at its corners: upper left, upper right, lower left, lower right.
    pub corners: [PixelSample; 4],
}

impl<C: Corners> Adaptive<'_, C> {
    /// Samples `pixel` and passes each of its parts to `part_done`: the colour is the sum of
    /// `mean * side^2`, in this order, where `mean` is `((a + b) + (c + d)) / 4` of the corners.
    pub fn sample_by_parts(
        &mut self,
        pixel: Pixel,
        tracer: &mut (impl RayTracer + ?Sized),
        part_done: &mut impl FnMut(Part),
    ) -> PixelSample {
        let Adaptive { parting, corners, memory } = self;
        let depth = parting.depth;
        let mut find = |x, y| memory.find(x, y, || tracer.trace(parting.sample(x, y)));
        let corners = corners.corners(pixel, &mut |corner| find(corner.x << depth, corner.y << depth));
        let whole = Square { x: pixel.x << depth, y: pixel.y << depth, side: 1 << depth, corners };

        let (mut sum, mut hit) = (Rgb::BLACK, whole.hit());
        let steps = whole.side as Real;
        quarter(whole, &parting.agreement, 1, &mut find, &mut |part| {
            let side = part.side as Real / steps;
            sum += part.mean() * (side * side);
            hit = hit.merged(part.hit());
            let place = FilmPoint { x: part.x as Real / steps, y: part.y as Real / steps };
            part_done(Part { place, side, corners: part.corners });
        });
        PixelSample { color: sum, hit }
    }
}

impl<C: Corners> Sampler for Adaptive<'_, C> {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        self.sample_by_parts(pixel, tracer, &mut |_| {})
    }

    fn begin(&mut self) {
        self.corners.begin();
        self.memory.forget();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::{CornerRow, Lattice, Loose, Tile};
    use crate::trace::HitId;

    /// Half of the plane is white: what lies above a slanted line.
    fn half(sample: CameraSample) -> PixelSample {
        let inside = sample.point.y < 2.3 + 0.37 * sample.point.x;
        PixelSample { color: if inside { Rgb::WHITE } else { Rgb::BLACK }, hit: HitId::Nothing }
    }

    fn parting(depth: u8, threshold: Real) -> Parting {
        Parting::new(depth, Agreement::of_colors(threshold).unwrap()).unwrap()
    }

    const CELLS: Tile = Tile { first: Pixel { x: 1, y: 0 }, width: 5, height: 6 };

    #[test]
    fn corners_and_memory_of_any_size_give_the_same_pixels() {
        let parting = parting(4, 0.1);
        let mut nothing = [Kept::NOTHING; 0];
        let mut bare = Adaptive::new(parting, Loose, &mut nothing);
        let mut truth = [PixelSample::BLACK; 30];
        let mut most = 0;
        for (slot, pixel) in truth.iter_mut().zip(CELLS.pixels()) {
            *slot = bare.sample_pixel(pixel, &mut |sample: CameraSample| {
                most += 1;
                half(sample)
            });
        }

        let mut lattice = [PixelSample::BLACK; 42];
        for (slot, corner) in lattice.iter_mut().zip(Lattice::tile(CELLS).pixels()) {
            *slot = Corner(parting).sample_pixel(corner, &mut half);
        }
        let mut rays = 42;
        for slots in [1, 1000] {
            let mut lent = [Kept::NOTHING; 1000];
            let mut lent_too = [Kept::NOTHING; 1000];
            let mut row = [PixelSample::BLACK; 6];
            let mut with_lattice =
                Adaptive::new(parting, Lattice::new(CELLS, &lattice).unwrap(), &mut lent[..slots]);
            let mut with_row = Adaptive::new(parting, CornerRow::new(&mut row), &mut lent_too[..slots]);
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
        let mut lent = [Kept::NOTHING; 300];
        let pixel = Pixel { x: 1, y: 2 };
        let dark = 0.33 * 0.892 / 2.0;
        for (depth, tolerance) in [(2, 0.1), (4, 0.02), (6, 0.005)] {
            let seen = Adaptive::new(parting(depth, 0.1), Loose, &mut lent).sample_pixel(pixel, &mut half);
            assert!((seen.color.r - (1.0 - dark)).abs() < tolerance, "{depth}: {}", seen.color.r);
        }
    }

    #[test]
    fn the_parts_of_a_pixel_cover_it_and_make_its_colour() {
        let pixel = Pixel { x: 1, y: 2 };
        let (mut sum, mut area, mut count) = (Rgb::BLACK, 0.0, 0);
        let seen = Adaptive::new(parting(4, 0.1), Loose, &mut []).sample_by_parts(
            pixel,
            &mut half,
            &mut |Part { place, side, corners: [a, b, c, d] }| {
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
        let seen = Adaptive::new(parting(0, 0.0), Loose, &mut []).sample_pixel(
            Pixel { x: 3, y: 5 },
            &mut |sample: CameraSample| {
                rays += 1;
                PixelSample { color: Rgb::new(sample.point.x, sample.point.y, 1.0), hit: HitId::Nothing }
            },
        );
        assert_eq!((rays, seen.color), (4, Rgb::new(3.5, 5.5, 1.0)));
        assert!(Parting::new(Parting::MOST_DEPTH + 1, Agreement::of_colors(0.0).unwrap()).is_none());
    }

    #[test]
    fn items_that_look_alike_part_a_pixel_only_on_request() {
        let two = |sample: CameraSample| {
            let hit = HitId::Item(crate::geometry::ItemId(u32::from(sample.point.x > 0.3)));
            PixelSample { color: Rgb::WHITE, hit }
        };
        let rays = |agreement| {
            let mut rays = 0;
            let parting = Parting::new(3, agreement).unwrap();
            Adaptive::new(parting, Loose, &mut []).sample_pixel(
                Pixel { x: 0, y: 0 },
                &mut |sample: CameraSample| {
                    rays += 1;
                    two(sample)
                },
            );
            rays
        };
        let colors = Agreement::of_colors(0.0).unwrap();
        assert_eq!(rays(colors), 4);
        assert!(rays(colors.and_items()) > 20);
    }
}
