//! Conversion between a BVH and the tables of a baked scene.

use core::marker::PhantomData;

use super::Bvh;
use super::node::{BvhEntry, BvhNode, NodeRef, PackedNodeRef};

/// The data of a BVH that a baked scene stores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BvhParts<'s> {
    pub(crate) nodes: &'s [BvhNode],
    pub(crate) entries: &'s [BvhEntry],
    pub(crate) depth: u32,
}

impl<'s, Queue> Bvh<'s, Queue> {
    pub(crate) const fn parts(&self) -> BvhParts<'s> {
        BvhParts { nodes: self.nodes, entries: self.leaf_elements, depth: self.depth }
    }

    /// The BVH of these parts, for a scene of `count` items. `None` if an index is out of range or the nodes
    /// are not in depth-first order.
    pub(crate) fn from_parts(parts: BvhParts<'s>, count: u32) -> Option<Self> {
        let BvhParts { nodes, entries, depth } = parts;
        let are_in_range = entries.iter().all(|entry| entry.item().0 < count);
        let is_last_leaf_complete = entries.last().is_none_or(|entry| entry.is_last());
        let mut is_tree =
            nodes.iter().zip(0..).all(|(node, index)| is_depth_first(&parts, count, node, index));
        // The root's subtree consists of all nodes.
        is_tree &= nodes.first().is_none_or(|root| root.skip_link() as usize == nodes.len());
        (are_in_range && is_last_leaf_complete && is_tree).then_some(Bvh {
            nodes,
            leaf_elements: entries,
            depth,
            queue: PhantomData,
        })
    }
}

/// Whether the inner children of `nodes[index]` follow it, one subtree after the other, its own skip link is
/// that of the last one, and its other children refer to existing leaves or to items below `count`.
fn is_depth_first(parts: &BvhParts<'_>, count: u32, node: &BvhNode, index: u32) -> bool {
    let BvhParts { nodes, entries, .. } = *parts;
    let index_after = |next: u32, child: PackedNodeRef| match child.unpack() {
        NodeRef::Item(item) => (item.0 < count).then_some(next),
        NodeRef::Leaf(first) => ((first as usize) < entries.len()).then_some(next),
        NodeRef::Inner(inner) if inner == next => {
            nodes.get(inner as usize).map(BvhNode::skip_link).filter(|skip_link| *skip_link > next)
        }
        NodeRef::Inner(_) => None,
    };
    node.all_children().into_iter().try_fold(index + 1, index_after) == Some(node.skip_link())
}
