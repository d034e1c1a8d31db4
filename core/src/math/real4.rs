//! A vector of four scalars, for SIMD instructions.
//!
//! It is a plain array: the compiler emits vector instructions where the target has them. Every element
//! goes through the scalar operations in the scalar order, so the bits of the results are the same.

use core::ops::{Add, Mul, Sub};

use super::{Real, max, min};

/// Number of elements of a vector.
pub const SIMD_WIDTH: usize = 4;

/// Four scalars.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(transparent)]
pub struct Real4(pub [Real; SIMD_WIDTH]);

impl Real4 {
    /// A vector with `x` in every element.
    #[inline(always)]
    pub const fn splat(x: Real) -> Self {
        Real4([x; SIMD_WIDTH])
    }

    /// Applies `operation` to each pair of elements.
    #[inline(always)]
    fn zip_with(self, other: Self, operation: impl Fn(Real, Real) -> Real) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        Real4([operation(a, e), operation(b, f), operation(c, g), operation(d, h)])
    }

    /// Element-wise [`max`].
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.zip_with(other, max)
    }

    /// Element-wise [`min`].
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        self.zip_with(other, min)
    }

    /// The mask with a bit for every element.
    pub const FULL_MASK: u32 = 0b1111;

    /// The mask of the elements for which `predicate` is true: bit `i` for element `i`.
    #[inline(always)]
    pub fn compare(self, other: Self, predicate: impl Fn(Real, Real) -> bool) -> u32 {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        let bit = |is_set: bool, index: u32| u32::from(is_set) << index;
        bit(predicate(a, e), 0) | bit(predicate(b, f), 1) | bit(predicate(c, g), 2) | bit(predicate(d, h), 3)
    }
}

impl Add for Real4 {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip_with(other, |a, b| a + b)
    }
}

impl Sub for Real4 {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip_with(other, |a, b| a - b)
    }
}

impl Mul for Real4 {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip_with(other, |a, b| a * b)
    }
}
