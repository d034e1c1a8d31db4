//! Where pixels go.

use core::convert::Infallible;

use super::pixel::{Pixel, Tile};
use crate::math::Rgb;

/// Somebody who takes pixels: memory, a display, a line to a computer.
pub trait Sink {
    /// What can go wrong: [`Infallible`] for memory, a bus error for a display.
    type Error;

    /// Takes the colour of one pixel.
    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Self::Error>;
}

/// A closure is a sink that cannot fail.
impl<F: FnMut(Pixel, Rgb)> Sink for F {
    type Error = Infallible;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Infallible> {
        self(pixel, color);
        Ok(())
    }
}

/// Linear colours in lent memory, row by row. Pixels outside the tile are dropped.
#[derive(Debug)]
pub struct Frame<'m> {
    tile: Tile,
    colors: &'m mut [Rgb],
}

impl<'m> Frame<'m> {
    /// A frame for the pixels of `tile`; none when `colors` is not as long as the tile.
    pub fn new(tile: Tile, colors: &'m mut [Rgb]) -> Option<Self> {
        (colors.len() == tile.len()).then_some(Frame { tile, colors })
    }
}

impl Sink for Frame<'_> {
    type Error = Infallible;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Infallible> {
        if let Some(slot) = self.tile.place(pixel).and_then(|place| self.colors.get_mut(place)) {
            *slot = color;
        }
        Ok(())
    }
}
