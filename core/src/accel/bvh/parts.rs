//! A hierarchy in parts, as a baked scene holds it.

use core::marker::PhantomData;

use super::Bvh;
use super::node::{Child, Goes, Node, Slot};

/// What makes a hierarchy, and nothing that follows from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BvhParts<'s> {
    pub(crate) nodes: &'s [Node],
    pub(crate) items: &'s [Slot],
    pub(crate) depth: u32,
}

impl<'s, W> Bvh<'s, W> {
    pub(crate) const fn parts(&self) -> BvhParts<'s> {
        BvhParts { nodes: self.nodes, items: self.leaves, depth: self.depth }
    }

    /// The hierarchy of parts, for a scene of `count` items; none when an index is out of range
    /// or the nodes do not lie depth first.
    pub(crate) fn from_parts(parts: BvhParts<'s>, count: u32) -> Option<Self> {
        let BvhParts { nodes, items, depth } = parts;
        let known = items.iter().all(|slot| slot.item().0 < count);
        let ends = items.last().is_none_or(|slot| slot.is_last());
        let mut tree = nodes.iter().zip(0..).all(|(node, place)| is_depth_first(&parts, count, node, place));
        // The root's part is all of them.
        tree &= nodes.first().is_none_or(|root| root.end() as usize == nodes.len());
        (known && ends && tree).then_some(Bvh { nodes, leaves: items, depth, walk: PhantomData })
    }
}

/// Whether the parts of a node are leaves with items, of which there are `count`, or lie one
/// after the other behind it; and whether its own part of the tree ends with theirs.
fn is_depth_first(parts: &BvhParts<'_>, count: u32, node: &Node, place: u32) -> bool {
    let BvhParts { nodes, items, .. } = *parts;
    let behind = |next: u32, child: Child| match child.goes() {
        Goes::Lone(item) => (item.0 < count).then_some(next),
        Goes::Out(first) => ((first as usize) < items.len()).then_some(next),
        Goes::On(below) if below == next => {
            nodes.get(below as usize).map(Node::end).filter(|end| *end > next)
        }
        Goes::On(_) => None,
    };
    node.all_children().into_iter().try_fold(place + 1, behind) == Some(node.end())
}
