//! Roots, powers and angles: the only room that names libm.
//!
//! libm is the same code on every target, where the platform's own functions differ in the
//! last bits. The square root alone may come from hardware: IEEE 754 demands the correctly
//! rounded one, so that any right implementation gives the same bits.

use super::Real;

#[cfg(feature = "double")]
mod library {
    #[cfg(test)]
    pub(super) use libm::acos;
    pub(super) use libm::{cos, exp, floor, log as ln, pow, sin};
}
#[cfg(not(feature = "double"))]
mod library {
    #[cfg(test)]
    pub(super) use libm::acosf as acos;
    pub(super) use libm::{cosf as cos, expf as exp, floorf as floor, logf as ln, powf as pow, sinf as sin};
}

/// The square root where the floating-point unit has one, but libm's is software: some sixty
/// instructions in place of one. (On x86-64, AArch64 and wasm32 libm's is the hardware's.)
#[cfg(all(target_arch = "arm", target_abi = "eabihf", not(feature = "double")))]
mod root {
    /// Its bits are libm's: `tests/firmware/src/bin/roots.rs`.
    #[inline(always)]
    #[allow(unsafe_code)] // without std there is no other way to this instruction
    pub fn sqrt(x: f32) -> f32 {
        let mut bits = x.to_bits();
        // Through an integer register, because stable Rust lends `asm!` no float registers on
        // targets that name their unit by a version it does not know.
        // SAFETY: every Arm target that hands over floats in registers (eabihf) has the
        // instruction, and nothing is read or written but the registers named here.
        unsafe {
            core::arch::asm!(
                "vmov s15, {bits}",
                "vsqrt.f32 s15, s15",
                "vmov {bits}, s15",
                bits = inlateout(reg) bits,
                out("s15") _,
                options(pure, nomem, nostack, preserves_flags),
            );
        }
        f32::from_bits(bits)
    }
}
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf", not(feature = "double"))))]
mod root {
    #[cfg(feature = "double")]
    pub use libm::sqrt;
    #[cfg(not(feature = "double"))]
    pub use libm::sqrtf as sqrt;
}

/// The square root, correctly rounded; NaN for what is below zero.
#[inline(always)]
pub fn sqrt(x: Real) -> Real {
    root::sqrt(x)
}

/// `x` to the power `y`.
pub fn powf(x: Real, y: Real) -> Real {
    library::pow(x, y)
}

/// `x`, more than zero, to the power `y`, more than zero: right to `y` roundoffs, which is less than
/// an `x` that is off by one roundoff itself makes of it.
///
/// By squares where `y` is a whole number, as the exponents of highlights nearly always are.
pub fn power(x: Real, y: Real) -> Real {
    let mut left = y as u16;
    if Real::from(left) != y {
        return powf(x, y);
    }
    let (mut power, mut square) = (1.0, x);
    loop {
        if left % 2 == 1 {
            power *= square;
        }
        left /= 2;
        if left == 0 {
            return power;
        }
        square *= square;
    }
}

/// `e` to the power `x`.
pub fn exp(x: Real) -> Real {
    library::exp(x)
}

/// The natural logarithm of `x`.
pub fn ln(x: Real) -> Real {
    library::ln(x)
}

/// The sine of an angle in radians.
pub fn sin(x: Real) -> Real {
    library::sin(x)
}

/// The cosine of an angle in radians.
pub fn cos(x: Real) -> Real {
    library::cos(x)
}

/// The tangent of an acute angle in radians, in `(0, pi / 2)`, right to a few roundoffs.
///
/// Lambert's continued fraction (1768), `x / (1 - x^2 / (3 - x^2 / (5 - ...)))`, up to half a right
/// angle, and beyond that one over the tangent of what is left of it. libm's goes by way of double
/// precision, and a device that has none would carry 9 KB of it in flash for one number.
pub fn tan(x: Real) -> Real {
    use super::precision::consts::{FRAC_PI_2, FRAC_PI_4};
    // What FRAC_PI_2 lacks, and how many fractions are left of less than a quarter of a roundoff.
    const REST: Real = if Real::MANTISSA_DIGITS > 24 { 6.123_233_995_736_766e-17 } else { -4.371_139e-8 };
    const FRACTIONS: u8 = if Real::MANTISSA_DIGITS > 24 { 10 } else { 6 };

    let is_small = x <= FRAC_PI_4;
    let y = if is_small { x } else { (FRAC_PI_2 - x) + REST };
    let odd = |n: u8| Real::from(2 * n + 1);
    let divisor = (0..FRACTIONS).rev().fold(odd(FRACTIONS), |divisor, n| odd(n) - y * y / divisor);
    if is_small { y / divisor } else { divisor / y }
}

/// The angle in radians, in `[0, pi]`, whose cosine is `x`; NaN outside `[-1, 1]`.
#[cfg(test)]
pub fn acos(x: Real) -> Real {
    library::acos(x)
}

/// The largest whole number that is not above `x`.
#[inline]
pub fn floor(x: Real) -> Real {
    // Nearly every number fits a machine's whole number, and the way there is short.
    if x.abs() < 1e9 {
        let whole = x as i32 as Real;
        if whole > x { whole - 1.0 } else { whole }
    } else {
        library::floor(x)
    }
}

#[cfg(test)]
#[allow(clippy::useless_conversion)] // it is none in single precision
mod tests {
    use super::*;
    use crate::math::PI;

    #[test]
    fn the_tangent_of_an_acute_angle_is_the_librarys() {
        for i in 1..20_000_u16 {
            let x = 0.5 * PI * (Real::from(i) / 20_000.0);
            let exact = libm::tan(f64::from(x));
            let error = (f64::from(tan(x)) / exact - 1.0).abs();
            // What comes near to a right angle is told apart from it by a roundoff of its own.
            assert!(error <= 4.0 * f64::from(Real::EPSILON), "{x}: off by {error}");
        }
    }

    #[test]
    fn a_power_by_squares_is_the_librarys() {
        for y in [1.0, 2.0, 3.0, 10.0, 50.0, 125.0, 1425.0, 65_535.0, 0.5, 12.25] {
            for i in 1..200_u16 {
                let x = 1.0 - Real::from(i) / (200.0 * (y + 1.0));
                let (power, exact) = (f64::from(power(x, y)), libm::pow(f64::from(x), f64::from(y)));
                assert!((power / exact - 1.0).abs() <= f64::from((y + 1.0) * Real::EPSILON), "{x}^{y}");
            }
        }
    }
}
