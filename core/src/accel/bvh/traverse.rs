//! BVH traversal: nearest child first, without recursion, in bounded memory.

use core::mem::replace;
use core::ops::ControlFlow;

use super::node::{BoxHits, BvhNode, CHILDREN, NodeRef, PackedNodeRef, TraversalRay};
use super::queue::{PendingNode, TraversalQueue};
use super::{Bvh, LeafElement};
use crate::accel::{Accelerator, Query};
use crate::geometry::{ItemId, Ray};

impl<Queue: TraversalQueue, Element: LeafElement> Accelerator for Bvh<'_, Queue, Element> {
    type Scratch = Queue;

    #[inline]
    fn traverse<Q: Query>(&self, ray: &Ray, queue: &mut Queue, query: &mut Q) {
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = self.traverse_queued(ray, queue, query);
    }
}

impl<Queue: TraversalQueue, Element: LeafElement> Bvh<'_, Queue, Element> {
    #[inline(never)]
    fn traverse_queued<Q: Query>(&self, ray: &Ray, queue: &mut Queue, query: &mut Q) -> ControlFlow<()> {
        let ray = TraversalRay::new(ray);
        queue.clear();
        let mut current = PackedNodeRef::inner(0);
        loop {
            let nearest_child = match current.unpack() {
                NodeRef::Item(item) => {
                    visit_item(item, query)?;
                    None
                }
                NodeRef::Leaf(first) => {
                    self.visit_leaf(first, query)?;
                    None
                }
                NodeRef::Inner(index) => {
                    let Some(node) = self.nodes.get(index as usize) else { return ControlFlow::Continue(()) };
                    query.count_box_tests(CHILDREN as u32);
                    let mut hits = node.intersect(&ray, query.t_max());
                    let mut nearest = hits.take_next(node);
                    while let Some(child) = hits.take_next(node) {
                        let other = match &mut nearest {
                            Some(nearest) if Q::ORDERED && child.t_entry < nearest.t_entry => {
                                replace(nearest, child)
                            }
                            _ => child,
                        };
                        if let Err(rejected) = queue.push(other) {
                            self.traverse_stackless(rejected.node, &ray, query)?;
                        }
                    }
                    nearest
                }
            };
            let next = match nearest_child {
                Some(child) => Some(queue.push_pop(child)),
                None => queue.pop(query.t_max()),
            };
            match next {
                Some(pending) => current = pending.node,
                None => return ControlFlow::Continue(()),
            }
        }
    }

    #[inline(always)]
    fn visit_leaf<Q: Query>(&self, first: u32, query: &mut Q) -> ControlFlow<()> {
        query.count_leaf_visit();
        for element in self.leaf_elements.get(first as usize..).unwrap_or_default() {
            element.test_items(query)?;
            if element.is_last() {
                break;
            }
        }
        ControlFlow::Continue(())
    }

    /// Traverses a subtree in the order of storage, by skip links. Needs no memory.
    #[cold]
    fn traverse_stackless<Q: Query>(
        &self,
        root: PackedNodeRef,
        ray: &TraversalRay,
        query: &mut Q,
    ) -> ControlFlow<()> {
        let mut index = match root.unpack() {
            NodeRef::Item(item) => return visit_item(item, query),
            NodeRef::Leaf(first) => return self.visit_leaf(first, query),
            NodeRef::Inner(index) => index,
        };
        let end = self.nodes.get(index as usize).map_or(0, BvhNode::skip_link);
        while index < end
            && let Some(node) = self.nodes.get(index as usize)
        {
            query.count_box_tests(CHILDREN as u32);
            // The next node is the first inner child that is hit; without one, the node after the subtree.
            let mut next = node.skip_link();
            let mut hits = node.intersect(ray, query.t_max());
            while let Some(child) = hits.take_next(node) {
                match child.node.unpack() {
                    NodeRef::Item(item) => visit_item(item, query)?,
                    NodeRef::Leaf(first) => self.visit_leaf(first, query)?,
                    NodeRef::Inner(inner) if inner < next => next = inner,
                    NodeRef::Inner(_) => {}
                }
            }
            // Nodes are stored depth first, so `next` is always larger.
            index = if next > index { next } else { end };
        }
        ControlFlow::Continue(())
    }
}

/// Visits a leaf that is a single item.
#[inline(always)]
fn visit_item<Q: Query>(item: ItemId, query: &mut Q) -> ControlFlow<()> {
    query.count_leaf_visit();
    query.test_item(item)
}

impl BoxHits {
    /// Removes and returns the first child of `node` that is hit. It is no iterator, because the optimizer
    /// keeps those in memory, and this is the innermost loop of a traversal.
    #[inline(always)]
    fn take_next(&mut self, node: &BvhNode) -> Option<PendingNode> {
        let child = self.mask.trailing_zeros() as usize;
        let t_entry = *self.t_entry.0.get(child)?;
        self.mask &= self.mask - 1;
        Some(PendingNode { t_entry, node: node.child(child) })
    }
}
