//! An octree in parts, as a baked scene holds it.

use heapless::Vec;

use super::{Octree, OctreeNode, space};
use crate::geometry::Aabb;
use crate::math::morton;

/// Room for the blocks that wait, eight from each level at most.
const BLOCKS: usize = 8 * morton::BITS_PER_AXIS as usize;

/// What makes an octree, and nothing that follows from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OctreeParts<'s> {
    pub(crate) bounds: Aabb,
    pub(crate) nodes: &'s [OctreeNode],
    pub(crate) items: &'s [u32],
}

impl<'s, const MAILBOX: usize> Octree<'s, MAILBOX> {
    pub(crate) const fn parts(&self) -> OctreeParts<'s> {
        OctreeParts { bounds: self.bounds, nodes: self.nodes, items: self.items }
    }

    /// The octree of parts, for a scene of `count` items; none when an index is out of range or
    /// the nodes make no tree of at most the depth that a walk can hold.
    pub(crate) fn from_parts(parts: OctreeParts<'s>, count: u32) -> Option<Self> {
        let OctreeParts { bounds, nodes, items } = parts;
        let is_empty = nodes.is_empty() && items.is_empty();
        if !(items.iter().all(|item| *item < count) && (bounds.is_finite() || is_empty)) {
            return None;
        }
        let walls = space(if is_empty { Aabb::POINT } else { bounds });
        let (mut regions, mut depth) = (0, 0);

        // Blocks of eight that are still to be looked at, and their first node. A tree of n nodes
        // has fewer blocks: more are met only where two nodes share one.
        let mut blocks = Vec::<(u32, u8), BLOCKS>::new();
        let mut left = nodes.len() / 8;
        let mut node = |node: OctreeNode, above: u8, blocks: &mut Vec<(u32, u8), BLOCKS>| -> Option<()> {
            if !node.is_cut() {
                let content = items.get(node.first as usize..)?.get(..node.content as usize)?;
                regions += u32::from(!content.is_empty());
                depth = if above > depth { above } else { depth };
                return Some(());
            }
            left = left.checked_sub(1)?;
            if u32::from(above) >= morton::BITS_PER_AXIS {
                return None;
            }
            blocks.push((node.first, above + 1)).ok()
        };
        if let Some(root) = nodes.first() {
            node(*root, 0, &mut blocks)?;
        }
        while let Some((first, level)) = blocks.pop() {
            for child in nodes.get(first as usize..)?.get(..8)? {
                node(*child, level, &mut blocks)?;
            }
        }
        Some(Octree { bounds, walls, nodes, items, boxes: &[], regions, depth })
    }
}

impl OctreeNode {
    /// As it lies in memory.
    pub(crate) const fn words(self) -> [u32; 2] {
        [self.first, self.content]
    }
}
