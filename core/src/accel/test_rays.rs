//! Random rays for the tests of traversals, most of them through degenerate positions.

use crate::geometry::Ray;
use crate::math::{Real, Vec3, vec3};

/// Pseudorandom numbers from a seed.
///
/// Source: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
pub(super) struct SplitMix64(pub(super) u64);

impl SplitMix64 {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// An integer in `0..n`.
    pub(super) fn below(&mut self, n: u32) -> u32 {
        (self.bits() % u64::from(n)) as u32
    }

    /// A number in `[min, max)`, or `max` by rounding.
    pub(super) fn between(&mut self, min: Real, max: Real) -> Real {
        min + (max - min) * ((self.bits() >> 40) as Real / (1_u32 << 24) as Real)
    }

    /// A point in the cube from `min` to `max` along each axis.
    pub(super) fn point(&mut self, min: Real, max: Real) -> Vec3 {
        vec3(self.between(min, max), self.between(min, max), self.between(min, max))
    }

    /// A ray towards the cube from -1 to 1 along each axis.
    ///
    /// `plane` returns coordinates of cell planes. Many origins and targets take them over, so that rays lie
    /// in planes, pass through edges and corners of cells, and start there. Some rays start far away, and
    /// some directions are very long or very short.
    pub(super) fn ray(&mut self, mut plane: impl FnMut(&mut SplitMix64) -> Vec3) -> Ray {
        let mut position = |random: &mut SplitMix64, size: Real| {
            let (mut point, corner) = (random.point(-size, size), plane(random));
            for (x, plane) in [(&mut point.x, corner.x), (&mut point.y, corner.y), (&mut point.z, corner.z)] {
                if random.below(3) == 0 {
                    *x = plane;
                }
            }
            point
        };
        let size = [1.0, 2.0, 2.0, 100.0, 1e6][self.below(5) as usize];
        let (origin, target) = (position(self, size), position(self, 1.0));
        let mut direction = target - origin;
        let zero = if self.below(2) == 0 { 0.0 } else { -0.0 };
        match self.below(16) {
            0 => direction.x = zero,
            1 => direction.y = zero,
            2 => direction.z = zero,
            3 => direction = vec3(direction.x, zero, zero),
            4 => direction = vec3(zero, direction.y, -zero),
            5 => direction = vec3(-zero, zero, direction.z),
            6 => direction = vec3(direction.x, direction.x, -direction.x),
            _ => {}
        }
        direction *= [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1e-30, 1e30][self.below(8) as usize];
        if direction == Vec3::ZERO { Ray::new(origin, Vec3::X) } else { Ray::new(origin, direction) }
    }
}
