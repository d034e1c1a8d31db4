//! Top-down construction of a BVH with a budget of nodes.
//!
//! Items are split by [`split`] until a range is a leaf or its share of the node budget is used up. The state
//! is an explicit stack of pending ranges instead of recursion; the nodes come out in depth-first order.
//! Finished leaves are moved to the front of the entries, which needs no second buffer.

use core::array;

use heapless::Vec;

use super::node::{BvhEntry, BvhNode, CHILDREN, PackedNodeRef};
use super::split::{Split, half_area, split};
use crate::geometry::Aabb;

/// Depth from which on ranges are split into equal counts, whatever their bounds. It limits the depth of the
/// tree.
const EQUAL_COUNTS_DEPTH: u32 = 16;

/// Capacity of the stack of pending ranges: three per level, and from [`EQUAL_COUNTS_DEPTH`] on each level at
/// least halves a range of at most 2^31 items.
const MAX_PENDING: usize = 3 * (EQUAL_COUNTS_DEPTH as usize + 31) + 1;

/// The result of [`build_top_down`].
pub(super) struct BuiltTree<'s> {
    /// In depth-first order; skip links are not set.
    pub(super) nodes: &'s mut [BvhNode],
    /// The entries of the leaves that are not stored in their node, one leaf after the other.
    pub(super) entries: &'s mut [BvhEntry],
    /// Number of edges from the root to the deepest leaf.
    pub(super) depth: u32,
}

/// Builds a tree over all of `entries`, of at most `node_budget` nodes: at least one if there is an entry.
///
/// `bounds`: by item index.
pub(super) fn build_top_down<'s>(
    bounds: &[Aabb],
    nodes: &'s mut [BvhNode],
    entries: &'s mut [BvhEntry],
    node_budget: u32,
) -> BuiltTree<'s> {
    let mut build = TopDownBuild { bounds, nodes, node_count: 0, entries, finished_entries: 0, depth: 0 };
    build.run(node_budget);
    let TopDownBuild { nodes, node_count, entries, finished_entries, depth, .. } = build;
    BuiltTree {
        nodes: nodes.get_mut(..node_count as usize).unwrap_or_default(),
        entries: entries.get_mut(..finished_entries as usize).unwrap_or_default(),
        depth,
    }
}

/// The state of the construction.
struct TopDownBuild<'b, 's> {
    bounds: &'b [Aabb],
    nodes: &'s mut [BvhNode],
    node_count: u32,
    entries: &'s mut [BvhEntry],
    /// Number of entries of finished leaves, which are at the front of `entries`.
    finished_entries: u32,
    depth: u32,
}

/// A range that is still to be made a leaf or split further, and its parent.
#[derive(Clone, Copy)]
struct PendingRange {
    items: ItemRange,
    /// Index of the parent node, and index among its children.
    parent: (u32, usize),
    /// Number of edges from the root.
    depth: u32,
    /// Largest number of nodes that may be made of it.
    node_budget: u32,
}

/// A range of consecutive entries, and the union of their bounds.
#[derive(Clone, Copy)]
struct ItemRange {
    first: u32,
    count: u32,
    aabb: Aabb,
    /// Whether it is not to be split.
    is_leaf: bool,
}

/// A range that has a node and is to be split into the children of that node.
struct OpenNode {
    items: ItemRange,
    index: u32,
    depth: u32,
    /// Largest number of nodes that may be made below it.
    node_budget: u32,
}

impl TopDownBuild<'_, '_> {
    fn run(&mut self, node_budget: u32) {
        let count = self.entries.len() as u32;
        if count == 0 {
            return;
        }
        let bounds = self.entries.iter().filter_map(|entry| self.bounds.get(entry.item().0 as usize));
        let aabb = bounds.fold(Aabb::EMPTY, |all, aabb| all.union(*aabb));
        let items = ItemRange { first: 0, count, aabb, is_leaf: count < 2 };
        let Some(index) = self.allocate_node() else { return };
        let mut pending: Vec<PendingRange, MAX_PENDING> = Vec::new();
        let mut next = Some(OpenNode { items, index, depth: 0, node_budget: node_budget - 1 });
        while let Some(node) = next {
            self.depth = if node.depth + 1 > self.depth { node.depth + 1 } else { self.depth };
            self.split_into_children(node, &mut pending);
            next = self.attach_pending(&mut pending);
        }
    }

    /// Attaches pending ranges to their parents, the last one first, until one becomes a node that is to be
    /// split.
    fn attach_pending(&mut self, pending: &mut Vec<PendingRange, MAX_PENDING>) -> Option<OpenNode> {
        while let Some(PendingRange { items, parent, depth, node_budget }) = pending.pop() {
            let index = if items.is_leaf || node_budget == 0 { None } else { self.allocate_node() };
            let child = match index {
                Some(index) => PackedNodeRef::inner(index),
                None => self.make_leaf(items),
            };
            let (parent, child_index) = parent;
            if let Some(parent) = self.nodes.get_mut(parent as usize) {
                parent.set_child(child_index, child);
            }
            if let Some(index) = index {
                return Some(OpenNode { items, index, depth, node_budget: node_budget - 1 });
            }
        }
        None
    }

    /// Makes a leaf. A single item that is not tested in a block is stored in the node. Other entries are
    /// moved to the end of the finished ones, which is never after the range itself, because leaves are made
    /// in the order of their entries.
    fn make_leaf(&mut self, range: ItemRange) -> PackedNodeRef {
        let ItemRange { first, count, .. } = range;
        let entry_at = |entries: &[BvhEntry], index: u32| entries.get(index as usize).copied();
        if count == 1
            && let Some(entry) = entry_at(self.entries, first)
            && !entry.is_in_block()
        {
            return PackedNodeRef::item(entry.item());
        }
        let leaf = PackedNodeRef::leaf(self.finished_entries);
        for index in first..first + count {
            if let Some(mut entry) = entry_at(self.entries, index)
                && let Some(finished) = self.entries.get_mut(self.finished_entries as usize)
            {
                if index + 1 == first + count {
                    entry.mark_last();
                }
                *finished = entry;
                self.finished_entries += 1;
            }
        }
        leaf
    }

    /// Splits the range of a node into its children, and makes them pending, the first one last.
    fn split_into_children(&mut self, node: OpenNode, pending: &mut Vec<PendingRange, MAX_PENDING>) {
        let mut children: [Option<ItemRange>; CHILDREN] =
            array::from_fn(|index| if index == 0 { Some(node.items) } else { None });
        // Split the largest range that can be split, until there are enough.
        while children.last().is_some_and(Option::is_none)
            && let Some((split_index, largest)) = largest_splittable(&children)
        {
            children = match self.split_range(largest, node.depth >= EQUAL_COUNTS_DEPTH) {
                // In the order of their entries.
                Some([left, right]) => array::from_fn(|index| match index.checked_sub(split_index + 1) {
                    Some(0) => Some(right),
                    Some(_) => children.get(index - 1).copied().flatten(),
                    None if index == split_index => Some(left),
                    None => children.get(index).copied().flatten(),
                }),
                None => {
                    let leaf = ItemRange { is_leaf: true, ..largest };
                    array::from_fn(|index| {
                        if index == split_index { Some(leaf) } else { children.get(index).copied().flatten() }
                    })
                }
            };
        }
        // Each child gets its share of the node budget by its share of the items. The first child comes last,
        // because it is the next one to be split.
        let (mut budget_left, mut items_left) = (u64::from(node.node_budget), u64::from(node.items.count));
        let used = |(child, range): (usize, &Option<ItemRange>)| Some((child, (*range)?));
        for (child, items) in children.iter().enumerate().rev().filter_map(used) {
            if let Some(node) = self.nodes.get_mut(node.index as usize) {
                node.set_bounds(child, &items.aabb);
            }
            let share = (budget_left * u64::from(items.count)).checked_div(items_left).unwrap_or(0);
            (budget_left, items_left) = (budget_left - share, items_left - u64::from(items.count));
            let parent = (node.index, child);
            let range = PendingRange { items, parent, depth: node.depth + 1, node_budget: share as u32 };
            let pushed = pending.push(range);
            debug_assert!(pushed.is_ok(), "more than MAX_PENDING pending ranges");
        }
    }

    /// Splits a range in two; `None` if it is better kept as a leaf.
    fn split_range(&mut self, range: ItemRange, equal_counts: bool) -> Option<[ItemRange; 2]> {
        let bounds = self.bounds;
        let Split { bounds: [left, right], left_count } =
            split(bounds, self.entries_of(range)?, equal_counts)?;
        let right_count = range.count - left_count;
        Some([
            ItemRange { first: range.first, count: left_count, aabb: left, is_leaf: left_count < 2 },
            ItemRange {
                first: range.first + left_count,
                count: right_count,
                aabb: right,
                is_leaf: right_count < 2,
            },
        ])
    }

    fn entries_of(&mut self, range: ItemRange) -> Option<&mut [BvhEntry]> {
        self.entries.get_mut(range.first as usize..)?.get_mut(..range.count as usize)
    }

    /// Index of a new, empty node; `None` if the buffer is full.
    fn allocate_node(&mut self) -> Option<u32> {
        let index = self.node_count;
        *self.nodes.get_mut(index as usize)? = BvhNode::EMPTY;
        self.node_count += 1;
        Some(index)
    }
}

/// The range with the largest bounds of those that may be split, and its index.
fn largest_splittable(ranges: &[Option<ItemRange>]) -> Option<(usize, ItemRange)> {
    let mut largest: Option<(usize, ItemRange)> = None;
    for (index, range) in ranges.iter().enumerate().filter_map(|(index, range)| Some((index, (*range)?))) {
        let is_larger = largest.is_none_or(|(_, largest)| half_area(&range.aabb) > half_area(&largest.aabb));
        if !range.is_leaf && is_larger {
            largest = Some((index, range));
        }
    }
    largest
}
