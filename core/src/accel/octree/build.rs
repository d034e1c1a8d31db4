//! Construction of an octree in one pass over its nodes, in the order of their Morton codes.
//!
//! The lists of finished leaves are at the front of the caller-provided entries. The lists of pending nodes
//! are at the back, in the order in which the nodes follow. The next pending node becomes a leaf, and its
//! list moves to the front; or it is subdivided, and the lists of its eight children replace its own. The
//! next node is the one with the next code: after the last of eight siblings, the addition carries into the
//! code of the parent, and the construction continues one level higher. So the only stack is the index of the
//! current group of siblings on each level.

use super::{Octree, OctreeNode, octree_planes};
use crate::accel::cell_planes::{CellPlanes, bounds_of_all};
use crate::accel::{Buffer, BuildError, OctreeLimits};
use crate::geometry::Aabb;
use crate::math::{Real, Vec3, morton, vec3};

/// A node is subdivided only if the lists of its children hold at most this many times the entries of its own
/// list.
const MAX_ENTRY_GROWTH: u64 = 3;

impl<'s, const MAILBOX_ENTRIES: usize> Octree<'s, MAILBOX_ENTRIES> {
    /// Builds the octree of the items with these bounds, with [`OctreeLimits::DEFAULT`].
    ///
    /// `bounds`: one box per item; items with an empty box ([`Aabb::EMPTY`]) are left out. `nodes` and
    /// `entries`: caller-provided buffers of the sizes of [`OctreeSize::recommended`]. With smaller ones,
    /// leaves are larger; at least one node is needed, and one entry per item that is not left out.
    ///
    /// # Errors
    ///
    /// * [`BuildError::BufferTooSmall`] for `nodes` or `entries`.
    /// * [`BuildError::NotFinite`] for a box that is not finite.
    ///
    /// [`OctreeSize::recommended`]: crate::accel::OctreeSize::recommended
    pub fn build(
        bounds: &'s [Aabb],
        nodes: &'s mut [OctreeNode],
        entries: &'s mut [u32],
    ) -> Result<Self, BuildError> {
        Self::build_with_limits(OctreeLimits::DEFAULT, bounds, nodes, entries)
    }

    /// Builds the octree as [`Octree::build`] does, with these limits.
    ///
    /// # Errors
    ///
    /// Those of [`Octree::build`].
    pub fn build_with_limits(
        limits: OctreeLimits,
        bounds: &'s [Aabb],
        nodes: &'s mut [OctreeNode],
        entries: &'s mut [u32],
    ) -> Result<Self, BuildError> {
        let (all_bounds, items) = bounds_of_all(bounds)?;
        if nodes.is_empty() {
            return Err(too_small(Buffer::Nodes, 1, 0));
        }
        if entries.len() < items {
            return Err(too_small(Buffer::Entries, items, entries.len()));
        }
        if items == 0 {
            return Ok(Octree {
                bounds: Aabb::EMPTY,
                planes: octree_planes(Aabb { min: Vec3::ZERO, max: Vec3::ZERO }),
                nodes: &[],
                entries: &[],
                item_bounds: &[],
                occupied_leaves: 0,
                depth: 0,
            });
        }
        let planes = octree_planes(all_bounds);
        let builder = OctreeBuilder {
            bounds,
            planes,
            limits,
            pending_begin: entries.len(),
            nodes,
            entries,
            finished_end: 0,
            node_count: 1,
            occupied_leaves: 0,
            depth: 0,
        };
        let BuiltOctree { nodes, entries, occupied_leaves, depth } = builder.build();
        Ok(Octree { bounds: all_bounds, planes, nodes, entries, item_bounds: bounds, occupied_leaves, depth })
    }
}

const fn too_small(buffer: Buffer, needed: usize, provided: usize) -> BuildError {
    BuildError::BufferTooSmall { buffer, needed, provided }
}

/// The state of the construction.
struct OctreeBuilder<'b, 's> {
    bounds: &'b [Aabb],
    planes: CellPlanes,
    limits: OctreeLimits,
    nodes: &'s mut [OctreeNode],
    entries: &'s mut [u32],
    /// End of the lists of finished leaves in `entries`.
    finished_end: usize,
    /// Begin of the lists of pending nodes in `entries`.
    pending_begin: usize,
    node_count: usize,
    /// Number of leaves with entries.
    occupied_leaves: u32,
    depth: u8,
}

/// The result of [`OctreeBuilder::build`].
struct BuiltOctree<'s> {
    nodes: &'s [OctreeNode],
    entries: &'s [u32],
    occupied_leaves: u32,
    depth: u8,
}

impl<'s> OctreeBuilder<'_, 's> {
    fn build(mut self) -> BuiltOctree<'s> {
        // All items are pending in the list of the root.
        let bounded = self.bounds.iter().zip(0_u32..).filter(|(aabb, _)| !aabb.is_empty());
        let count = bounded.clone().count();
        self.pending_begin = self.entries.len().saturating_sub(count);
        for (entry, (_, item)) in self.entries.iter_mut().skip(self.pending_begin).zip(bounded) {
            *entry = item;
        }
        self.set_node(0, OctreeNode { first: 0, content: count as u32 });

        // Per level, the index of the first of the current siblings.
        let mut first_siblings = [0_usize; morton::BITS_PER_AXIS as usize + 1];
        let (mut code, mut level): (morton::MortonCode, usize) = (0, 0);
        loop {
            let first_sibling = first_siblings.get(level).copied().unwrap_or(0);
            let index = first_sibling + if level == 0 { 0 } else { code as usize & 7 };
            if let Some(first_child) = self.subdivide(index, code, level) {
                level += 1;
                code <<= 3;
                if let Some(first_sibling) = first_siblings.get_mut(level) {
                    *first_sibling = first_child;
                }
                continue;
            }
            self.make_leaf(index, level);
            // The next sibling, or that of the nearest ancestor that has one.
            code += 1;
            while level > 0 && code & 7 == 0 {
                code >>= 3;
                level -= 1;
            }
            if level == 0 {
                break;
            }
        }
        let OctreeBuilder { nodes, entries, finished_end, node_count, occupied_leaves, depth, .. } = self;
        let (nodes, entries): (&[OctreeNode], &[u32]) = (nodes, entries);
        BuiltOctree {
            nodes: nodes.get(..node_count).unwrap_or(&[]),
            entries: entries.get(..finished_end).unwrap_or(&[]),
            occupied_leaves,
            depth,
        }
    }

    fn set_node(&mut self, index: usize, node: OctreeNode) {
        if let Some(target) = self.nodes.get_mut(index) {
            *target = node;
        }
    }

    /// Copies `count` entries; source and target may overlap.
    fn copy_entries(&mut self, from: usize, to: usize, count: usize) {
        let mut copy_one = |i: usize| {
            let source = self.entries.get(from + i).copied().unwrap_or(0);
            if let Some(target) = self.entries.get_mut(to + i) {
                *target = source;
            }
        };
        if to < from {
            (0..count).for_each(&mut copy_one);
        } else {
            (0..count).rev().for_each(&mut copy_one);
        }
    }

    /// Number of entries in the list of a pending node.
    fn pending_entries(&self, index: usize) -> usize {
        self.nodes.get(index).map_or(0, |node| node.content as usize)
    }

    /// Makes the first pending node a leaf.
    fn make_leaf(&mut self, index: usize, level: usize) {
        let count = self.pending_entries(index);
        self.copy_entries(self.pending_begin, self.finished_end, count);
        self.set_node(index, OctreeNode { first: self.finished_end as u32, content: count as u32 });
        self.finished_end += count;
        self.pending_begin += count;
        self.occupied_leaves += u32::from(count > 0);
        if level > usize::from(self.depth) {
            self.depth = level as u8;
        }
    }

    /// Subdivides the first pending node and returns the index of its first child; `None` if that is not
    /// worth it, or the limits or buffers do not allow it.
    fn subdivide(&mut self, index: usize, code: morton::MortonCode, level: usize) -> Option<usize> {
        let max_depth = usize::from(self.limits.max_depth).min(morton::BITS_PER_AXIS as usize);
        let count = self.pending_entries(index);
        if level >= max_depth || count <= self.limits.max_leaf_items as usize {
            return None;
        }
        let center = self.planes.position(center_planes(code, level));
        let list = self.pending_begin..self.pending_begin + count;
        let mut counts = [0_usize; 8];
        for item in self.entries.get(list.clone())? {
            let octants = self.overlapped_octants(*item, center);
            for (count, octant) in counts.iter_mut().zip(0..) {
                *count += (octants >> octant & 1) as usize;
            }
        }
        let total: usize = counts.iter().sum();
        if !self.is_worth_subdividing(count, total) {
            return None;
        }

        // The lists of the children, written before that of the node in ascending order, then moved to its
        // end.
        let begin = self.pending_begin - total;
        let mut ends = [0_usize; 8];
        let mut end = begin;
        for (child_end, count) in ends.iter_mut().zip(counts) {
            *child_end = end;
            end += count;
        }
        for from in list {
            let item = *self.entries.get(from)?;
            let octants = self.overlapped_octants(item, center);
            for (child_end, octant) in ends.iter_mut().zip(0..) {
                if octants >> octant & 1 == 1 {
                    if let Some(entry) = self.entries.get_mut(*child_end) {
                        *entry = item;
                    }
                    *child_end += 1;
                }
            }
        }
        self.copy_entries(begin, begin + count, total);
        self.pending_begin = begin + count;

        let first_child = self.node_count;
        self.node_count += 8;
        let mut occupied = 0;
        for (count, octant) in counts.into_iter().zip(0..) {
            self.set_node(first_child + octant, OctreeNode { first: 0, content: count as u32 });
            occupied |= u32::from(count > 0) << octant;
        }
        let content = OctreeNode::INNER_BIT | occupied;
        self.set_node(index, OctreeNode { first: first_child as u32, content });
        Some(first_child)
    }

    /// Whether subdividing a list of `count` entries into lists of `total` entries is worth it and fits into
    /// the list's share of the free memory.
    ///
    /// The share is the list's fraction of all pending entries, so that too little memory makes all leaves
    /// larger and not only the last ones.
    fn is_worth_subdividing(&self, count: usize, total: usize) -> bool {
        let free = self.pending_begin.saturating_sub(self.finished_end);
        let free_nodes = self.nodes.len().saturating_sub(self.node_count);
        if total > free || free_nodes < 8 {
            return false;
        }
        let pending = (self.entries.len() - self.pending_begin) as u64;
        let (count, total, free, free_nodes) = (count as u64, total as u64, free as u64, free_nodes as u64);
        let growth = total.saturating_sub(count);
        total <= MAX_ENTRY_GROWTH * count
            && growth * pending <= free * count
            && 8 * pending <= free_nodes * count
    }

    /// The children of a node that the bounds of an item overlap, one bit per child. `center`: of the node.
    ///
    /// Bounds that only touch a center plane are on one side of it. Otherwise, items that are aligned to the
    /// octree would be listed on both sides everywhere.
    #[inline]
    fn overlapped_octants(&self, item: u32, center: Vec3) -> u32 {
        let Some(aabb) = self.bounds.get(item as usize) else { return 0 };
        // Per axis, a bit for each child in the lower half.
        const LOWER: [u32; 3] = [0b0101_0101, 0b0011_0011, 0b0000_1111];
        let halves = |min: Real, max: Real, center: Real, [lower, upper]: [u32; 2]| {
            (if min < center || max <= center { lower } else { 0 }) | (if max > center { upper } else { 0 })
        };
        halves(aabb.min.x, aabb.max.x, center.x, [LOWER[0], !LOWER[0] & 255])
            & halves(aabb.min.y, aabb.max.y, center.y, [LOWER[1], !LOWER[1] & 255])
            & halves(aabb.min.z, aabb.max.z, center.z, [LOWER[2], !LOWER[2] & 255])
    }
}

/// Indices of the cell planes through the center of a node.
fn center_planes(code: morton::MortonCode, level: usize) -> Vec3 {
    let levels_below = morton::BITS_PER_AXIS - level as u32;
    let center = |coordinate: u32| ((2 * coordinate + 1) << levels_below >> 1) as Real;
    let [x, y, z] = morton::deinterleave(code);
    vec3(center(x), center(y), center(z))
}
