//! Which rays make a pixel.

use super::pixel::Pixel;
use crate::math::{Real, Rgb};
use crate::scene::Place;

/// Chooses the places of a pixel that rays are sent through, and makes one colour of them.
pub trait Sampler {
    /// The colour of `pixel`. `shoot` traces one camera ray.
    fn color(&mut self, pixel: Pixel, shoot: &mut impl FnMut(Place) -> Rgb) -> Rgb;
}

/// The place `(x, y)` inside a pixel, from its upper left corner; both in `0..=1`.
pub(super) fn inside(pixel: Pixel, x: Real, y: Real) -> Place {
    Place { x: pixel.x as Real + x, y: pixel.y as Real + y }
}
