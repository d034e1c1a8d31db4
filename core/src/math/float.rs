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
    pub(super) use libm::{cos, exp, floor, log as ln, pow, sin, tan};
}
#[cfg(not(feature = "double"))]
mod library {
    #[cfg(test)]
    pub(super) use libm::acosf as acos;
    pub(super) use libm::{
        cosf as cos, expf as exp, floorf as floor, logf as ln, powf as pow, sinf as sin, tanf as tan,
    };
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

/// The tangent of an angle in radians.
pub fn tan(x: Real) -> Real {
    library::tan(x)
}

/// The angle in radians, in `[0, pi]`, whose cosine is `x`; NaN outside `[-1, 1]`.
#[cfg(test)]
pub fn acos(x: Real) -> Real {
    library::acos(x)
}

/// The largest whole number that is not above `x`.
pub fn floor(x: Real) -> Real {
    library::floor(x)
}
