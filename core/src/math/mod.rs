//! Numbers and vectors: what the rest of the house counts with.
//!
//! The scalar is [`Real`]: `f32` in `strahl-core`, `f64` in its twin `strahl-core-double`,
//! which compiles the same sources. Vectors are glam's plain ones, which are scalar on every
//! target, so that every target does the same operations in the same order.
//!
//! Lengths and units are taken here and not by glam's own methods, so that [`sqrt`] is the
//! only way to a root.

mod color;
mod float;
mod lanes;
pub mod morton;
mod roots;
mod srgb;
mod stream;
mod warp;

pub use color::Rgb;
#[cfg(test)]
pub use float::acos;
pub use float::{cos, exp, floor, ln, power, powf, sin, sqrt, tan};
pub use lanes::{LANES, Lanes};
pub use roots::{CubicRoots, cubic_roots, root_between};
pub use stream::{Dimension, Stream};
pub use warp::{across, disc, facet, normal, tent};

#[cfg(feature = "double")]
mod precision {
    pub use core::f64::consts;
    pub use glam::DVec3 as Vec3;

    /// The scalar: double precision.
    pub type Real = f64;

    /// A whole number with the bits of a [`Real`].
    pub type Ordered = i64;
}
#[cfg(not(feature = "double"))]
mod precision {
    pub use core::f32::consts;
    pub use glam::Vec3;

    /// The scalar: single precision.
    pub type Real = f32;

    /// A whole number with the bits of a [`Real`].
    pub type Ordered = i32;
}
pub use precision::{Ordered, Real, Vec3};

/// Half a turn, in radians.
pub const PI: Real = precision::consts::PI;

/// The unit roundoff: the largest relative error of one rounded operation.
pub const ROUNDOFF: Real = Real::EPSILON / 2.0;

/// The largest |coordinate| that a scene may hold, in scene lengths: its square stays far
/// inside the range of `f32`.
pub const FARTHEST: Real = 1e15;

/// A bound on the relative error of `n` rounded operations in a row (Higham's gamma).
pub const fn gamma(n: u32) -> Real {
    let nu = n as Real * ROUNDOFF;
    nu / (1.0 - nu)
}

/// A vector from its components.
pub const fn vec3(x: Real, y: Real, z: Real) -> Vec3 {
    Vec3::new(x, y, z)
}

/// The larger of two; the second when they are equal or one is no number.
pub fn greatest(a: Real, b: Real) -> Real {
    if a > b { a } else { b }
}

/// The smaller of two; the second when they are equal or one is no number.
pub fn least(a: Real, b: Real) -> Real {
    if a < b { a } else { b }
}

/// `x`, or the nearer end of `low..=high` when it lies outside; `low` when it is no number.
pub fn within(x: Real, low: Real, high: Real) -> Real {
    if x > low { if x < high { x } else { high } } else { low }
}

/// The power of two that is as large as `x` or next below it, whatever its sign; for zero and
/// for what is too small for a normal number, the smallest normal one.
pub fn power_of_two(x: Real) -> Real {
    // Of the bits of an infinite number only those of the exponent are set.
    let power = Real::from_bits(x.to_bits() & Real::INFINITY.to_bits());
    greatest(power, Real::MIN_POSITIVE)
}

/// The absolute value of every component.
pub fn abs(v: Vec3) -> Vec3 {
    vec3(v.x.abs(), v.y.abs(), v.z.abs())
}

/// The largest absolute component.
pub fn largest(v: Vec3) -> Real {
    greatest(v.x.abs(), greatest(v.y.abs(), v.z.abs()))
}

/// Whether every component is finite and at most [`FARTHEST`] away from zero.
#[inline(never)] // doors ask it in many places, where its size counts and not its time
pub fn is_in_range(v: Vec3) -> bool {
    v.x.abs() <= FARTHEST && v.y.abs() <= FARTHEST && v.z.abs() <= FARTHEST
}

/// The length of `v`, for lengths whose squares are in range (about 1e-19 to 1e19 in `f32`).
pub fn length(v: Vec3) -> Real {
    sqrt(v.dot(v))
}

/// The vector of length one in the direction of `v`; none for zero and for what is not finite.
///
/// The answer for `v` times a power of two is the same, bit for bit.
#[inline(always)]
pub fn unit(v: Vec3) -> Option<Vec3> {
    unit_and_length(v).map(|(unit, _)| unit)
}

/// The vector of length one in the direction of `v`, and the length of `v`; none for zero and for
/// what is not finite.
#[inline(always)]
pub fn unit_and_length(v: Vec3) -> Option<(Vec3, Real)> {
    let square = v.dot(v);
    if is_handy(square) {
        let length = sqrt(square);
        return Some((v / length, length));
    }
    unit_of_any_size(v.x, v.y, v.z)
}

/// Whether it is the square of a length, neither so small nor so large that squares of components
/// have left the range, or nearly so.
///
/// The bits of a number are ordered as the numbers are, so that one comparison asks for both
/// ends; zero, what is below it and no number lie beyond them.
#[inline(always)]
fn is_handy(square: Real) -> bool {
    // 2^-66 and 2^115: in single precision their bits are immediate operands of many a machine.
    const LEAST: Real = 1.355_252_715_606_880_5e-20;
    const MOST: Real = 4.153_837_486_827_862e34;
    square.to_bits().wrapping_sub(LEAST.to_bits()) <= MOST.to_bits() - LEAST.to_bits()
}

/// [`unit_and_length`] where squares would leave the range: of a vector whose largest component is
/// about one, by an exact factor. (In parts: what is handed over in memory must be put there first.)
#[cold]
#[inline(never)]
fn unit_of_any_size(x: Real, y: Real, z: Real) -> Option<(Vec3, Real)> {
    let v = vec3(x, y, z);
    let scale = power_of_two(largest(v));
    let v = v / scale;
    let square = v.dot(v);
    if !is_handy(square) {
        return None;
    }
    let length = sqrt(square);
    Some((v / length, length * scale))
}

/// Whether `v` has length one, as far as [`unit`] or a rounded constant can tell.
#[inline(never)] // as of `is_in_range`
pub fn is_unit(v: Vec3) -> bool {
    (v.dot(v) - 1.0).abs() <= 1e-5
}

/// `a * b - c * d` with the right sign, and right to a few ulps of itself, also where rounding
/// of the products would leave nothing of it.
///
/// The errors of both products are found with Dekker's splitting, which needs no fused
/// operation and no wider type.
pub fn difference_of_products(a: Real, b: Real, c: Real, d: Real) -> Real {
    let (p, q) = (a * b, c * d);
    (p - q) + (product_error(a, b, p) - product_error(c, d, q))
}

/// `a * b - p`, exactly, where `p` is the rounded product ("A floating-point technique for
/// extending the available precision", Dekker 1971).
fn product_error(a: Real, b: Real, p: Real) -> Real {
    const SPLIT: Real = (1_u32 << Real::MANTISSA_DIGITS.div_ceil(2)) as Real + 1.0;
    let halves = |x: Real| {
        let big = SPLIT * x;
        let high = big - (big - x);
        (high, x - high)
    };
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2
}

/// `(a - b) - d`, exactly, where `d` is the rounded difference (Knuth's two-sum).
pub fn difference_error(a: Vec3, b: Vec3, d: Vec3) -> Vec3 {
    let taken = d - a;
    (a - (d - taken)) - (b + taken)
}

/// One of the three axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

impl Axis {
    /// The axis along which `v` reaches farthest.
    pub fn largest_of(v: Vec3) -> Self {
        let a = abs(v);
        if a.x > a.y && a.x > a.z {
            Axis::X
        } else if a.y > a.z {
            Axis::Y
        } else {
            Axis::Z
        }
    }

    /// `v` with its axes turned in a circle until this one is the third.
    pub fn to_third(self, v: Vec3) -> Vec3 {
        match self {
            Axis::X => vec3(v.y, v.z, v.x),
            Axis::Y => vec3(v.z, v.x, v.y),
            Axis::Z => v,
        }
    }

    /// Undoes [`Axis::to_third`].
    pub(crate) fn place_back(self, v: Vec3) -> Vec3 {
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
    fn a_unit_vector_does_not_depend_on_the_length_it_is_made_from() {
        let v = vec3(1.0, -2.5, 0.3);
        let n = unit(v).unwrap();
        assert!((length(n) - 1.0).abs() <= 2.0 * Real::EPSILON);
        for k in [-100, -20, -1, 1, 20, 100] {
            let scale = if k < 0 { 1.0 / pow2(-k) } else { pow2(k) };
            assert_eq!(unit(v * scale), Some(n), "2^{k}");
        }
        assert_eq!(unit(Vec3::ZERO), None);
        assert_eq!(unit(vec3(Real::NAN, 1.0, 0.0)), None);
        assert_eq!(unit(vec3(Real::INFINITY, 1.0, 0.0)), None);
    }

    fn pow2(k: i32) -> Real {
        (0..k).fold(1.0, |x, _| x * 2.0)
    }

    #[test]
    fn a_difference_of_nearly_equal_products_keeps_its_sign() {
        let e = Real::EPSILON;
        // (1 + e)(1 - e) - 1 = -e^2: a rounded product says zero.
        let (a, b): (Real, Real) = (1.0 + e, 1.0 - e);
        assert_eq!(a * b - 1.0, 0.0);
        assert_eq!(difference_of_products(a, b, 1.0, 1.0), -e * e);
        assert_eq!(difference_of_products(3.0, 5.0, 5.0, 3.0), 0.0);
    }
}
