//! One ray through the center of each pixel.

use super::pixel::Pixel;
use super::sampler::{Sampler, film_point, sequence};
use crate::scene::CameraSample;
use crate::trace::{PixelSample, RayTracer};

/// One ray through the center of each pixel, with seed 0.
///
/// [`RegularSampler::CENTER`](super::RegularSampler::CENTER) does the same with any seed.
#[derive(Clone, Copy, Debug)]
pub struct CenterSampler;

impl Sampler for CenterSampler {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        tracer.trace(CameraSample { point: film_point(pixel, 0.5, 0.5), sequence: sequence(pixel, 0, 0) })
    }
}
