//! Where pixels go.

use core::convert::Infallible;

use super::pixel::{Pixel, Tile};
use crate::math::Rgb;
use crate::trace::{HitId, PixelSample};

/// Somebody who takes pixels: memory, a display, a line to a computer.
pub trait Sink {
    /// What can go wrong: [`Infallible`] for memory, a bus error for a display.
    type Error;

    /// Takes the colour of one pixel.
    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Self::Error>;

    /// Takes what is seen in one pixel; who wants no more than its colour leaves this as it is.
    fn put_sample(&mut self, pixel: Pixel, sample: PixelSample) -> Result<(), Self::Error> {
        self.put(pixel, sample.color)
    }
}

/// A closure is a sink that cannot fail.
impl<F: FnMut(Pixel, Rgb)> Sink for F {
    type Error = Infallible;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Infallible> {
        self(pixel, color);
        Ok(())
    }
}

/// What is kept of a pixel.
pub trait FramebufferPixel: Copy {
    /// Of one in which nothing was seen.
    const EMPTY: Self;

    /// Of what was seen in it.
    fn from_sample(sample: PixelSample) -> Self;
}

/// Its light alone.
impl FramebufferPixel for Rgb {
    const EMPTY: Self = Rgb::BLACK;

    fn from_sample(sample: PixelSample) -> Self {
        sample.color
    }
}

/// AllEffects, as a [`Lattice`](super::Lattice) needs it.
impl FramebufferPixel for PixelSample {
    const EMPTY: Self = PixelSample::BLACK;

    fn from_sample(sample: PixelSample) -> Self {
        sample
    }
}

/// Records of pixels in lent memory, row by row. Pixels outside the tile are dropped.
#[derive(Debug)]
pub struct Framebuffer<'m, R = Rgb> {
    tile: Tile,
    pixels: &'m mut [R],
}

impl<'m, R: FramebufferPixel> Framebuffer<'m, R> {
    /// A frame for the pixels of `tile`; none when `records` is not as long as the tile.
    pub fn new(tile: Tile, records: &'m mut [R]) -> Option<Self> {
        (records.len() == tile.len()).then_some(Framebuffer { tile, pixels: records })
    }
}

impl<R: FramebufferPixel> Sink for Framebuffer<'_, R> {
    type Error = Infallible;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Infallible> {
        self.put_sample(pixel, PixelSample { color, hit: HitId::Nothing })
    }

    fn put_sample(&mut self, pixel: Pixel, sample: PixelSample) -> Result<(), Infallible> {
        if let Some(slot) = self.tile.index_of(pixel).and_then(|place| self.pixels.get_mut(place)) {
            *slot = R::from_sample(sample);
        }
        Ok(())
    }
}
