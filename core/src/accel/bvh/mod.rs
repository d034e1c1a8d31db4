//! Hierarchy of boxes, in memory that the caller lends.
//!
//! Items are split in two, and each half again, where that promises the least work; a node
//! holds the boxes of up to four parts that come of it, so that one visit answers for all four.
//! A walk takes the nearest part first, lets the others wait, and ends when all that waits
//! begins beyond the query's reach.
//!
//! Where nodes wait is a choice of type. [`NearestFirst`] is the heap of the lecture: the
//! nearest of all that waits comes next ("Ray Tracing Complex Scenes", Kay and Kajiya, 1986).
//! [`LastFirst`] is a stack: cheaper, and nearly as good, because the nearest part of a node does
//! not wait. Either has a fixed size and may be full: then the part of the tree that finds no
//! room is swept at once, in the order of storage, which takes no memory at all. For that the
//! nodes lie depth first, and each tells where its part ends. Fewer places make a walk slower,
//! never wrong.

mod build;
mod grow;
mod leaf;
mod node;
#[cfg(not(feature = "double"))]
mod parts;
mod run;
mod split;
mod waiting;
mod walk;

pub use build::{Grown, Leaves};
pub use leaf::Leaf;
pub use node::{Node, Slot};
#[cfg(not(feature = "double"))]
pub(crate) use parts::BvhParts;
pub(crate) use run::Candidate;
pub use run::Run;
pub use waiting::{LastFirst, NearestFirst, Waiting};

use core::marker::PhantomData;

use node::Goes;

/// A hierarchy of boxes whose walks keep what waits in a `W`, and whose leaves are made of
/// [`Slot`]s, single items, or of [`Run`]s of them.
///
/// * Memory: a [`Node`] (128 bytes) for each split into up to four parts, and in leaves of more
///   than one item 4 bytes for each of them, or 164 for each run. A lone item stands in the node.
/// * A scene without bounded items has no node, and offers nothing.
#[derive(Debug)]
pub struct Bvh<'s, W, L = Slot> {
    /// Depth first.
    nodes: &'s [Node],
    /// The pieces of each leaf of more than a lone item, one after the other.
    leaves: &'s [L],
    /// Steps from the root to the deepest leaf.
    depth: u32,
    walk: PhantomData<fn() -> W>,
}

impl<W, L> Clone for Bvh<'_, W, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<W, L> Copy for Bvh<'_, W, L> {}

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

impl<'s, W, L: Leaf> Bvh<'s, W, L> {
    /// The memory it uses, in bytes.
    pub const fn bytes(&self) -> usize {
        size_of_val(self.nodes) + size_of_val(self.leaves)
    }

    /// The same hierarchy, walked in another way.
    pub const fn walked<V>(self) -> Bvh<'s, V, L> {
        Bvh { nodes: self.nodes, leaves: self.leaves, depth: self.depth, walk: PhantomData }
    }

    /// Leaves.
    pub fn regions(&self) -> usize {
        self.lone() + self.leaves.iter().filter(|piece| piece.is_last()).count()
    }

    /// Items in all leaves: each stands in one.
    pub fn entries(&self) -> usize {
        self.lone() + self.leaves.iter().map(|piece| piece.count()).sum::<usize>()
    }

    /// Leaves of one item, which stands in the node.
    fn lone(&self) -> usize {
        let children = self.nodes.iter().flat_map(Node::children);
        children.filter(|child| matches!(child.goes(), Goes::Lone(_))).count()
    }

    /// Steps from the root to the deepest leaf.
    pub const fn depth(&self) -> u32 {
        self.depth
    }
}
