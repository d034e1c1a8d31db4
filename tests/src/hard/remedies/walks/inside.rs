//! A node of an octree while a ray is in it: which of its children comes next.

use strahl_core::Vec3;

/// As in the core: distances as whole numbers, with their axes in the last bits.
pub(super) const AXIS: i32 = 7;
pub(super) const NEAR: i32 = 24;
const NEVER: i32 = i32::MAX;

#[inline(always)]
pub(super) fn ordered(distance: f32) -> i32 {
    let ahead = if distance > 0.0 { distance } else { 0.0 };
    ahead.to_bits() as i32
}

#[inline(always)]
fn is_negative(x: i32) -> i32 {
    x >> (i32::BITS - 1)
}

#[inline(always)]
fn axis(wall: i32) -> u8 {
    (wall & AXIS) as u8
}

/// A node that is cut, while a ray is in it.
#[derive(Clone, Copy)]
pub(super) struct Inside {
    walls: [i32; 3],
    pub(super) middles: Vec3,
    end: i32,
    pub(super) begin: i32,
    pub(super) children: u32,
    pub(super) occupied: u8,
    pub(super) child: u8,
    crossing: u8,
}

impl Inside {
    pub(super) const NONE: Inside = Inside {
        walls: [NEVER; 3],
        middles: Vec3::ZERO,
        end: 0,
        begin: 0,
        children: 0,
        occupied: 0,
        child: 0,
        crossing: 0,
    };

    #[inline(always)]
    pub(super) fn new(
        (children, occupied): (u32, u8),
        middles: Vec3,
        begin: i32,
        end: i32,
        near: i32,
    ) -> Self {
        let mut child = 0;
        let mut wall = |distance: f32, axis: i32| {
            let wall = ordered(distance) & !AXIS | axis;
            let is_behind = is_negative(wall + near - begin);
            let is_beyond = is_negative(end + near - wall);
            child |= is_behind & axis;
            wall | (is_behind | is_beyond) & NEVER
        };
        let (x, y, z) = (wall(middles.x, 1), wall(middles.y, 2), wall(middles.z, 4));
        let (x, y) = (x.min(y), x.max(y));
        let (y, z) = (y.min(z), y.max(z));
        let (x, y) = (x.min(y), x.max(y));
        Inside { walls: [x, y, z], middles, end, begin, children, occupied, child: child as u8, crossing: 0 }
    }

    #[inline(always)]
    pub(super) fn end_of_child(&self, near: i32) -> i32 {
        if self.crossing != 0 {
            return self.end.min(self.begin + 2 * near);
        }
        self.end.min(self.walls[0])
    }

    #[inline(always)]
    pub(super) fn horizontal<const CORNERS: bool>(&mut self, reach: i32) -> bool {
        if CORNERS && self.crossing != 0 {
            self.cross_on();
            return true;
        }
        let [next, second, third] = self.walls;
        if next & !AXIS > reach {
            return false;
        }
        self.begin = next;
        if CORNERS && second <= next + NEAR {
            self.cross_many();
            return true;
        }
        self.child ^= axis(next);
        self.walls = [second, third, NEVER];
        true
    }

    #[cold]
    fn cross_many(&mut self) {
        let [next, second, third] = self.walls;
        self.crossing = axis(next) | axis(second);
        self.walls = if third <= second + NEAR {
            self.crossing |= axis(third);
            [NEVER; 3]
        } else {
            [third, NEVER, NEVER]
        };
        self.cross_on();
    }

    #[cold]
    fn cross_on(&mut self) {
        let all = self.crossing;
        let behind = (self.child | !all).wrapping_add(1) & all;
        self.child = self.child & !all | behind;
        if behind == all {
            self.crossing = 0;
        }
    }
}
