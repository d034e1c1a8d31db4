//! Sizes of the buffers of trees, and the limits of an octree.

use crate::math::morton;

/// Sizes of the buffers of a [`Bvh`](super::Bvh), as numbers of elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BvhSize {
    /// Number of nodes. With fewer, down to one, leaves are larger.
    pub nodes: usize,
    /// Number of leaf entries, one per item whose box is not empty. All are needed.
    pub entries: usize,
}

impl BvhSize {
    /// The sizes for `items` items. Fewer nodes, down to one, only make leaves larger; all entries are
    /// needed.
    pub const fn recommended(items: usize) -> Self {
        BvhSize { nodes: items.div_ceil(3) + items.div_ceil(3), entries: items }
    }
}

/// Sizes of the buffers of an [`Octree`](super::Octree), as numbers of elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OctreeSize {
    /// Number of nodes: one, and eight per inner node.
    pub nodes: usize,
    /// Number of entries: one per item and leaf that its bounds overlap, and enough to subdivide the root.
    pub entries: usize,
}

impl OctreeSize {
    /// Sizes that suffice for most scenes of `items` items. Smaller buffers only make leaves larger, down
    /// to one node and one entry per item.
    pub const fn recommended(items: usize) -> Self {
        OctreeSize { nodes: items * 4 + 1, entries: items * 8 }
    }
}

/// Where the subdivision of an [`Octree`](super::Octree) ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OctreeLimits {
    /// Largest depth of a leaf, in edges from the root; values above 21 mean 21.
    pub max_depth: u8,
    /// A node with at most this many items is not subdivided.
    pub max_leaf_items: u32,
}

impl OctreeLimits {
    /// Suits most scenes: the largest depth, and leaves of 12 items. Leaves of 8 to 24 items take about the
    /// same time, and larger leaves need less memory. Subdivision ends earlier where it is not worth it.
    pub const DEFAULT: OctreeLimits =
        OctreeLimits { max_depth: morton::BITS_PER_AXIS as u8, max_leaf_items: 12 };
}
