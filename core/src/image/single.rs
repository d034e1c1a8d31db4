//! One ray through the middle of each pixel.

use super::pixel::Pixel;
use super::sampler::{Sampler, inside, stream};
use crate::scene::CameraSample;
use crate::trace::{PixelSample, RayTracer};

/// One ray through the middle, with the numbers of seed 0. With another seed it is
/// [`Regular::ONE`](super::Regular::ONE).
#[derive(Clone, Copy, Debug)]
pub struct Single;

impl Sampler for Single {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        tracer.trace(CameraSample { point: inside(pixel, 0.5, 0.5), sequence: stream(pixel, 0, 0) })
    }
}
