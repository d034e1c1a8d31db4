//! Differences to colours.

use std::array;

/// How bright the smallest difference of eight bits is, of the whole map.
const FIRST: f64 = 0.2;

/// Inferno, a perceptually uniform map: black, violet, red, orange, pale yellow. It is as clear
/// to people who do not see all colours, and in grey.
///
/// The table is that of Nathaniel Smith and Stéfan van der Walt (matplotlib, 2015), from the
/// crate `colorous`.
pub fn inferno() -> [[u8; 3]; 256] {
    array::from_fn(|step| colorous::INFERNO.eval_rational(step, 256).as_array())
}

/// The place of a difference of encoded values, 0 to 1, on a map of 256 steps.
///
/// 1/255, the smallest difference of eight bits, is a fifth of the way; from there every doubling
/// is as much brighter as the one before, up to 1. So every difference can be seen, and two maps
/// can be laid side by side: a colour means the same in both.
pub fn step_of(difference: f64) -> u8 {
    let steps = difference * 255.0;
    let place = if steps <= 1.0 {
        FIRST * steps
    } else {
        FIRST + (1.0 - FIRST) * libm::log2(steps) / libm::log2(255.0)
    };
    // Saturates, and what is not a number is 0.
    let step = (place * 255.0 + 0.5) as u8;
    // Only no difference is black.
    if difference > 0.0 && step == 0 { 1 } else { step }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inferno_goes_from_black_to_pale_yellow() {
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
    fn only_no_difference_is_black_and_the_largest_is_the_brightest() {
        assert_eq!([0.0, 1e-12, 1.0, 2.0].map(step_of), [0, 1, 255, 255]);
        assert!(step_of(250.0 / 255.0) < 255);
    }

    #[test]
    fn every_doubling_is_as_much_brighter_as_the_one_before() {
        // A fifth of 255, and 204 / log2(255) = 25.5 for each doubling.
        let doublings = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0];
        assert_eq!(doublings.map(|d| step_of(d / 255.0)), [51, 77, 102, 128, 153, 179, 204, 230]);
    }
}
