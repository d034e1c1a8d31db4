//! Regular supersampling: each pixel is cut into n times n cells with a ray through each.

use super::filter::Filter;
use super::filter_sample::filtered;
use super::pixel::Pixel;
use super::sampler::{Mean, Sampler, inside, stream};
use crate::math::Real;
use crate::scene::CameraSample;
use crate::trace::{PixelSample, RayTracer};

/// Rays through the middles of `n` times `n` equal cells; the mean of what they see.
#[derive(Clone, Copy, Debug)]
pub struct Regular {
    n: u16,
    filter: Filter,
    seed: u32,
}

impl Regular {
    /// One ray through the middle.
    pub const ONE: Regular = Regular { n: 1, filter: Filter::Box, seed: 0 };
    /// The most cells along one side.
    pub const MOST: u16 = 256;

    /// `n` times `n` rays; none when `n` is 0 or more than [`Regular::MOST`].
    pub fn new(n: u16) -> Option<Self> {
        (n >= 1 && n <= Self::MOST).then_some(Regular { n, ..Self::ONE })
    }

    /// The same with this filter, which spreads the cells over its surroundings.
    pub fn filtered(self, filter: Filter) -> Self {
        Regular { filter, ..self }
    }

    /// The same in the picture with this seed: what rays leave to chance changes.
    pub fn seeded(self, seed: u32) -> Self {
        Regular { seed, ..self }
    }
}

impl Sampler for Regular {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let n = Real::from(self.n);
        let middle = |cell: u16| (Real::from(cell) + 0.5) / n;
        let mut mean = Mean::NONE;
        let mut index = 0;
        for y in 0..self.n {
            for x in 0..self.n {
                let [x, y] = filtered(self.filter, [middle(x), middle(y)]);
                mean.add(tracer.trace(CameraSample {
                    point: inside(pixel, x, y),
                    sequence: stream(pixel, index, self.seed),
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
    use crate::image::Single;
    use crate::math::Rgb;
    use crate::trace::HitId;

    #[test]
    fn one_cell_is_the_middle_of_the_pixel() {
        let pixel = Pixel { x: 3, y: 2 };
        let mut samples = [None; 2];
        Single.sample_pixel(pixel, &mut |sample: CameraSample| {
            samples[0] = Some(sample);
            PixelSample::BLACK
        });
        Regular::new(1).unwrap().sample_pixel(pixel, &mut |sample: CameraSample| {
            samples[1] = Some(sample);
            PixelSample::BLACK
        });
        assert_eq!(samples[0], samples[1]);
        let place = samples[0].unwrap().point;
        assert_eq!((place.x, place.y), (3.5, 2.5));
    }

    #[test]
    fn the_cells_have_the_mean_of_a_slope() {
        for filter in [Filter::Box, Filter::Tent] {
            let mut rays = 0;
            let mean = Regular::new(4).unwrap().filtered(filter).sample_pixel(
                Pixel { x: 0, y: 0 },
                &mut |sample: CameraSample| {
                    rays += 1;
                    PixelSample { color: Rgb::new(sample.point.x, sample.point.y, 1.0), hit: HitId::Nothing }
                },
            );
            assert_eq!((rays, mean.color), (16, Rgb::new(0.5, 0.5, 1.0)));
        }
        assert!(Regular::new(0).is_none() && Regular::new(257).is_none());
    }
}
