//! Random rays for the tests of walks, most of them aimed at hard places.

use crate::geometry::Ray;
use crate::math::{Real, Vec3, vec3};

/// Numbers from a seed ("Fast splittable pseudorandom number generators", Steele, Lea, Flood 2014).
pub(super) struct Random(pub(super) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in `0..n`.
    pub(super) fn below(&mut self, n: u32) -> u32 {
        (self.bits() % u64::from(n)) as u32
    }

    /// A number in `[low, high)`, or `high` by rounding.
    pub(super) fn between(&mut self, low: Real, high: Real) -> Real {
        low + (high - low) * ((self.bits() >> 40) as Real / (1_u32 << 24) as Real)
    }

    /// A point in the cube from `low` to `high` along each axis.
    pub(super) fn point(&mut self, low: Real, high: Real) -> Vec3 {
        vec3(self.between(low, high), self.between(low, high), self.between(low, high))
    }

    /// A ray towards the cube from -1 to 1 along each axis. `wall` gives coordinates of walls, from
    /// which and at which rays go: along walls, through their edges and corners, from inside them.
    /// A few come from far away, and a few directions are very long or very short.
    pub(super) fn ray(&mut self, mut wall: impl FnMut(&mut Random) -> Vec3) -> Ray {
        let mut place = |random: &mut Random, size: Real| {
            let (mut point, corner) = (random.point(-size, size), wall(random));
            for (x, wall) in [(&mut point.x, corner.x), (&mut point.y, corner.y), (&mut point.z, corner.z)] {
                if random.below(3) == 0 {
                    *x = wall;
                }
            }
            point
        };
        let size = [1.0, 2.0, 2.0, 100.0, 1e6][self.below(5) as usize];
        let (origin, target) = (place(self, size), place(self, 1.0));
        let mut way = target - origin;
        let zero = if self.below(2) == 0 { 0.0 } else { -0.0 };
        match self.below(16) {
            0 => way.x = zero,
            1 => way.y = zero,
            2 => way.z = zero,
            3 => way = vec3(way.x, zero, zero),
            4 => way = vec3(zero, way.y, -zero),
            5 => way = vec3(-zero, zero, way.z),
            6 => way = vec3(way.x, way.x, -way.x),
            _ => {}
        }
        way *= [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1e-30, 1e30][self.below(8) as usize];
        if way == Vec3::ZERO { Ray::new(origin, Vec3::X) } else { Ray::new(origin, way) }
    }
}
