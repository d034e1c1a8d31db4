//! The sRGB transfer function of one channel (IEC 61966-2-1).
//!
//! [`encode_srgb`] evaluates the formula, which needs a power. [`encode_srgb8`] needs none: each of the
//! 256 codes stands for a range of linear values, and a binary search among the thresholds between them
//! finds the code. The thresholds are computed at compile time by basic operations, so they are the same
//! everywhere. For every `f32` the code is that of exact arithmetic; the rounding errors of a power
//! would give another code at some thresholds.

use super::{Real, powf};

/// The sRGB encoding of the linear value `v`, in `0..=1`. Values outside are clamped; NaN becomes 0.
pub fn encode_srgb(v: Real) -> Real {
    if v >= 1.0 {
        1.0
    } else if v > 0.003_130_8 {
        1.055 * powf(v, 1.0 / 2.4) - 0.055
    } else if v > 0.0 {
        12.92 * v
    } else {
        0.0
    }
}

/// The sRGB encoding of `v` as an 8-bit code, rounded to the nearest, halves up. Values outside `[0, 1]`
/// are clamped; NaN becomes 0.
pub fn encode_srgb8(v: Real) -> u8 {
    THRESHOLDS.partition_point(|threshold| v >= *threshold as Real) as u8
}

/// The smallest linear value of each 8-bit code above 0.
///
/// The values are rounded up to `f32`, so they classify every `f32` as the exact thresholds do. The
/// double-precision package uses the same values because its pictures are stored in single precision. An
/// `f64` gets the next lower code only if it is between the exact threshold and the next `f32`.
#[expect(clippy::indexing_slicing, reason = "computed by the compiler")]
static THRESHOLDS: [f32; 255] = {
    let mut thresholds = [0.0; 255];
    let mut index = 0;
    while index < thresholds.len() {
        thresholds[index] = round_up_to_f32(decode_srgb((index as f64 + 0.5) / 255.0));
        index += 1;
    }
    thresholds
};

/// The linear value of an encoded value: the inverse of [`encode_srgb`].
const fn decode_srgb(encoded: f64) -> f64 {
    if encoded <= 0.040_45 {
        return encoded / 12.92;
    }
    let base = (encoded + 0.055) / 1.055;
    let square = base * base;
    // base^2.4 = square * square^(1/5). Newton's method from 1 reaches the fifth root in ten iterations;
    // later ones change it by rounding only.
    let (mut root, mut iteration) = (1.0, 0);
    while iteration < 20 {
        root = 0.8 * root + 0.2 * square / (root * root * root * root);
        iteration += 1;
    }
    square * root
}

/// The smallest `f32` that is at least `x`.
const fn round_up_to_f32(x: f64) -> f32 {
    let nearest = x as f32;
    if (nearest as f64) < x { nearest.next_up() } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The encoding by the formula of the standard, in `0..=255`, not rounded.
    fn exact_code(v: f64) -> f64 {
        let encoded = if v > 0.003_130_8 { 1.055 * libm::pow(v, 1.0 / 2.4) - 0.055 } else { 12.92 * v };
        encoded * 255.0
    }

    #[test]
    fn each_threshold_is_the_least_f32_that_rounds_to_its_code() {
        // More than the rounding errors of `exact_code`.
        const MARGIN: f64 = 1e-11;
        for (threshold, code) in THRESHOLDS.iter().zip(1..=u8::MAX) {
            let half = f64::from(code) - 0.5;
            let (at, below) =
                (exact_code(f64::from(*threshold)), exact_code(f64::from(threshold.next_down())));
            assert!(at >= half + MARGIN && below <= half - MARGIN, "{code}: {threshold}, {at}, {below}");
            assert_eq!(encode_srgb8(*threshold as Real), code);
            assert_eq!(encode_srgb8(threshold.next_down() as Real), code - 1);
        }
    }

    #[test]
    fn codes_agree_with_the_formula_except_for_its_rounding_errors_at_thresholds() {
        let (mut count, mut different) = (0, 0);
        // All exponents and, by a prime stride, all patterns of the last bits.
        for bits in (0..=1.25_f32.to_bits()).step_by(499) {
            let v = f32::from_bits(bits);
            let (code, formula) = (encode_srgb8(v as Real), (encode_srgb(v as Real) * 255.0 + 0.5) as u8);
            count += 1;
            if code != formula {
                different += 1;
                let distance = (exact_code(f64::from(v)) - f64::from(code.max(formula)) + 0.5).abs();
                assert!(
                    code.abs_diff(formula) == 1 && distance <= 1e-4,
                    "{v}: {code}, {formula}, {distance}"
                );
            }
        }
        assert!(count > 2_000_000 && different < 10, "{different} of {count}");
    }

    #[test]
    fn nan_and_negative_values_are_black_and_large_ones_white() {
        assert_eq!([Real::NAN, Real::NEG_INFINITY, -1.0, -0.0, 0.0, 1e-9].map(encode_srgb8), [0; 6]);
        assert_eq!([1.0, 1.0 + Real::EPSILON, 7.0, Real::MAX, Real::INFINITY].map(encode_srgb8), [255; 5]);
    }
}
