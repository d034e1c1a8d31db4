//! Building an octree in one walk over the codes of its nodes, in their order.
//!
//! The lists of finished leaves stand at the front of the lent entries; the lists of nodes that
//! wait stand at its back, in the order in which their turn comes. A node whose turn it is becomes
//! a leaf, and its list moves to the front; or it is cut, and eight lists take the place of its
//! own. The next node is the one whose code is one more: where the last of eight siblings is done,
//! that addition carries into the parent's code, and the walk is one level higher. So there is
//! no stack but the place of one block for each level.

use super::{Octree, OctreeNode, space};
use crate::accel::cell_planes::{CellPlanes, bounds_of_all};
use crate::accel::{BuildError, Storage};
use crate::geometry::Aabb;
use crate::math::{Real, Vec3, morton, vec3};

/// How far an octree is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OctreeLimits {
    /// How often space is cut, at most; more than 21 is taken for 21.
    pub depth: u8,
    /// A leaf with at most so many items is not cut.
    pub leaf: u32,
}

impl OctreeLimits {
    /// What is good for most scenes. On the standard procedural databases leaves of 8, 12, 16 and
    /// 24 items take times within 5 % of each other, leaves of 4 up to 8 % more; memory halves from
    /// 8 to 16. The depth ends where cutting does not pay: 5 to 16 there, 13 for 597,872 spheres of
    /// a sphereflake, which take 2.2 times as long as 7,382.
    pub const DEFAULT: OctreeLimits = OctreeLimits { depth: morton::BITS_PER_AXIS as u8, leaf: 12 };
}

/// A cut pays when the lists of the children hold at most this many times the items of the
/// parent's.
const MOST_GROWTH: u64 = 3;

/// How much memory an octree takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OctreeRoom {
    /// Nodes: one, and eight for each node that is cut.
    pub nodes: usize,
    /// Entries: one for each item in each leaf that it touches, and room to cut the root.
    pub items: usize,
}

impl OctreeRoom {
    /// What is comfortable for `items` items. With less, leaves are larger; the floor is one node
    /// and as many entries as items.
    pub const fn comfortable(items: usize) -> Self {
        OctreeRoom { nodes: items * 4 + 1, items: items * 8 }
    }
}

impl<'s, const MAILBOX: usize> Octree<'s, MAILBOX> {
    /// The octree of the items inside `boxes`, one box for each, in their order. Empty boxes
    /// ([`Aabb::EMPTY`]) have no place in it.
    ///
    /// `nodes` and `entries` are lent: as many as [`OctreeRoom::comfortable`] says, or fewer, for
    /// larger leaves. At least one node, and as many entries as there are items that have a place,
    /// or [`BuildError::StorageTooSmall`] says so.
    pub fn build(
        boxes: &'s [Aabb],
        nodes: &'s mut [OctreeNode],
        entries: &'s mut [u32],
    ) -> Result<Self, BuildError> {
        Self::with_limits(OctreeLimits::DEFAULT, boxes, nodes, entries)
    }

    /// The same, cut as far as `limits` say.
    pub fn with_limits(
        limits: OctreeLimits,
        boxes: &'s [Aabb],
        nodes: &'s mut [OctreeNode],
        entries: &'s mut [u32],
    ) -> Result<Self, BuildError> {
        let (bounds, items) = bounds_of_all(boxes)?;
        let too_small = |what, needed, lent| BuildError::StorageTooSmall { what, needed, lent };
        if nodes.is_empty() {
            return Err(too_small(Storage::Nodes, 1, 0));
        }
        if entries.len() < items {
            return Err(too_small(Storage::Items, items, entries.len()));
        }
        if items == 0 {
            let bounds = Aabb::EMPTY;
            let walls = space(Aabb { min: Vec3::ZERO, max: Vec3::ZERO });
            return Ok(Octree { bounds, walls, nodes: &[], items: &[], boxes: &[], regions: 0, depth: 0 });
        }
        let walls = space(bounds);
        let work = Work {
            boxes,
            walls,
            limits,
            back: entries.len(),
            nodes,
            entries,
            front: 0,
            used: 1,
            regions: 0,
            depth: 0,
        };
        let Done { nodes, items, regions, depth } = work.run();
        Ok(Octree { bounds, walls, nodes, items, boxes, regions, depth })
    }
}

/// What is done and what waits.
struct Work<'b, 's> {
    boxes: &'b [Aabb],
    walls: CellPlanes,
    limits: OctreeLimits,
    nodes: &'s mut [OctreeNode],
    entries: &'s mut [u32],
    /// Up to here are the lists of leaves.
    front: usize,
    /// From here on are the lists that wait.
    back: usize,
    /// How many nodes are in use.
    used: usize,
    regions: u32,
    depth: u8,
}

/// What has been built.
struct Done<'s> {
    nodes: &'s [OctreeNode],
    items: &'s [u32],
    regions: u32,
    depth: u8,
}

impl<'s> Work<'_, 's> {
    fn run(mut self) -> Done<'s> {
        // All items wait in the list of the root.
        let placed = self.boxes.iter().zip(0_u32..).filter(|(aabb, _)| !aabb.is_empty());
        let count = placed.clone().count();
        self.back = self.entries.len().saturating_sub(count);
        for (entry, (_, item)) in self.entries.iter_mut().skip(self.back).zip(placed) {
            *entry = item;
        }
        self.put(0, OctreeNode { first: 0, content: count as u32 });

        let mut blocks = [0_usize; morton::BITS_PER_AXIS as usize + 1];
        let (mut code, mut level): (morton::MortonCode, usize) = (0, 0);
        loop {
            let block = blocks.get(level).copied().unwrap_or(0);
            let place = block + if level == 0 { 0 } else { code as usize & 7 };
            if let Some(children) = self.cut(place, code, level) {
                level += 1;
                code <<= 3;
                if let Some(block) = blocks.get_mut(level) {
                    *block = children;
                }
                continue;
            }
            self.finish(place, level);
            // The next sibling, or the next one of the parent, ...
            code += 1;
            while level > 0 && code & 7 == 0 {
                code >>= 3;
                level -= 1;
            }
            if level == 0 {
                break;
            }
        }
        let Work { nodes, entries, front, used, regions, depth, .. } = self;
        let (nodes, entries): (&[OctreeNode], &[u32]) = (nodes, entries);
        Done {
            nodes: nodes.get(..used).unwrap_or(&[]),
            items: entries.get(..front).unwrap_or(&[]),
            regions,
            depth,
        }
    }

    fn put(&mut self, place: usize, node: OctreeNode) {
        if let Some(there) = self.nodes.get_mut(place) {
            *there = node;
        }
    }

    /// Copies a list of entries to where it may cover its old place.
    fn copy(&mut self, from: usize, to: usize, count: usize) {
        let mut one = |i: usize| {
            let entry = self.entries.get(from + i).copied().unwrap_or(0);
            if let Some(place) = self.entries.get_mut(to + i) {
                *place = entry;
            }
        };
        if to < from {
            (0..count).for_each(&mut one);
        } else {
            (0..count).rev().for_each(&mut one);
        }
    }

    /// How many items wait in the list of the node whose turn it is.
    fn waiting(&self, place: usize) -> usize {
        self.nodes.get(place).map_or(0, |node| node.content as usize)
    }

    /// Makes a leaf of the node whose turn it is.
    fn finish(&mut self, place: usize, level: usize) {
        let count = self.waiting(place);
        self.copy(self.back, self.front, count);
        self.put(place, OctreeNode { first: self.front as u32, content: count as u32 });
        self.front += count;
        self.back += count;
        self.regions += u32::from(count > 0);
        if level > usize::from(self.depth) {
            self.depth = level as u8;
        }
    }

    /// Cuts the node whose turn it is, if that pays and there is memory; answers the place of its
    /// first child.
    fn cut(&mut self, place: usize, code: morton::MortonCode, level: usize) -> Option<usize> {
        let deepest = usize::from(self.limits.depth).min(morton::BITS_PER_AXIS as usize);
        let count = self.waiting(place);
        if level >= deepest || count <= self.limits.leaf as usize {
            return None;
        }
        let middle = self.walls.position(middle(code, level));
        let list = self.back..self.back + count;
        let mut counts = [0_usize; 8];
        for item in self.entries.get(list.clone())? {
            let octants = self.octants(*item, middle);
            for (count, octant) in counts.iter_mut().zip(0..) {
                *count += (octants >> octant & 1) as usize;
            }
        }
        let total: usize = counts.iter().sum();
        if !self.pays(count, total) {
            return None;
        }

        // The new lists, below the old one: the last child's nearest to it.
        let low = self.back - total;
        let mut ends = [0_usize; 8];
        let mut end = low;
        for (place, count) in ends.iter_mut().zip(counts) {
            *place = end;
            end += count;
        }
        for from in list {
            let item = *self.entries.get(from)?;
            let octants = self.octants(item, middle);
            for (place, octant) in ends.iter_mut().zip(0..) {
                if octants >> octant & 1 == 1 {
                    if let Some(entry) = self.entries.get_mut(*place) {
                        *entry = item;
                    }
                    *place += 1;
                }
            }
        }
        self.copy(low, low + count, total);
        self.back = low + count;

        let children = self.used;
        self.used += 8;
        let mut occupied = 0;
        for (count, octant) in counts.into_iter().zip(0..) {
            self.put(children + octant, OctreeNode { first: 0, content: count as u32 });
            occupied |= u32::from(count > 0) << octant;
        }
        self.put(place, OctreeNode { first: children as u32, content: OctreeNode::CUT | occupied });
        Some(children)
    }

    /// Whether cutting a list of `count` items into lists of `total` pays, and its share of what
    /// is left of the memory is enough: as large as its share of what waits, so that too little
    /// memory makes all leaves larger and not the last ones only.
    fn pays(&self, count: usize, total: usize) -> bool {
        let gap = self.back.saturating_sub(self.front);
        let nodes = self.nodes.len().saturating_sub(self.used);
        if total > gap || nodes < 8 {
            return false;
        }
        let waiting = (self.entries.len() - self.back) as u64;
        let (count, total, gap, nodes) = (count as u64, total as u64, gap as u64, nodes as u64);
        let growth = total.saturating_sub(count);
        total <= MOST_GROWTH * count && growth * waiting <= gap * count && 8 * waiting <= nodes * count
    }

    /// Which children of a node with its `middle` there an item's box touches, a bit for each.
    #[inline]
    fn octants(&self, item: u32, middle: Vec3) -> u32 {
        let Some(aabb) = self.boxes.get(item as usize) else { return 0 };
        // A box that only touches the wall is on one side of it, or scenes that are laid out like
        // an octree would have everything in all halves. Bit i of each is set where that half along
        // the axis belongs to child i.
        const LOW: [u32; 3] = [0b0101_0101, 0b0011_0011, 0b0000_1111];
        let halves = |low: Real, high: Real, middle: Real, [near, far]: [u32; 2]| {
            (if low < middle || high <= middle { near } else { 0 }) | (if high > middle { far } else { 0 })
        };
        halves(aabb.min.x, aabb.max.x, middle.x, [LOW[0], !LOW[0] & 255])
            & halves(aabb.min.y, aabb.max.y, middle.y, [LOW[1], !LOW[1] & 255])
            & halves(aabb.min.z, aabb.max.z, middle.z, [LOW[2], !LOW[2] & 255])
    }
}

/// The numbers of the walls in the middle of a node.
fn middle(code: morton::MortonCode, level: usize) -> Vec3 {
    let below = morton::BITS_PER_AXIS - level as u32;
    let wall = |number: u32| ((2 * number + 1) << below >> 1) as Real;
    let [x, y, z] = morton::deinterleave(code);
    vec3(wall(x), wall(y), wall(z))
}
