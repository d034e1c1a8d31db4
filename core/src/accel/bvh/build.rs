//! Construction of a BVH from the bounds of the items.

use core::iter::from_fn;
use core::marker::PhantomData;

use super::Bvh;
use super::node::{BvhEntry, BvhNode, NodeRef, PackedNodeRef};
use super::top_down::{BuiltTree, build_top_down};
use crate::accel::{Buffer, BuildError, BvhSize, TriangleBlock};
use crate::geometry::{Aabb, Geometry, ItemId};

/// A tree of items from which a [`Bvh`] is made, with single entries ([`BvhBuilder::into_bvh`]) or blocks
/// of triangles ([`BvhBuilder::into_block_bvh`]) in its leaves.
#[derive(Debug)]
pub struct BvhBuilder<'s> {
    nodes: &'s mut [BvhNode],
    entries: &'s mut [BvhEntry],
    depth: u32,
}

/// How the items of a leaf of a [`Bvh`] are stored and tested.
#[derive(Clone, Copy, Debug)]
pub enum LeafLayout<'g> {
    /// As single [`BvhEntry`]s, tested one after the other.
    Entries,
    /// In [`TriangleBlock`]s, whose triangles are tested four at a time. The geometry identifies the
    /// triangles.
    TriangleBlocks(&'g Geometry<'g>),
}

impl LeafLayout<'_> {
    /// Whether an item is tested together with others of its leaf.
    fn puts_in_block(self, item: ItemId) -> bool {
        match self {
            LeafLayout::Entries => false,
            LeafLayout::TriangleBlocks(geometry) => {
                geometry.shape(item).is_some_and(|shape| shape.is_triangle())
            }
        }
    }
}

impl<'s, Queue> Bvh<'s, Queue> {
    /// Builds the hierarchy of the items with these bounds, with single entries in its leaves.
    ///
    /// `bounds`: one box per item; items with an empty box are left out. `nodes` and `entries`:
    /// caller-provided buffers of the sizes of [`BvhSize::recommended`]. With fewer nodes, leaves are
    /// larger; at least one is needed unless all boxes are empty. One entry per item that is not left out
    /// is needed.
    ///
    /// # Errors
    ///
    /// * [`BuildError::BufferTooSmall`] for `nodes` or `entries`.
    /// * [`BuildError::NotFinite`] for a box that is not finite.
    pub fn build(
        bounds: &[Aabb],
        nodes: &'s mut [BvhNode],
        entries: &'s mut [BvhEntry],
    ) -> Result<Self, BuildError> {
        BvhBuilder::new(bounds, LeafLayout::Entries, nodes, entries).map(BvhBuilder::into_bvh)
    }
}

impl<'s> BvhBuilder<'s> {
    /// Builds the tree as [`Bvh::build`] does, for leaves with this layout: the layout determines which
    /// splits are expected to be cheap.
    ///
    /// # Errors
    ///
    /// Those of [`Bvh::build`].
    pub fn new(
        bounds: &[Aabb],
        layout: LeafLayout<'_>,
        nodes: &'s mut [BvhNode],
        entries: &'s mut [BvhEntry],
    ) -> Result<Self, BuildError> {
        let bounded_count = count_bounded(bounds)?;
        let min_nodes = usize::from(bounded_count > 0);
        if nodes.len() < min_nodes {
            return Err(too_small(Buffer::Nodes, min_nodes, nodes.len()));
        }
        let provided = entries.len();
        let entries =
            entries.get_mut(..bounded_count).ok_or(too_small(Buffer::Entries, bounded_count, provided))?;
        for (entry, item) in entries.iter_mut().zip(bounded_items(bounds)) {
            *entry = BvhEntry::new(item, layout.puts_in_block(item));
        }

        let recommended = BvhSize::recommended(bounded_count).nodes;
        let node_budget = if recommended < nodes.len() { recommended } else { nodes.len() };
        let BuiltTree { nodes, entries, depth } = build_top_down(bounds, nodes, entries, node_budget as u32);
        set_skip_links(nodes);
        Ok(BvhBuilder { nodes, entries, depth })
    }

    /// The hierarchy with single entries as leaf elements.
    pub fn into_bvh<Queue>(self) -> Bvh<'s, Queue> {
        let BvhBuilder { nodes, entries, depth } = self;
        Bvh { nodes, leaf_elements: entries, depth, queue: PhantomData }
    }

    /// Number of blocks that [`BvhBuilder::into_block_bvh`] needs.
    pub fn block_count(&self) -> usize {
        split_leaves(self.entries).map(|leaf| leaf.len().div_ceil(TriangleBlock::CAPACITY)).sum()
    }

    /// The hierarchy with blocks as leaf elements, for a builder with [`LeafLayout::TriangleBlocks`]. With
    /// [`LeafLayout::Entries`] it is valid too, but leaves are too small to fill the blocks.
    ///
    /// `geometry`: the one that the bounds were computed from, or items are missed. `blocks`: caller-provided buffer, at least
    /// [`BvhBuilder::block_count`] long.
    ///
    /// # Errors
    ///
    /// [`BuildError::BufferTooSmall`] for `blocks`.
    pub fn into_block_bvh<Queue>(
        self,
        geometry: &Geometry<'_>,
        blocks: &'s mut [TriangleBlock],
    ) -> Result<Bvh<'s, Queue, TriangleBlock>, BuildError> {
        let (needed, provided) = (self.block_count(), blocks.len());
        let BvhBuilder { nodes, entries, depth } = self;
        let blocks = blocks.get_mut(..needed).ok_or(too_small(Buffer::TriangleBlocks, needed, provided))?;
        let (mut block_count, mut unused) = (0, blocks.iter_mut());
        // In the order of the nodes, so that leaves visited together are near each other in memory.
        for node in nodes.iter_mut() {
            for child in 0..node.children().count() {
                let NodeRef::Leaf(first) = node.child(child).unpack() else { continue };
                let Some(leaf) = entries.get(first as usize..).and_then(|rest| split_leaves(rest).next())
                else {
                    continue;
                };
                node.set_child(child, PackedNodeRef::leaf(block_count));
                let chunks = leaf.chunks(TriangleBlock::CAPACITY);
                let mut blocks_left = chunks.len();
                for (chunk, block) in chunks.zip(&mut unused) {
                    blocks_left -= 1;
                    block_count += 1;
                    let items = chunk.iter().map(|entry| entry.item());
                    *block = TriangleBlock::new(geometry, items, blocks_left > 0);
                }
            }
        }
        Ok(Bvh { nodes, leaf_elements: blocks, depth, queue: PhantomData })
    }
}

const fn too_small(buffer: Buffer, needed: usize, provided: usize) -> BuildError {
    BuildError::BufferTooSmall { buffer, needed, provided }
}

/// The entries of one leaf after the other.
fn split_leaves(entries: &[BvhEntry]) -> impl Iterator<Item = &[BvhEntry]> {
    let mut rest = entries;
    from_fn(move || {
        let (leaf, others) = rest.split_at_checked(rest.iter().position(|entry| entry.is_last())? + 1)?;
        rest = others;
        Some(leaf)
    })
}

/// Number of items whose bounds are not empty.
fn count_bounded(bounds: &[Aabb]) -> Result<usize, BuildError> {
    if bounds.len() > BvhEntry::MAX_ITEMS {
        return Err(too_small(Buffer::Entries, bounds.len(), BvhEntry::MAX_ITEMS));
    }
    let mut count = 0;
    for (aabb, index) in bounds.iter().zip(0..).filter(|(aabb, _)| !aabb.is_empty()) {
        if !(aabb.min.is_finite() && aabb.max.is_finite()) {
            return Err(BuildError::NotFinite { item: ItemId(index) });
        }
        count += 1;
    }
    Ok(count)
}

/// The items whose bounds are not empty.
fn bounded_items(bounds: &[Aabb]) -> impl Iterator<Item = ItemId> + '_ {
    bounds.iter().zip(0..).filter(|(aabb, _)| !aabb.is_empty()).map(|(_, index)| ItemId(index))
}

/// Sets the skip link of every node, from the last to the first.
fn set_skip_links(nodes: &mut [BvhNode]) {
    for index in (0..nodes.len()).rev() {
        let skip_link_of = |child: PackedNodeRef| match child.unpack() {
            NodeRef::Inner(inner) => nodes.get(inner as usize).map(BvhNode::skip_link),
            NodeRef::Leaf(_) | NodeRef::Item(_) => None,
        };
        let Some(node) = nodes.get(index) else { continue };
        // The subtree ends with that of its last inner child.
        let skip_link = node.children().filter_map(skip_link_of).last().unwrap_or(index as u32 + 1);
        if let Some(node) = nodes.get_mut(index) {
            node.set_skip_link(skip_link);
        }
    }
}
