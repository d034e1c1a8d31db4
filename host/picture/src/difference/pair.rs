//! Conversion of two pictures to the same type, so that their pixels can be compared.

use rayon::prelude::*;
use strahl_core::{Resolution, Rgb};

use super::measure::{Channel, Limit, Measures, Peak, differences, measure};
use super::ssim::ssim;
use crate::read::PixelValues;
use crate::srgb;

/// Two pictures of one size.
#[derive(Debug)]
pub enum Pair {
    /// 8-bit, sRGB-encoded.
    Eight([Vec<[u8; 3]>; 2]),
    /// 16-bit, sRGB-encoded.
    Sixteen([Vec<[u16; 3]>; 2]),
    /// Linear floats.
    Floats {
        /// The sRGB-encoded values.
        encoded: [Vec<[f32; 3]>; 2],
        /// The linear values.
        linear: [Vec<Rgb>; 2],
    },
}

impl Pair {
    /// Converts two pictures to the same type: of two integer types the finer one, which represents the other exactly;
    /// floats are rounded to the integer type of the other picture.
    pub fn of(first: PixelValues, second: PixelValues) -> Self {
        use PixelValues::{Linear, U8, U16};
        match (first, second) {
            (U8(a), U8(b)) => Pair::Eight([a, b]),
            (U16(a), U16(b)) => Pair::Sixteen([a, b]),
            (U8(a), U16(b)) => Pair::Sixteen([widened(&a), b]),
            (U16(a), U8(b)) => Pair::Sixteen([a, widened(&b)]),
            (Linear(a), U8(b)) => Pair::Eight([eight(&a), b]),
            (U8(a), Linear(b)) => Pair::Eight([a, eight(&b)]),
            (Linear(a), U16(b)) => Pair::Sixteen([sixteen(&a), b]),
            (U16(a), Linear(b)) => Pair::Sixteen([a, sixteen(&b)]),
            (Linear(a), Linear(b)) => Pair::Floats { encoded: [encoded(&a), encoded(&b)], linear: [a, b] },
        }
    }

    /// The measures of single pixels.
    pub fn measure(&self, width: usize, limit: Limit) -> Measures {
        match self {
            Pair::Eight([a, b]) => measure(a, b, width, limit, |at| a[at] != b[at]),
            Pair::Sixteen([a, b]) => measure(a, b, width, limit, |at| a[at] != b[at]),
            Pair::Floats { encoded: [a, b], linear: [la, lb] } => {
                measure(a, b, width, limit, |at| bits(la[at]) != bits(lb[at]))
            }
        }
    }

    /// The mean structural similarity: 1 is identical.
    pub fn ssim(&self, size: Resolution) -> f64 {
        let (width, height) = (size.width() as usize, size.height() as usize);
        match self {
            Pair::Eight([a, b]) => ssim(a, b, width, height),
            Pair::Sixteen([a, b]) => ssim(a, b, width, height),
            Pair::Floats { encoded: [a, b], .. } => ssim(a, b, width, height),
        }
    }

    /// The largest difference in each pixel.
    pub fn differences(&self) -> Vec<f64> {
        match self {
            Pair::Eight([a, b]) => differences(a, b),
            Pair::Sixteen([a, b]) => differences(a, b),
            Pair::Floats { encoded: [a, b], .. } => differences(a, b),
        }
    }

    /// The largest difference of linear light; infinite if only one of two values is finite. `None` for integers.
    pub fn linear_peak(&self, width: usize) -> Option<Peak> {
        let Pair::Floats { linear: [a, b], .. } = self else {
            return None;
        };
        let mut peak = Peak::NONE;
        for (at, (a, b)) in a.iter().zip(b).enumerate() {
            let difference = |a: f32, b: f32| match f64::from(a) - f64::from(b) {
                difference if difference.is_finite() => difference.abs(),
                _ if a == b || (a.is_nan() && b.is_nan()) => 0.0,
                _ => f64::INFINITY,
            };
            let all = [difference(a.r, b.r), difference(a.g, b.g), difference(a.b, b.b)];
            peak.raise(at % width, at / width, all);
        }
        Some(peak)
    }
}

fn bits(color: Rgb) -> [u32; 3] {
    [color.r, color.g, color.b].map(f32::to_bits)
}

/// 8-bit values as 16-bit values: 255 * 257 = 65535.
fn widened(pixels: &[[u8; 3]]) -> Vec<[u16; 3]> {
    pixels.iter().map(|pixel| pixel.map(|v| u16::from(v) * 257)).collect()
}

/// Rounds to 8 bits, as picture files are written.
fn eight(pixels: &[Rgb]) -> Vec<[u8; 3]> {
    pixels.par_iter().map(|color| color.to_srgb8()).collect()
}

fn sixteen(pixels: &[Rgb]) -> Vec<[u16; 3]> {
    let round = |v| (srgb::encode(v) * 65535.0 + 0.5) as u16;
    pixels.par_iter().map(|c| [c.r, c.g, c.b].map(round)).collect()
}

fn encoded(pixels: &[Rgb]) -> Vec<[f32; 3]> {
    pixels.par_iter().map(|c| [c.r, c.g, c.b].map(|v| srgb::encode(v) as f32)).collect()
}

impl Channel for u8 {
    fn value(self) -> f64 {
        f64::from(self) / 255.0
    }

    fn difference(self, other: Self) -> f64 {
        f64::from(self.abs_diff(other)) / 255.0
    }
}

impl Channel for u16 {
    fn value(self) -> f64 {
        f64::from(self) / 65535.0
    }

    fn difference(self, other: Self) -> f64 {
        f64::from(self.abs_diff(other)) / 65535.0
    }
}

impl Channel for f32 {
    fn value(self) -> f64 {
        if self.is_nan() { 0.0 } else { f64::from(self) }
    }

    /// 1, the largest possible difference, if only one of the two is NaN.
    fn difference(self, other: Self) -> f64 {
        match (self.is_nan(), other.is_nan()) {
            (false, false) => (f64::from(self) - f64::from(other)).abs(),
            (true, true) => 0.0,
            _ => 1.0,
        }
    }
}
