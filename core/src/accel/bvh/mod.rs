//! Hierarchy of boxes, in memory that the caller lends.
//!
//! Items are split in two, and each half again, where that promises the least work; a node
//! holds the boxes of its two halves, so that one visit answers for both. A walk takes the
//! nearer half first, lets the other one wait, and ends when all that waits begins beyond the
//! query's reach.
//!
//! Where nodes wait is a choice of type. [`NearestFirst`] is the heap of the lecture: the
//! nearest of all that waits comes next ("Ray Tracing Complex Scenes", Kay and Kajiya, 1986).
//! [`LastFirst`] is a stack: cheaper, and nearly as good, because of two halves the farther
//! one waits. Either has a fixed size and may be full: then the part of the tree that finds no
//! room is swept at once, in the order of storage, which takes no memory at all. For that the
//! nodes lie depth first, and each tells where its part ends. Fewer places make a walk slower,
//! never wrong.

mod build;
mod node;
#[cfg(not(feature = "double"))]
mod parts;
mod split;
mod waiting;
mod walk;

pub use node::{Node, Slot};
#[cfg(not(feature = "double"))]
pub(crate) use parts::BvhParts;
pub use waiting::{LastFirst, NearestFirst, Waiting};

use core::marker::PhantomData;

/// A hierarchy of boxes whose walks keep what waits in a `W`.
///
/// * Memory: a [`Node`] (60 bytes) for each split, and 4 bytes for each item.
/// * A scene without bounded items has no node, and offers nothing.
#[derive(Debug)]
pub struct Bvh<'s, W> {
    /// Depth first.
    nodes: &'s [Node],
    /// The items of each leaf, one after the other; the last of a leaf is marked.
    items: &'s [Slot],
    /// Steps from the root to the deepest leaf.
    depth: u32,
    walk: PhantomData<fn() -> W>,
}

impl<W> Clone for Bvh<'_, W> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<W> Copy for Bvh<'_, W> {}

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
        BvhRoom { nodes: if items > 2 { items - 1 } else { items.div_ceil(2) }, items }
    }
}

impl<'s, W> Bvh<'s, W> {
    /// The memory it uses, in bytes.
    pub const fn bytes(&self) -> usize {
        size_of_val(self.nodes) + size_of_val(self.items)
    }

    /// The same hierarchy, walked in another way.
    pub const fn walked<V>(self) -> Bvh<'s, V> {
        Bvh { nodes: self.nodes, items: self.items, depth: self.depth, walk: PhantomData }
    }

    /// Leaves.
    pub fn regions(&self) -> usize {
        self.items.iter().filter(|slot| slot.is_last()).count()
    }

    /// Items in all leaves: each stands in one.
    pub const fn entries(&self) -> usize {
        self.items.len()
    }

    /// Steps from the root to the deepest leaf.
    pub const fn depth(&self) -> u32 {
        self.depth
    }
}
