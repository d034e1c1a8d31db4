//! Linear radiance in three channels.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use core::ops::{Add, AddAssign, Mul, MulAssign};

use super::srgb::{encode, encode8};
use super::{Real, greatest, least};

/// Linear light in red, green and blue: a colour, a share or a radiance.
///
/// Nothing clamps it to 1: it is as bright as it is, until [`Rgb::to_srgb8`] encodes it.
#[derive(Clone, Copy, Debug, Default, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Rgb {
    /// Red.
    pub r: Real,
    /// Green.
    pub g: Real,
    /// Blue.
    pub b: Real,
}

impl Rgb {
    /// No light.
    pub const BLACK: Rgb = Rgb::gray(0.0);
    /// One in every channel.
    pub const WHITE: Rgb = Rgb::gray(1.0);
    /// The brightest colour or intensity that a scene may name.
    pub const BRIGHTEST: Real = 1e6;

    /// A colour from its channels.
    pub const fn new(r: Real, g: Real, b: Real) -> Self {
        Rgb { r, g, b }
    }

    /// The same in every channel.
    pub const fn gray(v: Real) -> Self {
        Rgb { r: v, g: v, b: v }
    }

    /// The brightest channel.
    pub fn largest(self) -> Real {
        greatest(self.r, greatest(self.g, self.b))
    }

    /// Whether no channel is above zero.
    pub fn is_black(self) -> bool {
        !(self.r > 0.0 || self.g > 0.0 || self.b > 0.0)
    }

    /// Whether every channel lies in `0..=most`.
    #[inline(never)] // doors ask it in many places, where its size counts and not its time
    pub fn is_within(self, most: Real) -> bool {
        let ok = |v: Real| v >= 0.0 && v <= most;
        ok(self.r) && ok(self.g) && ok(self.b)
    }

    /// Every channel above `most` set to `most`. Sums and products of what a scene may hold
    /// stay finite when each of their parts is held below such a limit.
    pub fn at_most(self, most: Real) -> Self {
        let cap = |v: Real| if v < most { v } else { most };
        Rgb { r: cap(self.r), g: cap(self.g), b: cap(self.b) }
    }

    /// The way from this colour to `other`, `s` of it gone: `0` is here, `1` is there.
    pub fn toward(self, other: Rgb, s: Real) -> Self {
        self * (1.0 - s) + other * s
    }

    /// Each channel applied to `f`.
    pub fn map(self, f: impl Fn(Real) -> Real) -> Self {
        Rgb { r: f(self.r), g: f(self.g), b: f(self.b) }
    }

    /// How far apart the encoded channels of some colours are (sRGB, in `0..=1`), the largest
    /// of the three channels. Of no colours: 0.
    pub fn contrast(colors: impl IntoIterator<Item = Rgb>) -> Real {
        let mut colors = colors.into_iter();
        let Some(first) = colors.next() else { return 0.0 };
        let (mut low, mut high) = (first, first);
        for color in colors {
            low = Rgb { r: least(low.r, color.r), g: least(low.g, color.g), b: least(low.b, color.b) };
            high = Rgb {
                r: greatest(high.r, color.r),
                g: greatest(high.g, color.g),
                b: greatest(high.b, color.b),
            };
        }
        // The encoding grows with the light, so that the ends stay the ends.
        let apart = |low: Real, high: Real| if low < high { encode(high) - encode(low) } else { 0.0 };
        greatest(apart(low.r, high.r), greatest(apart(low.g, high.g), apart(low.b, high.b)))
    }

    /// Eight bits per channel in the sRGB encoding (IEC 61966-2-1): values outside `[0, 1]`
    /// are cut off, the rest is rounded to the nearest step.
    pub fn to_srgb8(self) -> [u8; 3] {
        [encode8(self.r), encode8(self.g), encode8(self.b)]
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
    fn the_srgb_encoding_meets_its_known_values() {
        // Mid grey 128 stands for 0.2158605 of linear light; the ends stay ends.
        assert_eq!(Rgb::new(0.0, 0.215_860_5, 1.0).to_srgb8(), [0, 128, 255]);
        assert_eq!(Rgb::new(-1.0, 7.0, Real::NAN).to_srgb8(), [0, 255, 0]);
        // On the straight part: 0.002 * 12.92 * 255 = 6.59.
        assert_eq!(Rgb::gray(0.002).to_srgb8(), [7; 3]);
    }

    #[test]
    fn contrast_is_the_largest_difference_as_it_is_seen() {
        let gray = [Rgb::gray(0.215_860_5), Rgb::BLACK, Rgb::gray(0.1)];
        assert!((Rgb::contrast(gray) - 128.0 / 255.0).abs() < 1e-6);
        // What is brighter than white is seen as white.
        assert_eq!(Rgb::contrast([Rgb::WHITE, Rgb::gray(7.0)]), 0.0);
        assert_eq!(Rgb::contrast([Rgb::new(0.0, 1.0, 0.5), Rgb::new(0.0, 0.0, 0.5)]), 1.0);
        assert_eq!(Rgb::contrast([]), 0.0);
    }

    #[test]
    fn a_cap_holds_infinity_too() {
        assert_eq!(Rgb::new(Real::INFINITY, 5.0, 0.5).at_most(5.0), Rgb::new(5.0, 5.0, 0.5));
    }
}
