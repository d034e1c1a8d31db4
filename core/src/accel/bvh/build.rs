//! Building, from the boxes of items to a hierarchy that can be walked.

use core::iter::from_fn;
use core::marker::PhantomData;

use super::grow::{Tree, grow};
use super::node::{Child, Goes, Node, Slot};
use super::{Bvh, BvhRoom, Run};
use crate::accel::{BuildError, Storage};
use crate::geometry::{Aabb, Geometry, ItemId};

/// A hierarchy that has been built and not been furnished: its leaves can be walked as they
/// are, or be laid out in runs.
#[derive(Debug)]
pub struct Grown<'s> {
    nodes: &'s mut [Node],
    items: &'s mut [Slot],
    depth: u32,
}

/// How the items of a leaf will be tested.
#[derive(Clone, Copy, Debug)]
pub enum Leaves<'g> {
    /// One after the other.
    Singly,
    /// The triangles among them four at once, in [`Run`]s.
    Runs(&'g Geometry<'g>),
}

impl Leaves<'_> {
    /// Whether an item is tested together with others.
    fn groups(self, item: ItemId) -> bool {
        match self {
            Leaves::Singly => false,
            Leaves::Runs(geometry) => geometry.shape(item).is_some_and(|shape| shape.is_triangle()),
        }
    }
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
        leaves: Leaves<'_>,
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
            *slot = Slot::of(item, leaves.groups(item));
        }

        let wanted = BvhRoom::comfortable(bounded).nodes;
        let budget = if wanted < nodes.len() { wanted } else { nodes.len() };
        let Tree { nodes, items, depth } = grow(boxes, nodes, items, budget as u32);
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
            Goes::Out(_) | Goes::Lone(_) => None,
        };
        let Some(node) = nodes.get(place) else { continue };
        // The last of the parts that has nodes of its own has the last of them.
        let end = node.children().filter_map(end_of).last().unwrap_or(place as u32 + 1);
        if let Some(node) = nodes.get_mut(place) {
            node.set_end(end);
        }
    }
}
