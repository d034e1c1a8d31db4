//! Four numbers side by side, for machines that count four at once.
//!
//! Plain arrays: a compiler that knows such instructions uses them, any other counts one after
//! the other. Each lane does what a single number would, so that the bits are the same.

use core::ops::{Add, Mul, Sub};

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::{Real, greatest, least};

/// How many lanes.
pub const LANES: usize = 4;

/// Four numbers.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(transparent)]
pub struct Lanes(pub [Real; LANES]);

impl Lanes {
    /// The same number four times.
    #[inline(always)]
    pub const fn splat(x: Real) -> Self {
        Lanes([x; LANES])
    }

    /// What `step` makes of each pair.
    #[inline(always)]
    fn with(self, other: Self, step: impl Fn(Real, Real) -> Real) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        Lanes([step(a, e), step(b, f), step(c, g), step(d, h)])
    }

    /// [`greatest`] in each lane.
    #[inline(always)]
    pub fn greatest(self, other: Self) -> Self {
        self.with(other, greatest)
    }

    /// [`least`] in each lane.
    #[inline(always)]
    pub fn least(self, other: Self) -> Self {
        self.with(other, least)
    }

    /// A bit for every lane.
    pub const ALL: u32 = 0b1111;

    /// The bits of the lanes of which `is` is true.
    #[inline(always)]
    pub fn bits(self, other: Self, is: impl Fn(Real, Real) -> bool) -> u32 {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        let bit = |is: bool, place: u32| u32::from(is) << place;
        bit(is(a, e), 0) | bit(is(b, f), 1) | bit(is(c, g), 2) | bit(is(d, h), 3)
    }
}

impl Add for Lanes {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl Sub for Lanes {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}
