//! Growing: split where a ray is expected to have the least work.
//!
//! The chance that a ray which meets a box also meets a box inside it is about the ratio of
//! their surfaces. So a split costs the visit of the node and, for each half, its share of the
//! surface times its items ("Automatic Creation of Object Hierarchies for Ray Tracing",
//! Goldsmith and Salmon, 1987). Splits are tried at the borders of equal bins along each axis
//! ("On fast Construction of SAH-based Bounding Volume Hierarchies", Wald, 2007).

use core::array;

use heapless::Vec;

use super::node::{Child, Node, PARTS, Slot};
use super::split::{Split, split, surface};
use crate::geometry::Aabb;

/// A part of the tree this deep is split into equal halves, whatever its boxes are like.
const EVEN: u32 = 16;

/// Three parts wait for each step from the root; from [`EVEN`] on, a step leaves at most half of
/// the items in a part, of at most 2^31.
const DEEPEST: usize = 3 * (EVEN as usize + 31) + 1;

/// A tree that has grown.
pub(super) struct Tree<'s> {
    pub(super) nodes: &'s mut [Node],
    /// Those that stand in leaves of more than one, leaf by leaf.
    pub(super) items: &'s mut [Slot],
    /// Steps from the root to the deepest leaf.
    pub(super) depth: u32,
}

/// Grows a tree over `items`, of at most `budget` nodes, one of them at least if there is an
/// item.
pub(super) fn grow<'s>(
    boxes: &[Aabb],
    nodes: &'s mut [Node],
    items: &'s mut [Slot],
    budget: u32,
) -> Tree<'s> {
    let mut growing = Growing { boxes, nodes, used: 0, items, kept: 0, depth: 0 };
    growing.grow(budget);
    let Growing { nodes, used, items, kept, depth, .. } = growing;
    Tree {
        nodes: nodes.get_mut(..used as usize).unwrap_or_default(),
        items: items.get_mut(..kept as usize).unwrap_or_default(),
        depth,
    }
}

/// A tree that is being built.
struct Growing<'b, 's> {
    boxes: &'b [Aabb],
    nodes: &'s mut [Node],
    used: u32,
    items: &'s mut [Slot],
    /// Items of finished leaves, which have moved to the front.
    kept: u32,
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
            let child = match node {
                Some(node) => Child::node(node),
                None => self.leaf(items),
            };
            if let Some(above) = self.nodes.get_mut(above as usize) {
                above.set_child(place, child);
            }
            if let Some(node) = node {
                return Some((items, node, level, budget - 1));
            }
        }
        None
    }

    /// Makes a leaf. A lone item that is tested by itself has its place in the node; others move
    /// to the end of what is kept, which is never behind them: leaves are made in their order.
    fn leaf(&mut self, range: Range) -> Child {
        let Range { first, count, .. } = range;
        let slot = |items: &[Slot], place: u32| items.get(place as usize).copied();
        if count == 1
            && let Some(slot) = slot(self.items, first)
            && !slot.is_grouped()
        {
            return Child::lone(slot.item());
        }
        let leaf = Child::leaf(self.kept);
        for place in first..first + count {
            if let Some(mut slot) = slot(self.items, place)
                && let Some(kept) = self.items.get_mut(self.kept as usize)
            {
                if place + 1 == first + count {
                    slot.mark_last();
                }
                *kept = slot;
                self.kept += 1;
            }
        }
        leaf
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
        let mut parts: [Option<Range>; PARTS] = array::from_fn(|at| if at == 0 { Some(range) } else { None });
        // The largest part that can be split is, until there are enough.
        while parts.last().is_some_and(Option::is_none)
            && let Some((place, largest)) = largest_of(&parts)
        {
            parts = match self.halves(largest, level >= EVEN) {
                // In the order of their items.
                Some([first, second]) => array::from_fn(|at| match at.checked_sub(place + 1) {
                    Some(0) => Some(second),
                    Some(_) => parts.get(at - 1).copied().flatten(),
                    None if at == place => Some(first),
                    None => parts.get(at).copied().flatten(),
                }),
                None => {
                    let stays = Range { stays: true, ..largest };
                    array::from_fn(
                        |at| if at == place { Some(stays) } else { parts.get(at).copied().flatten() },
                    )
                }
            };
        }
        // Each part may make as many nodes as is its share of the items. The first comes last:
        // it is what is divided next.
        let (mut budget, mut items) = (u64::from(budget), u64::from(range.count));
        for (lane, part) in parts.iter().enumerate().rev().filter_map(|(lane, part)| Some((lane, (*part)?))) {
            if let Some(node) = self.nodes.get_mut(place as usize) {
                node.put(lane, &part.aabb);
            }
            let share = (budget * u64::from(part.count)).checked_div(items).unwrap_or(0);
            (budget, items) = (budget - share, items - u64::from(part.count));
            let above = (place, lane);
            let pushed = waiting.push(Part { items: part, above, level: level + 1, budget: share as u32 });
            debug_assert!(pushed.is_ok(), "a tree deeper than can be");
        }
    }

    /// Splits items in two; none when they had better stay together.
    fn halves(&mut self, range: Range, even: bool) -> Option<[Range; 2]> {
        let boxes = self.boxes;
        let Split { boxes: [a, b], count } = split(boxes, self.of(range)?, even)?;
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

/// The largest box of those that may be split, and its place.
fn largest_of(parts: &[Option<Range>]) -> Option<(usize, Range)> {
    let mut largest: Option<(usize, Range)> = None;
    for (place, part) in parts.iter().enumerate().filter_map(|(place, part)| Some((place, (*part)?))) {
        let is_larger = largest.is_none_or(|(_, largest)| surface(&part.aabb) > surface(&largest.aabb));
        if !part.stays && is_larger {
            largest = Some((place, part));
        }
    }
    largest
}
