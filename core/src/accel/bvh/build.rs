//! Building: split where a ray is expected to have the least work.
//!
//! The chance that a ray which meets a box also meets a box inside it is about the ratio of
//! their surfaces. So a split costs the visit of the node and, for each half, its share of the
//! surface times its items ("Automatic Creation of Object Hierarchies for Ray Tracing",
//! Goldsmith and Salmon, 1987). Splits are tried at the borders of equal bins along each axis
//! ("On fast Construction of SAH-based Bounding Volume Hierarchies", Wald, 2007).

use core::iter::from_fn;
use core::marker::PhantomData;

use heapless::Vec;

use super::node::{Child, Goes, Node, PARTS, Slot};
use super::split::{Costs, Split, split, surface};
use super::{Bvh, BvhRoom, Run};
use crate::accel::{BuildError, Storage};
use crate::geometry::{Aabb, Geometry, ItemId};
use crate::math::Real;

/// A part of the tree this deep is split into equal halves, whatever its boxes are like.
const EVEN: u32 = 16;

/// Three parts wait for each step from the root; from [`EVEN`] on, a step leaves at most half of
/// the items in a part, of at most 2^31.
const DEEPEST: usize = 3 * (EVEN as usize + 31) + 1;

/// A hierarchy that has been built and not been furnished: its leaves can be walked as they
/// are, or be laid out in runs.
#[derive(Debug)]
pub struct Grown<'s> {
    nodes: &'s mut [Node],
    items: &'s mut [Slot],
    depth: u32,
}

/// How the items of a leaf will be tested.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Leaves {
    /// One after the other.
    Singly,
    /// Four at once, in [`Run`]s.
    Runs,
}

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
        Grown::build(boxes, Leaves::Singly, nodes, items).map(Grown::singly)
    }
}

impl<'s> Grown<'s> {
    /// As [`Bvh::build`], for leaves that will be tested in one way or the other.
    pub fn build(
        boxes: &[Aabb],
        leaves: Leaves,
        nodes: &'s mut [Node],
        items: &'s mut [Slot],
    ) -> Result<Self, BuildError> {
        let bounded = survey(boxes)?;
        let floor = usize::from(bounded > 0);
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
        let mut growing = Growing { boxes, costs: Costs::of(leaves), nodes, used: 0, items, depth: 0 };
        growing.grow(budget as u32);
        let Growing { nodes, used, items, depth, .. } = growing;
        let nodes = nodes.get_mut(..used as usize).unwrap_or_default();
        close(nodes);
        Ok(Grown { nodes, items, depth })
    }

    /// The hierarchy as it is: the items of a leaf are tested one after the other.
    pub fn singly<W>(self) -> Bvh<'s, W> {
        let Grown { nodes, items, depth } = self;
        Bvh { nodes, leaves: items, depth, walk: PhantomData }
    }

    /// How many runs [`Grown::in_runs`] needs.
    pub fn runs(&self) -> usize {
        leaves(self.items).map(|leaf| leaf.len().div_ceil(Run::ITEMS)).sum()
    }

    /// The hierarchy with its leaves laid out in `runs`, of which [`Grown::runs`] are needed.
    /// `geometry` holds the items that it was built from.
    pub fn in_runs<W>(
        self,
        geometry: &Geometry<'_>,
        runs: &'s mut [Run],
    ) -> Result<Bvh<'s, W, Run>, BuildError> {
        let (needed, lent) = (self.runs(), runs.len());
        let Grown { nodes, items, depth } = self;
        let runs = runs.get_mut(..needed).ok_or(too_small(Storage::Runs, needed, lent))?;
        let (mut used, mut rest) = (0, runs.iter_mut());
        // In the order of the nodes: what a walk meets together lies together.
        for node in nodes.iter_mut() {
            for place in 0..node.children().count() {
                let Goes::Out(first) = node.child(place).goes() else { continue };
                let Some(leaf) = items.get(first as usize..).and_then(|items| leaves(items).next()) else {
                    continue;
                };
                node.set_child(place, Child::leaf(used));
                let chunks = leaf.chunks(Run::ITEMS);
                let mut left = chunks.len();
                for (chunk, run) in chunks.zip(&mut rest) {
                    left -= 1;
                    used += 1;
                    *run = Run::of(geometry, chunk, left > 0);
                }
            }
        }
        Ok(Bvh { nodes, leaves: runs, depth, walk: PhantomData })
    }
}

const fn too_small(what: Storage, needed: usize, lent: usize) -> BuildError {
    BuildError::StorageTooSmall { what, needed, lent }
}

/// The items of one leaf after the other.
fn leaves(items: &[Slot]) -> impl Iterator<Item = &[Slot]> {
    let mut rest = items;
    from_fn(move || {
        let (leaf, others) = rest.split_at_checked(rest.iter().position(|slot| slot.is_last())? + 1)?;
        rest = others;
        Some(leaf)
    })
}

/// How many items have a box.
fn survey(boxes: &[Aabb]) -> Result<usize, BuildError> {
    if boxes.len() > Slot::MOST {
        return Err(too_small(Storage::Items, boxes.len(), Slot::MOST));
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
        let Some(node) = nodes.get(place) else { continue };
        // The last of the parts that has nodes of its own has the last of them.
        let end = node.children().filter_map(end_of).last().unwrap_or(place as u32 + 1);
        if let Some(node) = nodes.get_mut(place) {
            node.set_end(end);
        }
    }
}

/// A tree that is being built.
struct Growing<'b, 's> {
    boxes: &'b [Aabb],
    costs: Costs,
    nodes: &'s mut [Node],
    used: u32,
    items: &'s mut [Slot],
    depth: u32,
}

/// Items that are still to be split, and where they hang.
#[derive(Clone, Copy)]
struct Part {
    items: Range,
    /// The node above, and which of its parts they are.
    above: (u32, usize),
    /// Steps from the root.
    level: u32,
    /// Nodes that may be made of them.
    budget: u32,
}

/// Items that follow each other, and the box round them.
#[derive(Clone, Copy)]
struct Range {
    first: u32,
    count: u32,
    aabb: Aabb,
    /// Whether a leaf is the best that can be made of them.
    stays: bool,
}

impl Growing<'_, '_> {
    fn grow(&mut self, budget: u32) {
        let count = self.items.len() as u32;
        if count == 0 {
            return;
        }
        let boxes = self.items.iter().filter_map(|slot| self.boxes.get(slot.item().0 as usize));
        let aabb = boxes.fold(Aabb::EMPTY, |all, aabb| all.union(*aabb));
        let root = Range { first: 0, count, aabb, stays: count < 2 };
        let Some(place) = self.node() else { return };
        let mut waiting: Vec<Part, DEEPEST> = Vec::new();
        let mut next = Some((root, place, 0, budget - 1));
        while let Some((range, place, level, budget)) = next {
            self.depth = if level + 1 > self.depth { level + 1 } else { self.depth };
            self.divide(range, place, level, budget, &mut waiting);
            next = self.hang(&mut waiting);
        }
    }

    /// Hangs what waits last; answers what became a node and is to be divided.
    fn hang(&mut self, waiting: &mut Vec<Part, DEEPEST>) -> Option<(Range, u32, u32, u32)> {
        while let Some(Part { items, above: (above, place), level, budget }) = waiting.pop() {
            let node = if items.stays || budget == 0 { None } else { self.node() };
            let child = node.map_or(Child::leaf(items.first), Child::node);
            if let Some(above) = self.nodes.get_mut(above as usize) {
                above.set_child(place, child);
            }
            if let Some(node) = node {
                return Some((items, node, level, budget - 1));
            }
            if let Some(last) = self.of(items).and_then(|items| items.last_mut()) {
                last.mark_last();
            }
        }
        None
    }

    /// Divides items into up to four parts of a node, which then wait, the first one last.
    fn divide(
        &mut self,
        range: Range,
        place: u32,
        level: u32,
        budget: u32,
        waiting: &mut Vec<Part, DEEPEST>,
    ) {
        let mut parts: Vec<Range, PARTS> = Vec::new();
        let mut full = parts.push(range).is_err();
        // The largest part that can be split is, until there are enough.
        while !full
            && let Some(largest) = largest_of(&parts)
            && let Some(part) = parts.get(largest).copied()
        {
            match self.halves(part, level >= EVEN) {
                Some([first, second]) => {
                    if let Some(part) = parts.get_mut(largest) {
                        *part = first;
                    }
                    full = parts.push(second).is_err() || parts.is_full();
                }
                None => {
                    if let Some(part) = parts.get_mut(largest) {
                        part.stays = true;
                    }
                }
            }
        }
        // Each part may make as many nodes as is its share of the items. The first comes last:
        // it is what is divided next.
        let (mut budget, mut items) = (u64::from(budget), u64::from(range.count));
        for (lane, part) in parts.iter().enumerate().rev() {
            if let Some(node) = self.nodes.get_mut(place as usize) {
                node.put(lane, &part.aabb);
            }
            let share = (budget * u64::from(part.count)).checked_div(items).unwrap_or(0);
            (budget, items) = (budget - share, items - u64::from(part.count));
            let above = (place, lane);
            let pushed = waiting.push(Part { items: *part, above, level: level + 1, budget: share as u32 });
            debug_assert!(pushed.is_ok(), "a tree deeper than can be");
        }
    }

    /// Splits items in two; none when they had better stay together.
    fn halves(&mut self, range: Range, even: bool) -> Option<[Range; 2]> {
        let (boxes, costs) = (self.boxes, self.costs);
        let Split { boxes: [a, b], count } = split(boxes, self.of(range)?, costs, even)?;
        let rest = range.count - count;
        Some([
            Range { first: range.first, count, aabb: a, stays: count < 2 },
            Range { first: range.first + count, count: rest, aabb: b, stays: rest < 2 },
        ])
    }

    fn of(&mut self, range: Range) -> Option<&mut [Slot]> {
        self.items.get_mut(range.first as usize..)?.get_mut(..range.count as usize)
    }

    /// The place of a new node, if there is one left.
    fn node(&mut self) -> Option<u32> {
        let place = self.used;
        *self.nodes.get_mut(place as usize)? = Node::EMPTY;
        self.used += 1;
        Some(place)
    }
}

/// The place of the largest box of those that may be split.
fn largest_of(parts: &[Range]) -> Option<usize> {
    let mut largest: Option<(usize, Real)> = None;
    for (part, place) in parts.iter().zip(0..).filter(|(part, _)| !part.stays) {
        let size = surface(&part.aabb);
        if largest.is_none_or(|(_, most)| size > most) {
            largest = Some((place, size));
        }
    }
    largest.map(|(place, _)| place)
}
