//! Regular supersampling: a ray through the center of each of n times n cells of a pixel.

use super::filter::Filter;
use super::filter_sample::sample_filter;
use super::pixel::Pixel;
use super::sampler::{SampleMean, Sampler, film_point, sequence};
use crate::math::Real;
use crate::scene::CameraSample;
use crate::trace::{PixelSample, RayTracer};

/// Regular sampler: rays through the centers of `n` times `n` equal cells, and their mean.
///
/// ```
/// use strahl_core::Rgb;
/// use strahl_core::image::{Pixel, RegularSampler, Sampler};
/// use strahl_core::scene::CameraSample;
/// use strahl_core::trace::{HitId, PixelSample};
///
/// let mut rays = 0;
/// let mut trace = |_: CameraSample| {
///     rays += 1;
///     PixelSample { color: Rgb::WHITE, hit: HitId::Nothing }
/// };
/// let sample = RegularSampler::new(3).unwrap().sample_pixel(Pixel { x: 0, y: 0 }, &mut trace);
/// assert_eq!((rays, RegularSampler::new(0).is_none()), (9, true));
/// ```
#[derive(Clone, Copy, Debug)]
#[doc(alias = "antialiasing")]
#[doc(alias = "supersampling")]
pub struct RegularSampler {
    cells: u16,
    filter: Filter,
    seed: u32,
}

impl RegularSampler {
    /// One ray through the center of each pixel, box filter, seed 0.
    pub const CENTER: RegularSampler = RegularSampler { cells: 1, filter: Filter::Box, seed: 0 };
    /// Largest number of cells along one side of a pixel.
    pub const MAX_CELLS_PER_SIDE: u16 = 256;

    /// A sampler with `n` times `n` rays per pixel; `None` if `n` is not in
    /// `1..=`[`RegularSampler::MAX_CELLS_PER_SIDE`].
    pub fn new(n: u16) -> Option<Self> {
        (n >= 1 && n <= Self::MAX_CELLS_PER_SIDE).then_some(RegularSampler { cells: n, ..Self::CENTER })
    }

    /// The same sampler with this reconstruction filter, [`Filter::Box`] by default. The filter distributes the
    /// rays, which all have equal weight; those of wider filters leave the pixel.
    pub fn with_filter(self, filter: Filter) -> Self {
        RegularSampler { filter, ..self }
    }

    /// The same sampler with this seed of the random numbers, 0 by default.
    pub fn with_seed(self, seed: u32) -> Self {
        RegularSampler { seed, ..self }
    }
}

impl Sampler for RegularSampler {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let n = Real::from(self.cells);
        let cell_center = |cell: u16| (Real::from(cell) + 0.5) / n;
        let mut mean = SampleMean::EMPTY;
        let mut index = 0;
        for y in 0..self.cells {
            for x in 0..self.cells {
                let [x, y] = sample_filter(self.filter, [cell_center(x), cell_center(y)]);
                mean.add(tracer.trace(CameraSample {
                    point: film_point(pixel, x, y),
                    sequence: sequence(pixel, index, self.seed),
                }));
                index += 1;
            }
        }
        mean.sample()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::CenterSampler;
    use crate::math::Rgb;
    use crate::trace::HitId;

    #[test]
    fn one_cell_is_the_center_of_the_pixel() {
        let pixel = Pixel { x: 3, y: 2 };
        let mut samples = [None; 2];
        CenterSampler.sample_pixel(pixel, &mut |sample: CameraSample| {
            samples[0] = Some(sample);
            PixelSample::BLACK
        });
        RegularSampler::new(1).unwrap().sample_pixel(pixel, &mut |sample: CameraSample| {
            samples[1] = Some(sample);
            PixelSample::BLACK
        });
        assert_eq!(samples[0], samples[1]);
        let point = samples[0].unwrap().point;
        assert_eq!((point.x, point.y), (3.5, 2.5));
    }

    #[test]
    fn the_cells_have_the_mean_of_a_slope() {
        for filter in [Filter::Box, Filter::Tent] {
            let mut rays = 0;
            let mean = RegularSampler::new(4).unwrap().with_filter(filter).sample_pixel(
                Pixel { x: 0, y: 0 },
                &mut |sample: CameraSample| {
                    rays += 1;
                    PixelSample { color: Rgb::new(sample.point.x, sample.point.y, 1.0), hit: HitId::Nothing }
                },
            );
            assert_eq!((rays, mean.color), (16, Rgb::new(0.5, 0.5, 1.0)));
        }
        assert!(RegularSampler::new(0).is_none() && RegularSampler::new(257).is_none());
    }
}
