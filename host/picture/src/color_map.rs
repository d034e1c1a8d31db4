//! Color map of difference maps.

use std::array;

/// The position on the map of the smallest 8-bit difference, 1/255.
const FIRST: f64 = 0.2;

/// Inferno, a perceptually uniform map: black, violet, red, orange, pale yellow. It is also readable with a color vision
/// deficiency, and in gray.
///
/// Source: Nathaniel Smith and Stéfan van der Walt (matplotlib, 2015); the table is from the crate `colorous`.
pub fn inferno() -> [[u8; 3]; 256] {
    array::from_fn(|step| colorous::INFERNO.eval_rational(step, 256).as_array())
}

/// The index on a map of 256 colors of a difference of encoded values, in `[0, 1]`.
///
/// The scale is linear up to 1/255, the smallest 8-bit difference, at a fifth of the map, and logarithmic from there to 1.
/// It is the same for all pictures, so that two difference maps can be compared.
pub fn step_of(difference: f64) -> u8 {
    let steps = difference * 255.0;
    let place = if steps <= 1.0 {
        FIRST * steps
    } else {
        FIRST + (1.0 - FIRST) * libm::log2(steps) / libm::log2(255.0)
    };
    // Saturates; NaN becomes 0.
    let step = (place * 255.0 + 0.5) as u8;
    // Only zero is black.
    if difference > 0.0 && step == 0 { 1 } else { step }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inferno_ranges_from_black_to_pale_yellow() {
        let map = inferno();
        assert_eq!((map[0], map[255]), ([0, 0, 4], [252, 255, 164]));
    }

    #[test]
    fn inferno_grows_brighter_with_every_step() {
        let luma = |[r, g, b]: [u8; 3]| 2126 * u32::from(r) + 7152 * u32::from(g) + 722 * u32::from(b);
        // Two steps, because the table is rounded to eight bits.
        assert!(inferno().windows(3).all(|three| luma(three[0]) < luma(three[2])));
    }

    #[test]
    fn only_zero_is_black_and_the_largest_difference_is_the_brightest() {
        assert_eq!([0.0, 1e-12, 1.0, 2.0].map(step_of), [0, 1, 255, 255]);
        assert!(step_of(250.0 / 255.0) < 255);
    }

    #[test]
    fn every_doubling_adds_the_same_number_of_steps() {
        // A fifth of 255, and 204 / log2(255) = 25.5 for each doubling.
        let doublings = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0];
        assert_eq!(doublings.map(|d| step_of(d / 255.0)), [51, 77, 102, 128, 153, 179, 204, 230]);
    }
}
