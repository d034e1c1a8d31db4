//! Scalars, vectors, colors and elementary functions.
//!
//! The scalar is [`Real`]: `f32` in `strahl-core`, `f64` in `strahl-core-double`, which compiles the same
//! sources. Vectors are those of glam that use no SIMD instructions, so every target performs the same
//! operations in the same order.
//!
//! This module computes lengths and unit vectors itself, not by methods of glam, so that [`sqrt`] is the
//! only square root.

mod color;
#[cfg(not(feature = "double"))]
mod decimal;
mod float;
pub(crate) mod morton;
mod real4;
mod roots;
mod sobol;
mod srgb;
mod warp;

pub use color::Rgb;
#[cfg(not(feature = "double"))]
pub(crate) use decimal::Decimal;
#[cfg(test)]
pub(crate) use float::acos;
pub use float::sqrt;
pub(crate) use float::{cos, exp, floor, ln, pow_positive, powf, sin, tan};
pub(crate) use real4::{Real4, SIMD_WIDTH};
pub use roots::{CubicRoots, bracketed_root, cubic_roots};
pub use sobol::{Dimension, SobolSequence};
pub(crate) use warp::{
    orthonormal_basis, sample_disc_concentric, sample_tent, sample_truncated_gaussian, sample_visible_normal,
};

#[cfg(feature = "double")]
mod precision {
    pub use core::f64::consts;
    pub use glam::DVec3 as Vec3;

    /// The scalar: double precision.
    pub type Real = f64;

    /// The integer as wide as a [`Real`]. Bits of non-negative [`Real`]s, read as this type, have the
    /// order of the numbers.
    pub type OrderedBits = i64;
}
#[cfg(not(feature = "double"))]
mod precision {
    pub use core::f32::consts;
    pub use glam::Vec3;

    /// The scalar: single precision.
    pub type Real = f32;

    /// The integer as wide as a [`Real`]. Bits of non-negative [`Real`]s, read as this type, have the
    /// order of the numbers.
    pub type OrderedBits = i32;
}
pub(crate) use precision::OrderedBits;
pub use precision::{Real, Vec3};

/// The ratio of a circle's circumference to its diameter.
pub const PI: Real = precision::consts::PI;

/// The unit roundoff: the largest relative error of one rounded operation, half of `EPSILON`.
pub const ROUNDOFF: Real = Real::EPSILON / 2.0;

/// Largest absolute coordinate in a scene, in scene lengths. Its square is far inside the range of `f32`.
pub const MAX_COORDINATE: Real = 1e15;

/// Bound on the relative error of `n` rounded operations in sequence.
///
/// Source: Higham, "Accuracy and Stability of Numerical Algorithms", 2nd edition, 2002, 3.1.
pub const fn gamma(n: u32) -> Real {
    let nu = n as Real * ROUNDOFF;
    nu / (1.0 - nu)
}

/// A vector with the given components.
pub const fn vec3(x: Real, y: Real, z: Real) -> Vec3 {
    Vec3::new(x, y, z)
}

/// The larger of `a` and `b`; `b` if they are equal or one is NaN.
pub(crate) fn max(a: Real, b: Real) -> Real {
    if a > b { a } else { b }
}

/// The smaller of `a` and `b`; `b` if they are equal or one is NaN.
pub(crate) fn min(a: Real, b: Real) -> Real {
    if a < b { a } else { b }
}

/// `x` limited to `low..=high`; `low` if `x` is NaN.
pub(crate) fn clamp(x: Real, low: Real, high: Real) -> Real {
    if x > low { if x < high { x } else { high } } else { low }
}

/// The largest power of two that is at most `|x|`.
///
/// It is the smallest positive normal number for zero and for subnormal `x`.
pub(crate) fn floor_power_of_two(x: Real) -> Real {
    // The bits of infinity are a mask of the exponent's bits.
    let power = Real::from_bits(x.to_bits() & Real::INFINITY.to_bits());
    max(power, Real::MIN_POSITIVE)
}

/// The vector of absolute components.
pub(crate) fn abs(v: Vec3) -> Vec3 {
    vec3(v.x.abs(), v.y.abs(), v.z.abs())
}

/// The largest absolute component.
pub(crate) fn max_abs_component(v: Vec3) -> Real {
    max(v.x.abs(), max(v.y.abs(), v.z.abs()))
}

/// Whether the absolute value of every component is at most [`MAX_COORDINATE`]. False for NaN.
#[inline(never)] // validation calls it often: code size matters there, time does not
pub(crate) fn is_in_range(v: Vec3) -> bool {
    v.x.abs() <= MAX_COORDINATE && v.y.abs() <= MAX_COORDINATE && v.z.abs() <= MAX_COORDINATE
}

/// The length of `v`, if its square is in range (lengths of about 1e-19 to 1e19 in `f32`).
pub(crate) fn length(v: Vec3) -> Real {
    sqrt(v.dot(v))
}

/// The unit vector in the direction of `v`; `None` if `v` is zero or not finite.
///
/// The result for `v` times a power of two is the same, bit for bit.
#[inline(always)]
pub fn try_normalize(v: Vec3) -> Option<Vec3> {
    try_normalize_and_length(v).map(|(unit, _)| unit)
}

/// The unit vector in the direction of `v`, and the length of `v`; `None` if `v` is zero or not finite.
#[inline(always)]
pub(crate) fn try_normalize_and_length(v: Vec3) -> Option<(Vec3, Real)> {
    let square = v.dot(v);
    if is_safe_square(square) {
        let length = sqrt(square);
        return Some((v / length, length));
    }
    normalize_extreme(v.x, v.y, v.z)
}

/// Whether `square`, the squared length of a vector, is so far from underflow and overflow that the
/// squares of the components are in range, too.
///
/// Positive floating-point numbers are ordered as their bits, so one comparison tests both bounds. Zero,
/// negative numbers and NaN are outside of them.
#[inline(always)]
fn is_safe_square(square: Real) -> bool {
    // 2^-66 and 2^115: their bits in single precision are immediate operands on many processors.
    const MIN: Real = 1.355_252_715_606_880_5e-20;
    const MAX: Real = 4.153_837_486_827_862e34;
    square.to_bits().wrapping_sub(MIN.to_bits()) <= MAX.to_bits() - MIN.to_bits()
}

/// [`try_normalize_and_length`] for vectors whose squared length is not safe: an exact power of two scales
/// the largest component to about one.
///
/// The components are separate parameters so that they are passed in registers.
#[cold]
#[inline(never)]
fn normalize_extreme(x: Real, y: Real, z: Real) -> Option<(Vec3, Real)> {
    let v = vec3(x, y, z);
    let scale = floor_power_of_two(max_abs_component(v));
    let v = v / scale;
    let square = v.dot(v);
    if !is_safe_square(square) {
        return None;
    }
    let length = sqrt(square);
    Some((v / length, length * scale))
}

/// Whether `v` is a unit vector: its squared length differs from 1 by at most 1e-5.
#[inline(never)] // as `is_in_range`
pub(crate) fn is_normalized(v: Vec3) -> bool {
    (v.dot(v) - 1.0).abs() <= 1e-5
}

/// `a * b - c * d` to within a few ulps of the result, also if the rounded products cancel.
///
/// The errors of both products are computed with Dekker's splitting, which needs neither a fused
/// operation nor a wider type.
pub fn difference_of_products(a: Real, b: Real, c: Real, d: Real) -> Real {
    let (p, q) = (a * b, c * d);
    (p - q) + (product_error(a, b, p) - product_error(c, d, q))
}

/// `a * b - p`, exactly, where `p` is the rounded product.
///
/// Source: Dekker, "A Floating-Point Technique for Extending the Available Precision", Numerische
/// Mathematik 1971.
fn product_error(a: Real, b: Real, p: Real) -> Real {
    const SPLIT: Real = (1_u32 << Real::MANTISSA_DIGITS.div_ceil(2)) as Real + 1.0;
    let split = |x: Real| {
        let big = SPLIT * x;
        let high = big - (big - x);
        (high, x - high)
    };
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2
}

/// `(a - b) - d`, exactly, where `d` is the rounded difference.
///
/// Source: TwoSum in Knuth, "The Art of Computer Programming", volume 2, 4.2.2.
pub(crate) fn difference_error(a: Vec3, b: Vec3, d: Vec3) -> Vec3 {
    let negative_b = d - a;
    (a - (d - negative_b)) - (b + negative_b)
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The x axis.
    X,
    /// The y axis.
    Y,
    /// The z axis.
    Z,
}

impl Axis {
    /// The axis of the largest absolute component of `v`; the last one of several equal ones.
    pub fn dominant(v: Vec3) -> Self {
        let a = abs(v);
        if a.x > a.y && a.x > a.z {
            Axis::X
        } else if a.y > a.z {
            Axis::Y
        } else {
            Axis::Z
        }
    }

    /// `v` with its components permuted cyclically so that the one of this axis becomes `z`.
    pub fn permute_to_z(self, v: Vec3) -> Vec3 {
        match self {
            Axis::X => vec3(v.y, v.z, v.x),
            Axis::Y => vec3(v.z, v.x, v.y),
            Axis::Z => v,
        }
    }

    /// The inverse of [`Axis::permute_to_z`].
    pub(crate) fn permute_from_z(self, v: Vec3) -> Vec3 {
        match self {
            Axis::X => vec3(v.z, v.x, v.y),
            Axis::Y => vec3(v.y, v.z, v.x),
            Axis::Z => v,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_vector_does_not_depend_on_the_length_of_its_source() {
        let v = vec3(1.0, -2.5, 0.3);
        let n = try_normalize(v).unwrap();
        assert!((length(n) - 1.0).abs() <= 2.0 * Real::EPSILON);
        for k in [-100, -20, -1, 1, 20, 100] {
            let scale = if k < 0 { 1.0 / pow2(-k) } else { pow2(k) };
            assert_eq!(try_normalize(v * scale), Some(n), "2^{k}");
        }
        assert_eq!(try_normalize(Vec3::ZERO), None);
        assert_eq!(try_normalize(vec3(Real::NAN, 1.0, 0.0)), None);
        assert_eq!(try_normalize(vec3(Real::INFINITY, 1.0, 0.0)), None);
    }

    fn pow2(k: i32) -> Real {
        (0..k).fold(1.0, |x, _| x * 2.0)
    }

    #[test]
    fn a_difference_of_nearly_equal_products_keeps_its_sign() {
        let e = Real::EPSILON;
        // (1 + e)(1 - e) - 1 = -e^2, but the rounded product is 1.
        let (a, b): (Real, Real) = (1.0 + e, 1.0 - e);
        assert_eq!(a * b - 1.0, 0.0);
        assert_eq!(difference_of_products(a, b, 1.0, 1.0), -e * e);
        assert_eq!(difference_of_products(3.0, 5.0, 5.0, 3.0), 0.0);
    }
}
