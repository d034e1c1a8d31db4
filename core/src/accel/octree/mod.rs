//! Octree, traversed by the SMART algorithm.
//!
//! Space is divided into eight octants where there are many items. The nodes are in one array: the eight
//! children of a node follow each other in the order of their Morton codes, and so do the groups of eight,
//! depth first. A node stores the index of its first child; there are no other links. The leaves list the
//! items whose bounds overlap them, in one array and in the same order.
//!
//! An octree is deep where items are small and close together, so it suits scenes that are too uneven for
//! a uniform grid. An item that overlaps many leaves is listed in each of them.

mod build;
mod node_state;
#[cfg(feature = "baked")]
mod parts;
mod smart;
mod traverse;

#[cfg(feature = "baked")]
pub(crate) use parts::OctreeParts;

use super::cell_planes::CellPlanes;
use crate::geometry::Aabb;
use crate::math::{Real, Vec3, max_abs_component, morton};

/// Number of cells of the deepest level along each axis.
const CELLS_PER_AXIS: Real = (1_u32 << morton::BITS_PER_AXIS) as Real;

/// A node of an [`Octree`]: an inner node with eight children, or a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct OctreeNode {
    /// Index of the first child, or of a leaf's first entry.
    first: u32,
    /// Of an inner node: [`OctreeNode::INNER_BIT`], and one bit per child that has entries. Of a leaf: the
    /// number of its entries.
    content: u32,
}

impl OctreeNode {
    /// A leaf without entries, the initial value for buffers.
    pub const EMPTY: OctreeNode = OctreeNode { first: 0, content: 0 };

    /// Marks inner nodes. No leaf has that many entries.
    const INNER_BIT: u32 = 1 << 31;

    const fn is_inner(self) -> bool {
        self.content & Self::INNER_BIT != 0
    }
}

/// An octree in caller-provided buffers, whose traversal uses a mailbox of `MAILBOX_ENTRIES` entries.
///
/// * `MAILBOX_ENTRIES` is zero or a power of two.
/// * Memory: 8 bytes per node, and 4 bytes per entry; an item has an entry in each leaf that its bounds
///   overlap.
#[derive(Clone, Copy, Debug)]
pub struct Octree<'s, const MAILBOX_ENTRIES: usize> {
    /// Union of the bounds of all items.
    bounds: Aabb,
    planes: CellPlanes,
    /// The root, then groups of eight siblings.
    nodes: &'s [OctreeNode],
    /// Item indices of the leaves, one leaf after the other.
    entries: &'s [u32],
    /// Bounds by item index, or empty.
    item_bounds: &'s [Aabb],
    /// Number of leaves with entries.
    occupied_leaves: u32,
    /// Number of edges from the root to the deepest leaf.
    depth: u8,
}

impl<'s, const MAILBOX_ENTRIES: usize> Octree<'s, MAILBOX_ENTRIES> {
    /// The same octree with a mailbox of another size.
    pub const fn with_mailbox<const ENTRIES: usize>(self) -> Octree<'s, ENTRIES> {
        let Octree { bounds, planes, nodes, entries, item_bounds, occupied_leaves, depth } = self;
        Octree { bounds, planes, nodes, entries, item_bounds, occupied_leaves, depth }
    }

    /// The same octree without the bounds of items: it needs less memory, but each item of a leaf is tested
    /// even if the ray misses its bounds.
    pub const fn without_item_bounds(self) -> Self {
        Octree { item_bounds: &[], ..self }
    }

    /// Number of leaves with entries.
    pub const fn occupied_leaf_count(&self) -> usize {
        self.occupied_leaves as usize
    }

    /// Number of entries of all leaves; an item counts once per leaf that lists it.
    pub const fn entry_count(&self) -> usize {
        self.entries.len()
    }

    /// Number of edges from the root to the deepest leaf; 0 if the root is a leaf.
    pub const fn depth(&self) -> u8 {
        self.depth
    }

    /// Number of nodes, empty leaves included.
    pub const fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// Size of all buffers that it uses, in bytes: nodes, entries and bounds of items.
    pub const fn size_in_bytes(&self) -> usize {
        size_of_val(self.nodes) + size_of_val(self.entries) + size_of_val(self.item_bounds)
    }

    /// Indices of the items in a leaf.
    #[inline(always)]
    fn leaf_entries(&self, leaf: OctreeNode) -> &[u32] {
        let start = leaf.first as usize;
        self.entries.get(start..start.wrapping_add(leaf.content as usize)).unwrap_or(&[])
    }
}

/// The planes of the cells of the deepest level. Cells are cubes, so that a flat scene is not divided into
/// flat cells.
fn octree_planes(bounds: Aabb) -> CellPlanes {
    let side = max_abs_component(bounds.max - bounds.min);
    CellPlanes::new(Aabb { min: bounds.min, max: bounds.min + side }, Vec3::splat(CELLS_PER_AXIS))
}
