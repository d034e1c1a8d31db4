//! Sinks: receivers of finished pixels.

use core::convert::Infallible;

use super::pixel::{Pixel, Tile};
use crate::math::Rgb;
use crate::trace::{HitId, PixelSample};

/// Receives finished pixels: a [`Framebuffer`], a display, a serial port.
///
/// A closure is a sink that cannot fail:
///
/// ```
/// use strahl_core::Rgb;
/// use strahl_core::image::{Pixel, Sink};
///
/// let mut row = [[0; 3]; 320]; // sRGB bytes
/// let mut sink = |pixel: Pixel, color: Rgb| row[pixel.x as usize] = color.to_srgb8();
/// let Ok(()) = sink.put(Pixel { x: 7, y: 0 }, Rgb::WHITE);
/// assert_eq!(row[7], [255; 3]);
/// ```
pub trait Sink {
    /// Error of the receiver: [`Infallible`] for memory, a bus error for a display.
    type Error;

    /// Receives the color of a pixel.
    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Self::Error>;

    /// Receives the sample of a pixel: its color and the item that was hit. By default only the color is
    /// used.
    fn put_sample(&mut self, pixel: Pixel, sample: PixelSample) -> Result<(), Self::Error> {
        self.put(pixel, sample.color)
    }
}

/// A closure as a sink.
impl<F: FnMut(Pixel, Rgb)> Sink for F {
    type Error = Infallible;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Infallible> {
        self(pixel, color);
        Ok(())
    }
}

/// What a [`Framebuffer`] stores of a pixel: its color or its whole sample.
pub trait FramebufferPixel: Copy {
    /// Value of a pixel without light.
    const EMPTY: Self;

    /// The value for a sample.
    fn from_sample(sample: PixelSample) -> Self;
}

/// Stores the color.
impl FramebufferPixel for Rgb {
    const EMPTY: Self = Rgb::BLACK;

    fn from_sample(sample: PixelSample) -> Self {
        sample.color
    }
}

/// Stores the whole sample, for a [`PretracedCorners`](super::PretracedCorners).
impl FramebufferPixel for PixelSample {
    const EMPTY: Self = PixelSample::BLACK;

    fn from_sample(sample: PixelSample) -> Self {
        sample
    }
}

/// One tile of a picture in a caller-provided buffer, row by row: a [`Sink`] that ignores pixels outside of
/// the tile.
///
/// * `R`: what is stored of a pixel, its color ([`Rgb`]) or its whole [`PixelSample`].
#[derive(Debug)]
pub struct Framebuffer<'m, R = Rgb> {
    tile: Tile,
    pixels: &'m mut [R],
}

impl<'m, R: FramebufferPixel> Framebuffer<'m, R> {
    /// A framebuffer of `tile` in `pixels`; `None` if the length of `pixels` is not that of the tile.
    ///
    /// ```
    /// use strahl_core::image::{Framebuffer, Pixel, Sink};
    /// use strahl_core::{Resolution, Rgb, Tile};
    ///
    /// let mut picture = [Rgb::BLACK; 2 * 2];
    /// let tile = Tile::full(Resolution::new(2, 2).unwrap());
    /// let mut framebuffer = Framebuffer::new(tile, &mut picture).unwrap();
    /// let Ok(()) = framebuffer.put(Pixel { x: 1, y: 0 }, Rgb::WHITE);
    /// assert_eq!(picture[1], Rgb::WHITE);
    /// ```
    pub fn new(tile: Tile, pixels: &'m mut [R]) -> Option<Self> {
        (pixels.len() == tile.len()).then_some(Framebuffer { tile, pixels })
    }
}

impl<R: FramebufferPixel> Sink for Framebuffer<'_, R> {
    type Error = Infallible;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Infallible> {
        self.put_sample(pixel, PixelSample { color, hit: HitId::Nothing })
    }

    fn put_sample(&mut self, pixel: Pixel, sample: PixelSample) -> Result<(), Infallible> {
        if let Some(slot) = self.tile.index_of(pixel).and_then(|index| self.pixels.get_mut(index)) {
            *slot = R::from_sample(sample);
        }
        Ok(())
    }
}
