//! Deterministic random numbers.

use crate::vector::{DVec3, dvec3};

/// The generator SplitMix64. All floating-point results are exact in `f32`, so that both cores get the same
/// numbers.
///
/// Source: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
#[derive(Clone, Debug)]
pub struct SplitMix64 {
    state: u64,
}

/// Rounds to the nearest `f32`.
pub fn rounded(x: f64) -> f64 {
    f64::from(x as f32)
}

impl SplitMix64 {
    /// A generator with this seed.
    pub fn new(seed: u64) -> Self {
        SplitMix64 { state: seed }
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 40) as f64 / f64::from(1 << 24)
    }

    /// A number in `[low, high)`, or `high` by rounding.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        rounded(low + (high - low) * self.unit())
    }

    /// A number in `[low, high)`, or `high` by rounding, whose logarithm is uniformly distributed.
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        // libm: the platform's functions differ in the last bits.
        rounded(libm::exp(libm::log(low) + libm::log(high / low) * self.unit()))
    }

    /// A number in `0..n`.
    pub fn below(&mut self, n: u32) -> u32 {
        (self.bits() % u64::from(n)) as u32
    }

    /// A point in the ball of `radius` around `center`, uniformly distributed.
    pub fn in_ball(&mut self, center: DVec3, radius: f64) -> DVec3 {
        loop {
            let mut coordinate = || 2.0 * self.unit() - 1.0;
            let p = dvec3(coordinate(), coordinate(), coordinate());
            if p.dot(p) <= 1.0 {
                let p = center + p * radius;
                return dvec3(rounded(p.x), rounded(p.y), rounded(p.z));
            }
        }
    }

    /// A unit vector, up to rounding, uniformly distributed.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let p = self.in_ball(DVec3::ZERO, 1.0);
            if p.dot(p) > 1e-4 {
                let p = p / p.dot(p).sqrt();
                return dvec3(rounded(p.x), rounded(p.y), rounded(p.z));
            }
        }
    }
}
