//! Linear colors with three channels.

use core::ops::{Add, AddAssign, Mul, MulAssign};

use super::srgb::{encode_srgb, encode_srgb8};
use super::{Real, max, min};

/// Linear red, green and blue, with the primaries of sRGB: a color, a reflectance or a radiance.
///
/// Channels may exceed 1. Only [`Rgb::to_srgb8`] clamps them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Rgb {
    /// Red, linear.
    pub r: Real,
    /// Green, linear.
    pub g: Real,
    /// Blue, linear.
    pub b: Real,
}

impl Rgb {
    /// Zero in every channel.
    pub const BLACK: Rgb = Rgb::gray(0.0);
    /// One in every channel.
    pub const WHITE: Rgb = Rgb::gray(1.0);
    /// Largest channel of a color or intensity in a scene.
    pub const MAX_CHANNEL: Real = 1e6;

    /// A color with the given channels.
    pub const fn new(r: Real, g: Real, b: Real) -> Self {
        Rgb { r, g, b }
    }

    /// A color with `v` in every channel.
    pub const fn gray(v: Real) -> Self {
        Rgb { r: v, g: v, b: v }
    }

    /// The largest channel.
    pub fn max_component(self) -> Real {
        max(self.r, max(self.g, self.b))
    }

    /// Whether no channel is above zero.
    pub fn is_black(self) -> bool {
        !(self.r > 0.0 || self.g > 0.0 || self.b > 0.0)
    }

    /// Whether every channel is in `0..=max`. False for NaN.
    #[inline(never)] // validation calls it often: code size matters there, time does not
    pub fn is_in_range(self, max: Real) -> bool {
        let ok = |v: Real| v >= 0.0 && v <= max;
        ok(self.r) && ok(self.g) && ok(self.b)
    }

    /// Limits every channel to at most `max`; negative channels stay. NaN becomes `max`.
    ///
    /// Sums and products of colors stay finite if every term is limited.
    pub fn clamp_max(self, max: Real) -> Self {
        let limit = |v: Real| if v < max { v } else { max };
        Rgb { r: limit(self.r), g: limit(self.g), b: limit(self.b) }
    }

    /// Linear interpolation: `self` at `t = 0`, `end` at `t = 1`; other `t` extrapolate.
    pub fn lerp(self, end: Rgb, t: Real) -> Self {
        self * (1.0 - t) + end * t
    }

    /// Applies `f` to each channel.
    pub fn map(self, f: impl Fn(Real) -> Real) -> Self {
        Rgb { r: f(self.r), g: f(self.g), b: f(self.b) }
    }

    /// Largest difference between sRGB-encoded values of one channel in `colors`, in `0..=1`.
    ///
    /// It is 0 for fewer than two colors.
    pub fn contrast(colors: impl IntoIterator<Item = Rgb>) -> Real {
        let mut colors = colors.into_iter();
        let Some(first) = colors.next() else { return 0.0 };
        let (mut low, mut high) = (first, first);
        for color in colors {
            low = Rgb { r: min(low.r, color.r), g: min(low.g, color.g), b: min(low.b, color.b) };
            high = Rgb { r: max(high.r, color.r), g: max(high.g, color.g), b: max(high.b, color.b) };
        }
        // The encoding is monotone, so encoding the extremes is enough.
        let encoded_difference =
            |low: Real, high: Real| if low < high { encode_srgb(high) - encode_srgb(low) } else { 0.0 };
        max(
            encoded_difference(low.r, high.r),
            max(encoded_difference(low.g, high.g), encoded_difference(low.b, high.b)),
        )
    }

    /// The sRGB encoding with 8 bits per channel (IEC 61966-2-1), rounded to the nearest code.
    ///
    /// Values outside `[0, 1]` are clamped. NaN becomes 0.
    pub fn to_srgb8(self) -> [u8; 3] {
        [encode_srgb8(self.r), encode_srgb8(self.g), encode_srgb8(self.b)]
    }
}

impl Add for Rgb {
    type Output = Rgb;
    fn add(self, o: Rgb) -> Rgb {
        Rgb { r: self.r + o.r, g: self.g + o.g, b: self.b + o.b }
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, o: Rgb) {
        *self = *self + o;
    }
}

impl Mul for Rgb {
    type Output = Rgb;
    fn mul(self, o: Rgb) -> Rgb {
        Rgb { r: self.r * o.r, g: self.g * o.g, b: self.b * o.b }
    }
}

impl Mul<Real> for Rgb {
    type Output = Rgb;
    fn mul(self, s: Real) -> Rgb {
        Rgb { r: self.r * s, g: self.g * s, b: self.b * s }
    }
}

impl MulAssign for Rgb {
    fn mul_assign(&mut self, o: Rgb) {
        *self = *self * o;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values_have_their_srgb_codes() {
        // Code 128 is linear 0.2158605.
        assert_eq!(Rgb::new(0.0, 0.215_860_5, 1.0).to_srgb8(), [0, 128, 255]);
        assert_eq!(Rgb::new(-1.0, 7.0, Real::NAN).to_srgb8(), [0, 255, 0]);
        // The linear segment: 0.002 * 12.92 * 255 = 6.59.
        assert_eq!(Rgb::gray(0.002).to_srgb8(), [7; 3]);
    }

    #[test]
    fn contrast_is_the_largest_difference_of_encoded_channels() {
        let gray = [Rgb::gray(0.215_860_5), Rgb::BLACK, Rgb::gray(0.1)];
        assert!((Rgb::contrast(gray) - 128.0 / 255.0).abs() < 1e-6);
        // Values above white are encoded as white.
        assert_eq!(Rgb::contrast([Rgb::WHITE, Rgb::gray(7.0)]), 0.0);
        assert_eq!(Rgb::contrast([Rgb::new(0.0, 1.0, 0.5), Rgb::new(0.0, 0.0, 0.5)]), 1.0);
        assert_eq!(Rgb::contrast([]), 0.0);
    }

    #[test]
    fn an_infinite_channel_is_limited() {
        assert_eq!(Rgb::new(Real::INFINITY, 5.0, 0.5).clamp_max(5.0), Rgb::new(5.0, 5.0, 0.5));
    }
}
