//! Elementary functions: square root, powers and trigonometry. The only module that uses `libm`.
//!
//! `libm` is the same code on every target; the functions of the platforms differ in the last bits.
//! Only the square root may come from hardware: IEEE 754 requires it to be correctly rounded, so every
//! implementation returns the same bits.

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

/// The square root instruction of Arm's floating-point unit, for which `libm` has about sixty
/// instructions of software. On x86-64, AArch64 and wasm32 `libm` uses the hardware.
#[cfg(all(target_arch = "arm", target_abi = "eabihf", not(feature = "double")))]
mod square_root {
    /// `tests/firmware/src/bin/roots.rs` compares its bits with those of `libm`.
    #[inline(always)]
    #[allow(unsafe_code)] // without std, inline assembly is the only access to the instruction
    pub fn sqrt(x: f32) -> f32 {
        let mut bits = x.to_bits();
        // The value passes through an integer register: stable Rust offers `asm!` no float registers on
        // targets whose floating-point version it does not know.
        // SAFETY: every Arm target that passes floats in registers (eabihf) has the instruction, and
        // only the registers named here are read or written.
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
mod square_root {
    #[cfg(feature = "double")]
    pub use libm::sqrt;
    #[cfg(not(feature = "double"))]
    pub use libm::sqrtf as sqrt;
}

/// The correctly rounded square root of `x`; NaN if `x` is negative.
#[inline(always)]
pub fn sqrt(x: Real) -> Real {
    square_root::sqrt(x)
}

/// `x` to the power `y`.
pub fn powf(x: Real, y: Real) -> Real {
    library::pow(x, y)
}

/// `x` to the power `y`, for positive `x` and `y`.
///
/// Its relative error is at most about `y` unit roundoffs, the error that one roundoff in `x` causes.
/// Integer exponents below 65,536 are computed by repeated squaring; exponents of highlights nearly
/// always are such integers.
pub fn pow_positive(x: Real, y: Real) -> Real {
    let mut exponent = y as u16;
    if Real::from(exponent) != y {
        return powf(x, y);
    }
    let (mut power, mut square) = (1.0, x);
    loop {
        if exponent % 2 == 1 {
            power *= square;
        }
        exponent /= 2;
        if exponent == 0 {
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

/// The sine of `x`, in radians.
pub fn sin(x: Real) -> Real {
    library::sin(x)
}

/// The cosine of `x`, in radians.
pub fn cos(x: Real) -> Real {
    library::cos(x)
}

/// The tangent of `x`, in radians, in `(0, pi / 2)`. Its relative error is at most 4 epsilon.
///
/// Lambert's continued fraction (1768), `x / (1 - x^2 / (3 - x^2 / (5 - ...)))`, up to `pi / 4`; above
/// that the reciprocal of the tangent of `pi / 2 - x`. `libm` computes it in double precision, which
/// takes 9 KB of flash on a device without a double-precision unit.
pub fn tan(x: Real) -> Real {
    use super::precision::consts::{FRAC_PI_2, FRAC_PI_4};
    // pi / 2 minus its rounded value.
    const FRAC_PI_2_REMAINDER: Real =
        if Real::MANTISSA_DIGITS > 24 { 6.123_233_995_736_766e-17 } else { -4.371_139e-8 };
    // The omitted terms are less than a quarter of a unit roundoff.
    const TERMS: u8 = if Real::MANTISSA_DIGITS > 24 { 10 } else { 6 };

    let is_small = x <= FRAC_PI_4;
    let y = if is_small { x } else { (FRAC_PI_2 - x) + FRAC_PI_2_REMAINDER };
    let odd = |n: u8| Real::from(2 * n + 1);
    let divisor = (0..TERMS).rev().fold(odd(TERMS), |divisor, n| odd(n) - y * y / divisor);
    if is_small { y / divisor } else { divisor / y }
}

/// The arc cosine of `x`, in radians, in `[0, pi]`; NaN if `x` is outside `[-1, 1]`.
#[cfg(test)]
pub fn acos(x: Real) -> Real {
    library::acos(x)
}

/// The largest integer that is at most `x`.
#[inline]
pub fn floor(x: Real) -> Real {
    // The common case converts to an integer and back, which is faster than `libm`.
    if x.abs() < 1e9 {
        let truncated = x as i32 as Real;
        if truncated > x { truncated - 1.0 } else { truncated }
    } else {
        library::floor(x)
    }
}

#[cfg(test)]
#[allow(clippy::useless_conversion)] // `f64::from` converts in single precision
mod tests {
    use super::*;
    use crate::math::PI;

    #[test]
    fn the_tangent_of_an_acute_angle_agrees_with_libm() {
        for i in 1..20_000_u16 {
            let x = 0.5 * PI * (Real::from(i) / 20_000.0);
            let exact = libm::tan(f64::from(x));
            let error = (f64::from(tan(x)) / exact - 1.0).abs();
            // Near pi / 2 this bound holds only thanks to FRAC_PI_2_REMAINDER.
            assert!(error <= 4.0 * f64::from(Real::EPSILON), "{x}: off by {error}");
        }
    }

    #[test]
    fn a_power_by_squaring_agrees_with_libm() {
        for y in [1.0, 2.0, 3.0, 10.0, 50.0, 125.0, 1425.0, 65_535.0, 0.5, 12.25] {
            for i in 1..200_u16 {
                let x = 1.0 - Real::from(i) / (200.0 * (y + 1.0));
                let (power, exact) = (f64::from(pow_positive(x, y)), libm::pow(f64::from(x), f64::from(y)));
                assert!((power / exact - 1.0).abs() <= f64::from((y + 1.0) * Real::EPSILON), "{x}^{y}");
            }
        }
    }
}
