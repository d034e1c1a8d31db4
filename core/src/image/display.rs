//! A display as a sink: whatever draws for `embedded-graphics` takes pictures too.

use embedded_graphics_core::Pixel as Dot;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Point;
use embedded_graphics_core::pixelcolor::{Bgr565, Bgr666, Bgr888, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor};

use super::pixel::Pixel;
use super::sink::Sink;
use crate::math::Rgb;

/// How the colours of a picture become the fewer ones of a display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dither {
    /// Each channel is rounded to its nearest step: smooth surfaces show bands.
    None,
    /// The rounding changes from pixel to pixel in squares of four by four, so that a square is as
    /// bright as its mean would be (Bayer 1973). Steps that a display shows anyway stay as they are.
    Ordered,
}

/// A colour of a display that is made of the steps of its channels.
pub trait Steps: RgbColor {
    /// The colour of red, green and blue, each up to its channel's largest step.
    fn of(steps: [u8; 3]) -> Self;
}

macro_rules! steps {
    ($($Color:ident)*) => {$(
        impl Steps for $Color {
            fn of([r, g, b]: [u8; 3]) -> Self {
                $Color::new(r, g, b)
            }
        }
    )*};
}
steps!(Rgb555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);

/// Draws pixels on a display, in the sRGB encoding, each as it comes.
///
/// The pixel in the upper left corner of the picture lies at `origin`. What lies outside of the
/// display is the display's business.
#[derive(Debug)]
pub struct Display<'d, D> {
    target: &'d mut D,
    origin: Point,
    dither: Dither,
}

impl<'d, D> Display<'d, D> {
    /// Draws on `target`.
    pub fn new(target: &'d mut D, origin: Point, dither: Dither) -> Self {
        Display { target, origin, dither }
    }
}

impl<D: DrawTarget<Color: Steps>> Sink for Display<'_, D> {
    type Error = D::Error;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), D::Error> {
        let [r, g, b] = color.to_srgb8();
        let step = |value, most| step(value, most, pixel, self.dither);
        let color =
            D::Color::of([step(r, D::Color::MAX_R), step(g, D::Color::MAX_G), step(b, D::Color::MAX_B)]);
        let at = |origin: i32, offset: u32| origin.saturating_add(i32::try_from(offset).unwrap_or(i32::MAX));
        let point = Point::new(at(self.origin.x, pixel.x), at(self.origin.y, pixel.y));
        self.target.draw_iter([Dot(point, color)])
    }
}

/// The order in which the pixels of a square become brighter.
const ORDER: [[u32; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// One of `most` steps for a value of 255.
fn step(value: u8, most: u8, Pixel { x, y }: Pixel, dither: Dither) -> u8 {
    // In 32nds of a step: rounding adds a half, the order its place in the square, from 1 to 31.
    let added = match dither {
        Dither::None => 16,
        Dither::Ordered => {
            let row = ORDER.get((y & 3) as usize);
            31 - 2 * row.and_then(|row| row.get((x & 3) as usize)).copied().unwrap_or(0)
        }
    };
    ((u32::from(value) * u32::from(most) * 32 / 255 + added) / 32) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::mock_display::MockDisplay;

    fn drawn(colors: [Rgb; 4], dither: Dither) -> MockDisplay<Rgb565> {
        let mut mock = MockDisplay::new();
        let mut display = Display::new(&mut mock, Point::new(1, 0), dither);
        for (color, x) in colors.into_iter().zip(0..) {
            let Ok(()) = display.put(Pixel { x, y: 0 }, color);
        }
        mock
    }

    #[test]
    fn a_display_shows_the_colours_where_they_belong() {
        let colors = [Rgb::new(1.0, 0.0, 0.0), Rgb::new(0.0, 7.0, 0.0), Rgb::new(0.0, 0.0, 1.0), Rgb::WHITE];
        for dither in [Dither::None, Dither::Ordered] {
            drawn(colors, dither).assert_pattern(&[" RGBW"]);
        }
    }

    #[test]
    fn a_square_is_as_bright_as_its_mean_would_be() {
        for value in 0..=255_u8 {
            let all = (0..16).map(|i| Pixel { x: i % 4, y: i / 4 });
            let sum: u32 = all.map(|pixel| u32::from(step(value, 31, pixel, Dither::Ordered))).sum();
            let mean = 16.0 * f64::from(value) * 31.0 / 255.0;
            assert!((f64::from(sum) - mean).abs() <= 1.0, "{value}: {sum} is not {mean}");
            // With as many steps as there are, nothing is left to be dithered.
            assert_eq!(step(value, 255, Pixel { x: 1, y: 2 }, Dither::Ordered), value);
        }
    }

    #[test]
    fn without_dither_each_step_is_the_nearest() {
        for value in 0..=255_u8 {
            let nearest = (f64::from(value) * 31.0 / 255.0).round() as u8;
            assert!(
                step(value, 31, Pixel { x: 3, y: 1 }, Dither::None).abs_diff(nearest) <= u8::from(value == 0)
            );
        }
    }
}
