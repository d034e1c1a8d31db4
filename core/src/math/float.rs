//! Roots, powers and angles: the only room that names libm.
//!
//! libm is the same code on every target, where the platform's own functions differ in the
//! last bits. The square root alone may come from hardware: IEEE 754 demands the correctly
//! rounded one, so that any right implementation gives the same bits.

use super::Real;

#[cfg(feature = "double")]
mod library {
    #[cfg(test)]
    pub(super) use libm::{acos, cos, sin};
    pub(super) use libm::{exp, floor, pow, sqrt, tan};
}
#[cfg(not(feature = "double"))]
mod library {
    #[cfg(test)]
    pub(super) use libm::{acosf as acos, cosf as cos, sinf as sin};
    pub(super) use libm::{expf as exp, floorf as floor, powf as pow, sqrtf as sqrt, tanf as tan};
}

/// The square root, correctly rounded; NaN for what is below zero.
#[inline(always)]
pub fn sqrt(x: Real) -> Real {
    library::sqrt(x)
}

/// `x` to the power `y`.
pub fn powf(x: Real, y: Real) -> Real {
    library::pow(x, y)
}

/// `e` to the power `x`.
pub fn exp(x: Real) -> Real {
    library::exp(x)
}

/// The sine of an angle in radians.
#[cfg(test)]
pub fn sin(x: Real) -> Real {
    library::sin(x)
}

/// The cosine of an angle in radians.
#[cfg(test)]
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
