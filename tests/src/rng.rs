//! SplitMix64 numbers that are the same in every run.

use crate::vector::{DVec3, dvec3};

/// Numbers from a seed ("Fast splittable pseudorandom number generators", Steele, Lea, Flood
/// 2014). All of them are numbers that `f32` holds exactly, so that both cores see the same.
#[derive(Clone, Debug)]
pub struct SplitMix64 {
    state: u64,
}

/// The nearest number that `f32` holds.
pub fn rounded(x: f64) -> f64 {
    f64::from(x as f32)
}

impl SplitMix64 {
    /// The numbers of a seed.
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

    /// A number in `[low, high)` whose logarithm is evenly spread: as many below 1 as above,
    /// between a tenth and ten.
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        // libm's, for the platform's own functions differ from place to place in the last bits.
        rounded(libm::exp(libm::log(low) + libm::log(high / low) * self.unit()))
    }

    /// A number in `0..n`.
    pub fn below(&mut self, n: u32) -> u32 {
        (self.bits() % u64::from(n)) as u32
    }

    /// A point of the ball of `radius` round `center`, evenly spread.
    pub fn in_ball(&mut self, center: DVec3, radius: f64) -> DVec3 {
        loop {
            let mut side = || 2.0 * self.unit() - 1.0;
            let p = dvec3(side(), side(), side());
            if p.dot(p) <= 1.0 {
                let p = center + p * radius;
                return dvec3(rounded(p.x), rounded(p.y), rounded(p.z));
            }
        }
    }

    /// A direction, evenly spread, of length one but for rounding.
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
