//! How much memory trees take, and how far an octree is cut.

use crate::math::morton;

/// What a builder would like to be lent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BvhRoom {
    /// Nodes. With fewer, down to one, leaves are larger.
    pub nodes: usize,
    /// Places for items. All are needed.
    pub items: usize,
}

impl BvhRoom {
    /// For a hierarchy of `items` items.
    pub const fn comfortable(items: usize) -> BvhRoom {
        BvhRoom { nodes: items.div_ceil(3) + items.div_ceil(3), items }
    }
}

/// How much memory an octree takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OctreeRoom {
    /// Nodes: one, and eight for each node that is cut.
    pub nodes: usize,
    /// Entries: one for each item in each leaf that it touches, and room to cut the root.
    pub items: usize,
}

impl OctreeRoom {
    /// What is comfortable for `items` items. With less, leaves are larger; the floor is one node
    /// and as many entries as items.
    pub const fn comfortable(items: usize) -> Self {
        OctreeRoom { nodes: items * 4 + 1, items: items * 8 }
    }
}

/// How far an octree is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OctreeLimits {
    /// How often space is cut, at most; more than 21 is taken for 21.
    pub depth: u8,
    /// A leaf with at most so many items is not cut.
    pub leaf: u32,
}

impl OctreeLimits {
    /// What is good for most scenes. On the standard procedural databases leaves of 8, 12, 16 and
    /// 24 items take times within 5 % of each other, leaves of 4 up to 8 % more; memory halves from
    /// 8 to 16. The depth ends where cutting does not pay: 5 to 16 there, 13 for 597,872 spheres of
    /// a sphereflake, which take 2.2 times as long as 7,382.
    pub const DEFAULT: OctreeLimits = OctreeLimits { depth: morton::BITS_PER_AXIS as u8, leaf: 12 };
}
