//! The encoding of one channel of light in pictures: sRGB, IEC 61966-2-1.
//!
//! How far apart two colours look needs the encoded values ([`encode`]), and these a power. A picture of
//! eight bits needs none ([`encode8`]): each of its 256 values stands for a range of light, and which one
//! holds a channel is found by eight comparisons with the borders between them. The compiler counts
//! these out, by basic operations alone, so that they are the same numbers everywhere. For every `f32`
//! the answer is that of exact arithmetic, which the roundings of a power may miss at a border.

use super::{Real, powf};

/// The encoding of a channel, in `0..=1`; what lies beyond is cut off, and no number is 0.
pub fn encode(v: Real) -> Real {
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

/// The encoding of a channel in steps of 1/255, rounded to the nearest; half a step counts up.
pub fn encode8(v: Real) -> u8 {
    BORDERS.partition_point(|border| v >= *border as Real) as u8
}

/// From which light on each step above 0 is the nearest, found when compiling.
///
/// Rounded up to single precision, so that they part all of its numbers as the true borders do. The
/// twin has the same ones, for its pictures are written in single precision; it takes a double for the
/// step below only where that lies between the true border and the next `f32` above.
static BORDERS: [f32; 255] = {
    let mut borders = [0.0; 255];
    let mut step = 0;
    while step < borders.len() {
        borders[step] = rounded_up(decode((step as f64 + 0.5) / 255.0));
        step += 1;
    }
    borders
};

/// The light that a value of the encoding stands for.
const fn decode(value: f64) -> f64 {
    if value <= 0.040_45 {
        return value / 12.92;
    }
    let base = (value + 0.055) / 1.055;
    let square = base * base;
    // base^2.4 = square * square^(1/5). Newton's steps come down from 1 to the fifth root; after ten of
    // them it changes by roundings alone.
    let (mut root, mut steps) = (1.0, 0);
    while steps < 20 {
        root = 0.8 * root + 0.2 * square / (root * root * root * root);
        steps += 1;
    }
    square * root
}

/// The least number in single precision that is not below `x`.
const fn rounded_up(x: f64) -> f32 {
    let near = x as f32;
    if (near as f64) < x { near.next_up() } else { near }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The encoding of the standard in steps of 1/255, not rounded.
    fn steps(v: f64) -> f64 {
        let encoded = if v > 0.003_130_8 { 1.055 * libm::pow(v, 1.0 / 2.4) - 0.055 } else { 12.92 * v };
        encoded * 255.0
    }

    #[test]
    fn each_border_is_the_least_number_that_the_standard_rounds_to_its_step() {
        // So far from half a step that roundings of doubles cannot have decided.
        const SURE: f64 = 1e-11;
        for (border, step) in BORDERS.iter().zip(1..=u8::MAX) {
            let half = f64::from(step) - 0.5;
            let (at, below) = (steps(f64::from(*border)), steps(f64::from(border.next_down())));
            assert!(at >= half + SURE && below <= half - SURE, "{step}: {border}, {at}, {below}");
            assert_eq!(encode8(*border as Real), step);
            assert_eq!(encode8(border.next_down() as Real), step - 1);
        }
    }

    #[test]
    fn light_is_encoded_as_by_the_formula_but_for_what_its_roundings_take_past_a_border() {
        let (mut all, mut apart) = (0, 0);
        // All exponents and, by a prime stride, all patterns of the last bits.
        for bits in (0..=1.25_f32.to_bits()).step_by(499) {
            let v = f32::from_bits(bits);
            let (step, formula) = (encode8(v as Real), (encode(v as Real) * 255.0 + 0.5) as u8);
            all += 1;
            if step != formula {
                apart += 1;
                let past = (steps(f64::from(v)) - f64::from(step.max(formula)) + 0.5).abs();
                assert!(step.abs_diff(formula) == 1 && past <= 1e-4, "{v}: {step}, {formula}, {past}");
            }
        }
        assert!(all > 2_000_000 && apart < 10, "{apart} of {all}");
    }

    #[test]
    fn what_is_no_light_is_black_and_too_much_is_white() {
        assert_eq!([Real::NAN, Real::NEG_INFINITY, -1.0, -0.0, 0.0, 1e-9].map(encode8), [0; 6]);
        assert_eq!([1.0, 1.0 + Real::EPSILON, 7.0, Real::MAX, Real::INFINITY].map(encode8), [255; 5]);
    }
}
