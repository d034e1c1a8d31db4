//! Bounded queues of the BVH nodes that a traversal still has to visit.

use core::cmp::Ordering;

use heapless::Vec;
use heapless::binary_heap::{BinaryHeap, Min};

use super::node::PackedNodeRef;
use super::sealed::Sealed;
use crate::math::Real;

/// A node that is still to be visited, and the `t` at which the ray enters its bounds.
#[derive(Clone, Copy, Debug)]
pub struct PendingNode {
    pub(super) t_entry: Real,
    pub(super) node: PackedNodeRef,
}

/// The nearer node is the smaller one. Nodes with equal `t_entry` have an order too, so that traversals are
/// repeatable.
impl Ord for PendingNode {
    fn cmp(&self, other: &Self) -> Ordering {
        self.t_entry.total_cmp(&other.t_entry).then(self.node.cmp(&other.node))
    }
}

impl PartialOrd for PendingNode {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for PendingNode {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for PendingNode {}

/// A queue of the nodes that a traversal of a [`Bvh`](super::Bvh) still has to visit, with fixed capacity.
///
/// Sealed: [`TraversalStack`] and [`TraversalHeap`] implement it.
pub trait TraversalQueue: Default + Sealed {
    /// Removes all nodes.
    fn clear(&mut self);

    /// Adds a node. Returns it as `Err` if the queue is full; the traversal then visits its subtree by skip
    /// links, which need no memory.
    fn push(&mut self, node: PendingNode) -> Result<(), PendingNode>;

    /// Adds a node and removes the one that comes first; never fails.
    fn push_pop(&mut self, node: PendingNode) -> PendingNode;

    /// Removes and returns the first node that begins at or before `t_max`; nodes that begin beyond are
    /// dropped.
    fn pop(&mut self, t_max: Real) -> Option<PendingNode>;
}

/// A [`TraversalQueue`] of up to `CAPACITY` nodes that is a stack: the node that was pushed last comes
/// first.
#[derive(Clone, Debug, Default)]
pub struct TraversalStack<const CAPACITY: usize>(Vec<PendingNode, CAPACITY>);

impl<const CAPACITY: usize> Sealed for TraversalStack<CAPACITY> {}

impl<const CAPACITY: usize> TraversalQueue for TraversalStack<CAPACITY> {
    #[inline(always)]
    fn clear(&mut self) {
        self.0.clear();
    }

    #[inline(always)]
    fn push(&mut self, node: PendingNode) -> Result<(), PendingNode> {
        self.0.push(node)
    }

    #[inline(always)]
    fn push_pop(&mut self, node: PendingNode) -> PendingNode {
        node
    }

    #[inline(always)]
    fn pop(&mut self, t_max: Real) -> Option<PendingNode> {
        loop {
            let node = self.0.pop()?;
            // Dropped only if strictly beyond: at equal `t` the item with the lower id wins, and it may be in
            // here.
            if !(node.t_entry > t_max) {
                return Some(node);
            }
        }
    }
}

/// A [`TraversalQueue`] of up to `CAPACITY` nodes that is a heap: the nearest node comes first. If it
/// begins beyond `t_max`, so do all others.
#[derive(Clone, Debug, Default)]
pub struct TraversalHeap<const CAPACITY: usize>(BinaryHeap<PendingNode, Min, CAPACITY>);

impl<const CAPACITY: usize> Sealed for TraversalHeap<CAPACITY> {}

impl<const CAPACITY: usize> TraversalQueue for TraversalHeap<CAPACITY> {
    fn clear(&mut self) {
        self.0.clear();
    }

    #[inline]
    fn push(&mut self, node: PendingNode) -> Result<(), PendingNode> {
        self.0.push(node)
    }

    #[inline]
    fn push_pop(&mut self, node: PendingNode) -> PendingNode {
        match self.0.peek_mut() {
            Some(mut nearest) if *nearest < node => core::mem::replace(&mut *nearest, node),
            _ => node,
        }
    }

    #[inline]
    fn pop(&mut self, t_max: Real) -> Option<PendingNode> {
        let nearest = self.0.pop()?;
        (!(nearest.t_entry > t_max)).then_some(nearest)
    }
}
