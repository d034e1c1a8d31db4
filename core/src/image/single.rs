//! One ray through the middle of each pixel.

use super::pixel::Pixel;
use super::sampler::{Sampler, inside, stream};
use crate::scene::Sample;
use crate::trace::Sight;

/// One ray through the middle, with the numbers of seed 0. With another seed it is
/// [`Regular::ONE`](super::Regular::ONE).
#[derive(Clone, Copy, Debug)]
pub struct Single;

impl Sampler for Single {
    fn look(&mut self, pixel: Pixel, shoot: &mut impl FnMut(Sample) -> Sight) -> Sight {
        shoot(Sample { place: inside(pixel, 0.5, 0.5), stream: stream(pixel, 0, 0) })
    }
}
