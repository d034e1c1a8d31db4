//! Building: split where a ray is expected to have the least work.
//!
//! The chance that a ray which meets a box also meets a box inside it is about the ratio of
//! their surfaces. So a split costs the visit of the node and, for each half, its share of the
//! surface times its items ("Automatic Creation of Object Hierarchies for Ray Tracing",
//! Goldsmith and Salmon, 1987). Splits are tried at the borders of equal bins along each axis
//! ("On fast Construction of SAH-based Bounding Volume Hierarchies", Wald, 2007).

use core::marker::PhantomData;

use heapless::Vec;

use super::node::{Child, Goes, Node, Slot};
use super::split::{Split, split};
use super::{Bvh, BvhRoom};
use crate::accel::{BuildError, Storage};
use crate::geometry::{Aabb, ItemId};

/// A leaf has at most so many items, if there are nodes enough.
const LEAF: u32 = 8;

/// A part of the tree this deep is split into equal halves, whatever its boxes are like. With
/// at most 2^31 items no part is then deeper than 31 more.
const EVEN: u32 = 32;

/// One part waits for each step from the root.
const DEEPEST: usize = EVEN as usize + 32;

impl<'s, W> Bvh<'s, W> {
    /// The hierarchy of the items inside `boxes`, one box for each, in their order; items with
    /// an empty box are left out.
    ///
    /// [`BvhRoom::comfortable`] tells what to lend. With fewer `nodes` leaves are larger; one
    /// is needed if there is an item at all, and a place for each item.
    ///
    /// Errors: [`BuildError::StorageTooSmall`], and [`BuildError::NotFinite`] for a box without
    /// end.
    pub fn build(boxes: &[Aabb], nodes: &'s mut [Node], items: &'s mut [Slot]) -> Result<Self, BuildError> {
        let bounded = survey(boxes)?;
        let floor = usize::from(bounded > 0);
        let too_small = |what, needed, lent| BuildError::StorageTooSmall { what, needed, lent };
        if nodes.len() < floor {
            return Err(too_small(Storage::Nodes, floor, nodes.len()));
        }
        let lent = items.len();
        let items = items.get_mut(..bounded).ok_or(too_small(Storage::Items, bounded, lent))?;
        for (slot, item) in items.iter_mut().zip(bounded_items(boxes)) {
            *slot = Slot::of(item);
        }

        let wanted = BvhRoom::comfortable(bounded).nodes;
        let budget = if wanted < nodes.len() { wanted } else { nodes.len() };
        let mut growing = Growing { boxes, nodes, used: 0, items, depth: 0 };
        growing.grow(budget as u32);
        let Growing { nodes, used, items, depth, .. } = growing;
        let nodes = nodes.get_mut(..used as usize).unwrap_or_default();
        close(nodes);
        Ok(Bvh { nodes, items, depth, walk: PhantomData })
    }
}

/// How many items have a box.
fn survey(boxes: &[Aabb]) -> Result<usize, BuildError> {
    if boxes.len() > Slot::MOST {
        let (needed, lent) = (boxes.len(), Slot::MOST);
        return Err(BuildError::StorageTooSmall { what: Storage::Items, needed, lent });
    }
    let mut bounded = 0;
    for (aabb, number) in boxes.iter().zip(0..).filter(|(aabb, _)| !aabb.is_empty()) {
        if !(aabb.min.is_finite() && aabb.max.is_finite()) {
            return Err(BuildError::NotFinite { item: ItemId(number) });
        }
        bounded += 1;
    }
    Ok(bounded)
}

fn bounded_items(boxes: &[Aabb]) -> impl Iterator<Item = ItemId> + '_ {
    boxes.iter().zip(0..).filter(|(aabb, _)| !aabb.is_empty()).map(|(_, number)| ItemId(number))
}

/// Tells every node where its part of the tree ends, from the last to the first.
fn close(nodes: &mut [Node]) {
    for place in (0..nodes.len()).rev() {
        let end_of = |child: Child| match child.goes() {
            Goes::On(below) => nodes.get(below as usize).map(Node::end),
            Goes::Out(_) => None,
        };
        let Some([first, second]) = nodes.get(place).map(Node::children) else { continue };
        let end = end_of(second).or(end_of(first)).unwrap_or(place as u32 + 1);
        if let Some(node) = nodes.get_mut(place) {
            node.set_end(end);
        }
    }
}

/// A tree that is being built.
struct Growing<'b, 's> {
    boxes: &'b [Aabb],
    nodes: &'s mut [Node],
    used: u32,
    items: &'s mut [Slot],
    depth: u32,
}

/// Items that are still to be split, and which half of which node they are.
#[derive(Clone, Copy)]
struct Part {
    first: u32,
    count: u32,
    /// The node above, and whether they are its second half; none for the root.
    above: Option<(u32, bool)>,
    /// Steps from the root.
    level: u32,
    /// Nodes that may be made of them.
    budget: u32,
}

impl Growing<'_, '_> {
    fn grow(&mut self, budget: u32) {
        let count = self.items.len() as u32;
        if count == 0 {
            return;
        }
        let mut waiting: Vec<Part, DEEPEST> = Vec::new();
        let mut next = Some(Part { first: 0, count, above: None, level: 0, budget });
        while let Some(part) = next {
            next = match self.halves(part) {
                Some([first, second]) => {
                    let pushed = waiting.push(second);
                    debug_assert!(pushed.is_ok(), "a tree deeper than can be");
                    Some(first)
                }
                None => {
                    self.leaf(part);
                    waiting.pop()
                }
            };
        }
    }

    /// Splits a part and makes the node of the split; none when it is to be a leaf.
    fn halves(&mut self, part: Part) -> Option<[Part; 2]> {
        let Part { first, count, level, budget, .. } = part;
        if budget == 0 || count < 2 {
            return None;
        }
        let items = self.items.get_mut(first as usize..)?.get_mut(..count as usize)?;
        let Split { boxes, count: left } = split(self.boxes, items, LEAF, level >= EVEN)?;
        let place = self.node(part, Node::of(boxes))?;
        // Each half may make as many nodes as is its share of the items.
        let left_budget = (u64::from(budget - 1) * u64::from(left) / u64::from(count)) as u32;
        let half = |first, count, second, budget| Part {
            first,
            count,
            above: Some((place, second)),
            level: level + 1,
            budget,
        };
        Some([
            half(first, left, false, left_budget),
            half(first + left, count - left, true, budget - 1 - left_budget),
        ])
    }

    /// Makes a leaf of a part. The root is a node also then, whose second half is empty.
    fn leaf(&mut self, part: Part) {
        let Some(items) =
            self.items.get_mut(part.first as usize..).and_then(|items| items.get_mut(..part.count as usize))
        else {
            return;
        };
        let all = items.iter().filter_map(|slot| self.boxes.get(slot.item().0 as usize));
        let all = all.fold(Aabb::EMPTY, |all, aabb| all.union(*aabb));
        if let Some(last) = items.last_mut() {
            last.mark_last();
        }
        let child = Child::leaf(part.first);
        match part.above {
            Some(above) => self.hang(above, child),
            None => {
                if let Some(place) = self.node(part, Node::of([all, Aabb::EMPTY])) {
                    self.hang((place, false), child);
                }
            }
        }
        let steps = if part.level > 0 { part.level } else { 1 };
        self.depth = if steps > self.depth { steps } else { self.depth };
    }

    /// Stores a node for a part.
    fn node(&mut self, part: Part, node: Node) -> Option<u32> {
        let place = self.used;
        *self.nodes.get_mut(place as usize)? = node;
        self.used += 1;
        if let Some(above) = part.above {
            self.hang(above, Child::node(place));
        }
        Some(place)
    }

    fn hang(&mut self, (above, second): (u32, bool), child: Child) {
        if let Some(node) = self.nodes.get_mut(above as usize) {
            let [a, b] = node.children();
            node.set_children(if second { [a, child] } else { [child, b] });
        }
    }
}
