//! A sink that draws to displays of `embedded-graphics`.
//!
//! Source of the dither matrix: Bayer, "An Optimum Method for Two-Level Rendition of Continuous-Tone
//! Pictures", ICC 1973.

use embedded_graphics_core::Pixel as TargetPixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Point;
use embedded_graphics_core::pixelcolor::{Bgr565, Bgr666, Bgr888, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor};

use super::pixel::Pixel;
use super::sink::Sink;
use crate::math::Rgb;

/// How colors are reduced to the fewer levels of a display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dither {
    /// Each channel is rounded to the nearest level. Gradients show bands.
    None,
    /// Ordered dithering in squares of 4 by 4 pixels, whose mean approximates the color. Colors that the
    /// display can show stay unchanged.
    Ordered,
}

/// A color of `embedded-graphics` that is made of channel values.
///
/// Implemented for the RGB and BGR colors with 15, 16, 18 and 24 bits.
pub trait FromChannels: RgbColor {
    /// The color of red, green and blue, each in `0..=` the maximum of its channel.
    fn from_channels(channels: [u8; 3]) -> Self;
}

macro_rules! from_channels {
    ($($Color:ident)*) => {$(
        impl FromChannels for $Color {
            fn from_channels([r, g, b]: [u8; 3]) -> Self {
                $Color::new(r, g, b)
            }
        }
    )*};
}
from_channels!(Rgb555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);

/// A [`Sink`] that draws each pixel at once to a `DrawTarget`, in the sRGB encoding.
///
/// Requires the feature `display`. Pixels outside of the target are passed to it, too; a `DrawTarget`
/// ignores them.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
/// use strahl_core::Rgb;
/// use strahl_core::image::{Dither, DrawTargetSink, Pixel, Sink};
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let mut sink = DrawTargetSink::new(&mut display, Point::zero(), Dither::Ordered);
/// sink.put(Pixel { x: 1, y: 0 }, Rgb::new(1.0, 0.0, 0.0))?;
/// display.assert_pattern(&[" R"]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct DrawTargetSink<'d, D> {
    target: &'d mut D,
    origin: Point,
    dither: Dither,
}

impl<'d, D> DrawTargetSink<'d, D> {
    /// A sink that draws to `target`. `origin`: point of the target at which the upper left pixel of the
    /// picture is drawn.
    pub fn new(target: &'d mut D, origin: Point, dither: Dither) -> Self {
        DrawTargetSink { target, origin, dither }
    }
}

impl<D: DrawTarget<Color: FromChannels>> Sink for DrawTargetSink<'_, D> {
    type Error = D::Error;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), D::Error> {
        let [r, g, b] = color.to_srgb8();
        let quantize = |value, max| quantize(value, max, pixel, self.dither);
        let color = D::Color::from_channels([
            quantize(r, D::Color::MAX_R),
            quantize(g, D::Color::MAX_G),
            quantize(b, D::Color::MAX_B),
        ]);
        let at = |origin: i32, offset: u32| origin.saturating_add(i32::try_from(offset).unwrap_or(i32::MAX));
        let point = Point::new(at(self.origin.x, pixel.x), at(self.origin.y, pixel.y));
        self.target.draw_iter([TargetPixel(point, color)])
    }
}

/// Order in which the pixels of a square become brighter.
const BAYER_MATRIX: [[u32; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// The level in `0..=max` for a value in `0..=255`.
fn quantize(value: u8, max: u8, Pixel { x, y }: Pixel, dither: Dither) -> u8 {
    // In 32nds of a level: rounding adds a half, the matrix 1 to 31.
    let threshold = match dither {
        Dither::None => 16,
        Dither::Ordered => {
            let row = BAYER_MATRIX.get((y & 3) as usize);
            31 - 2 * row.and_then(|row| row.get((x & 3) as usize)).copied().unwrap_or(0)
        }
    };
    ((u32::from(value) * u32::from(max) * 32 / 255 + threshold) / 32) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::mock_display::MockDisplay;

    fn mock_with(colors: [Rgb; 4], dither: Dither) -> MockDisplay<Rgb565> {
        let mut mock = MockDisplay::new();
        let mut sink = DrawTargetSink::new(&mut mock, Point::new(1, 0), dither);
        for (color, x) in colors.into_iter().zip(0..) {
            let Ok(()) = sink.put(Pixel { x, y: 0 }, color);
        }
        mock
    }

    #[test]
    fn pixels_are_drawn_at_their_points() {
        let colors = [Rgb::new(1.0, 0.0, 0.0), Rgb::new(0.0, 7.0, 0.0), Rgb::new(0.0, 0.0, 1.0), Rgb::WHITE];
        for dither in [Dither::None, Dither::Ordered] {
            mock_with(colors, dither).assert_pattern(&[" RGBW"]);
        }
    }

    #[test]
    fn the_mean_of_a_dithered_square_is_the_color() {
        for value in 0..=255_u8 {
            let all = (0..16).map(|i| Pixel { x: i % 4, y: i / 4 });
            let sum: u32 = all.map(|pixel| u32::from(quantize(value, 31, pixel, Dither::Ordered))).sum();
            let mean = 16.0 * f64::from(value) * 31.0 / 255.0;
            assert!((f64::from(sum) - mean).abs() <= 1.0, "{value}: {sum} is not {mean}");
            // With 256 levels there is nothing to dither.
            assert_eq!(quantize(value, 255, Pixel { x: 1, y: 2 }, Dither::Ordered), value);
        }
    }

    #[test]
    fn without_dithering_each_level_is_the_nearest() {
        for value in 0..=255_u8 {
            let nearest = (f64::from(value) * 31.0 / 255.0).round() as u8;
            let level = quantize(value, 31, Pixel { x: 3, y: 1 }, Dither::None);
            assert!(level.abs_diff(nearest) <= u8::from(value == 0));
        }
    }
}
