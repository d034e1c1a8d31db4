//! Bounding volume hierarchy (BVH) with four children per node, in caller-provided buffers.
//!
//! Construction splits the items in two where the surface area heuristic expects the least work, and splits
//! the parts again until a node has up to four children. A node holds the bounds of all its children, so that
//! one visit tests all of them. Traversal continues with the nearest child, queues the others, and ends when
//! all queued nodes begin beyond `t_max`.
//!
//! The queue is a type parameter. [`TraversalHeap`] is a heap: of all pending nodes the nearest comes first.
//! [`TraversalStack`] is a stack: cheaper, and it visits hardly more nodes, because the nearest child of a
//! node is not queued. Both have a fixed capacity. When a queue is full, the subtree that does not fit is
//! traversed at once in the order of storage, by skip links, which needs no memory: nodes are stored depth
//! first, and each has the index of the first node after its subtree. A smaller capacity makes a traversal
//! slower and never changes the result.
//!
//! Sources: Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986 (heap); Smits, "Efficiency Issues for
//! Ray Tracing", JGT 3(2), 1998 (skip links); those of the construction are in its modules.

mod build;
mod leaf;
mod node;
#[cfg(feature = "baked")]
mod parts;
mod queue;
mod sealed;
mod split;
mod top_down;
mod traverse;

pub use build::{BvhBuilder, LeafLayout};
pub use leaf::LeafElement;
pub use node::{BvhEntry, BvhNode};
#[cfg(feature = "baked")]
pub(crate) use parts::BvhParts;
pub use queue::{TraversalHeap, TraversalQueue, TraversalStack};

use core::marker::PhantomData;

use node::NodeRef;

/// A bounding volume hierarchy with a traversal queue of type `Queue`. Its leaves consist of [`BvhEntry`]s
/// (single items) or of [`TriangleBlock`]s.
///
/// * Memory, in single precision: 128 bytes per [`BvhNode`]; in leaves, 4 bytes per item or 164 bytes per
///   [`TriangleBlock`]. A leaf of one item that is in no block is stored in its node.
/// * A scene without bounded items has no node; its traversal tests nothing.
///
/// [`TriangleBlock`]: super::TriangleBlock
#[derive(Debug)]
pub struct Bvh<'s, Queue, Element = BvhEntry> {
    /// In depth-first order.
    nodes: &'s [BvhNode],
    /// The elements of the leaves that are not stored in their node, one leaf after the other.
    leaf_elements: &'s [Element],
    /// Number of edges from the root to the deepest leaf.
    depth: u32,
    queue: PhantomData<fn() -> Queue>,
}

impl<Queue, Element> Clone for Bvh<'_, Queue, Element> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Queue, Element> Copy for Bvh<'_, Queue, Element> {}

impl<'s, Queue, Element: LeafElement> Bvh<'s, Queue, Element> {
    /// Size of all buffers that it uses, in bytes: nodes and leaf elements.
    pub const fn size_in_bytes(&self) -> usize {
        size_of_val(self.nodes) + size_of_val(self.leaf_elements)
    }

    /// The same hierarchy with another traversal queue.
    pub const fn with_queue<OtherQueue>(self) -> Bvh<'s, OtherQueue, Element> {
        let Bvh { nodes, leaf_elements, depth, .. } = self;
        Bvh { nodes, leaf_elements, depth, queue: PhantomData }
    }

    /// Number of leaves; 0 if the hierarchy is empty.
    pub fn leaf_count(&self) -> usize {
        self.single_item_leaf_count() + self.leaf_elements.iter().filter(|element| element.is_last()).count()
    }

    /// Number of items in all leaves; each item whose box is not empty is in exactly one.
    pub fn entry_count(&self) -> usize {
        let in_elements: usize = self.leaf_elements.iter().map(|element| element.item_count()).sum();
        self.single_item_leaf_count() + in_elements
    }

    /// Number of leaves that are a single item and stored in their node.
    fn single_item_leaf_count(&self) -> usize {
        let children = self.nodes.iter().flat_map(BvhNode::children);
        children.filter(|child| matches!(child.unpack(), NodeRef::Item(_))).count()
    }

    /// Number of edges from the root to the deepest leaf: 1 if all leaves are children of the root; 0 if
    /// the hierarchy is empty.
    pub const fn depth(&self) -> u32 {
        self.depth
    }
}
