//! Conversion between an octree and the tables of a baked scene.

use heapless::Vec;

use super::{Octree, OctreeNode, octree_planes};
use crate::geometry::Aabb;
use crate::math::morton;

/// Capacity for the groups of siblings that are still to be checked: at most eight per level.
const MAX_PENDING_GROUPS: usize = 8 * morton::BITS_PER_AXIS as usize;

/// The data of an octree that a baked scene stores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OctreeParts<'s> {
    pub(crate) bounds: Aabb,
    pub(crate) nodes: &'s [OctreeNode],
    pub(crate) entries: &'s [u32],
}

impl<'s, const MAILBOX_ENTRIES: usize> Octree<'s, MAILBOX_ENTRIES> {
    pub(crate) const fn parts(&self) -> OctreeParts<'s> {
        OctreeParts { bounds: self.bounds, nodes: self.nodes, entries: self.entries }
    }

    /// The octree of these parts, for a scene of `count` items. `None` if an index is out of range, or the
    /// nodes are not a tree of at most the largest depth.
    pub(crate) fn from_parts(parts: OctreeParts<'s>, count: u32) -> Option<Self> {
        let OctreeParts { bounds, nodes, entries } = parts;
        let is_empty = nodes.is_empty() && entries.is_empty();
        if !(entries.iter().all(|item| *item < count) && (bounds.is_finite() || is_empty)) {
            return None;
        }
        let planes = octree_planes(if is_empty { Aabb::ORIGIN } else { bounds });
        let (mut occupied_leaves, mut depth) = (0, 0);

        // Groups of siblings that are still to be checked: index of the first node, and level. A tree has one
        // group per eight nodes; more are reached only if two nodes share one.
        let mut pending = Vec::<(u32, u8), MAX_PENDING_GROUPS>::new();
        let mut groups_left = nodes.len() / 8;
        let mut check =
            |node: OctreeNode, level: u8, pending: &mut Vec<(u32, u8), MAX_PENDING_GROUPS>| -> Option<()> {
                if !node.is_inner() {
                    let list = entries.get(node.first as usize..)?.get(..node.content as usize)?;
                    occupied_leaves += u32::from(!list.is_empty());
                    depth = if level > depth { level } else { depth };
                    return Some(());
                }
                groups_left = groups_left.checked_sub(1)?;
                if u32::from(level) >= morton::BITS_PER_AXIS {
                    return None;
                }
                pending.push((node.first, level + 1)).ok()
            };
        if let Some(root) = nodes.first() {
            check(*root, 0, &mut pending)?;
        }
        while let Some((first, level)) = pending.pop() {
            for child in nodes.get(first as usize..)?.get(..8)? {
                check(*child, level, &mut pending)?;
            }
        }
        Some(Octree { bounds, planes, nodes, entries, item_bounds: &[], occupied_leaves, depth })
    }
}

impl OctreeNode {
    /// The node as it is stored in a baked scene.
    pub(crate) const fn words(self) -> [u32; 2] {
        [self.first, self.content]
    }
}
