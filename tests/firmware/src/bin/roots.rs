//! Compares the floating-point unit's square root with libm's, bit for bit: for every exponent, with each
//! single bit of the mantissa, its extremes, and a dense sample between them; for both zeros, the infinities,
//! NaN and negative numbers.
//!
//! Prints the number of compared roots. The exit code is 0, or 1 after the first root that differs.

#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::{println, process};
use strahl_core::math::sqrt;

/// Mantissas between the ends: an odd step, so that low bits take every pattern.
const STEP: usize = 4_093;
const MANTISSA: u32 = 1 << 23;
const EXPONENTS: u32 = 1 << 8;

/// Whether both roots are equal. All NaN are equal, because their bits depend on the target.
fn is_equal(x: f32) -> bool {
    let (ours, library) = (sqrt(x), libm::sqrtf(x));
    ours.to_bits() == library.to_bits() || (ours.is_nan() && library.is_nan())
}

#[entry]
fn main() -> ! {
    let mut compared = 0_u32;
    for sign_and_exponent in 0..2 * EXPONENTS {
        let alone = (0..23).map(|bit| 1 << bit);
        let ends = [0, MANTISSA - 1, MANTISSA - 2];
        let dense = (0..MANTISSA).step_by(STEP);
        for mantissa in alone.chain(ends).chain(dense) {
            let x = f32::from_bits(sign_and_exponent * MANTISSA + mantissa);
            if !is_equal(x) {
                println!("roots: of {:#010x}: {:?}, libm {:?}", x.to_bits(), sqrt(x), libm::sqrtf(x));
                process::exit(1);
            }
            compared += 1;
        }
    }
    // Squares of 12-bit numbers and their neighbors: exact and almost exact roots.
    for n in 1..4096_u32 {
        let square = ((n * n) as f32).to_bits();
        for bits in [square - 1, square, square + 1] {
            if !is_equal(f32::from_bits(bits)) {
                println!("roots: of {bits:#010x}, next to {n} squared");
                process::exit(1);
            }
            compared += 1;
        }
    }
    println!("roots {compared}");
    process::exit(0)
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("roots: {info}");
    process::exit(1)
}
