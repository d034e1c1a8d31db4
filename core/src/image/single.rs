//! One ray through the middle of each pixel.

use super::pixel::Pixel;
use super::sampler::{Sampler, inside};
use crate::math::Rgb;
use crate::scene::Place;

/// One ray through the middle.
#[derive(Clone, Copy, Debug)]
pub struct Single;

impl Sampler for Single {
    fn color(&mut self, pixel: Pixel, shoot: &mut impl FnMut(Place) -> Rgb) -> Rgb {
        shoot(inside(pixel, 0.5, 0.5))
    }
}
