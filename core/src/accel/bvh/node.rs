//! BVH nodes: the bounds of up to four children side by side, and a reference to each child.

use crate::geometry::{Aabb, ItemId, Ray, WIDEN};
use crate::math::{Real, Real4, SIMD_WIDTH};

/// Largest number of children of a node.
pub(super) const CHILDREN: usize = SIMD_WIDTH;

/// An inner node of a [`Bvh`](super::Bvh) with up to four children: holds their bounds and references to
/// them.
///
/// A child is another node, a leaf of several items, or a single item. A node does not hold its own bounds;
/// its parent does.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct BvhNode {
    /// Per axis, the lower planes and then the upper planes of all children, so that one test serves all of
    /// them. An unused child has the bounds of [`Aabb::EMPTY`], which no ray hits.
    bounds: [[Real4; 2]; 3],
    children: [PackedNodeRef; CHILDREN],
    /// Index of the first node after the subtree.
    skip_link: u32,
    /// Completes two cache lines.
    padding: [u32; 3],
}

#[cfg(not(feature = "double"))]
const _: () = assert!(size_of::<BvhNode>() == 128);

/// A [`NodeRef`] in 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(transparent)]
pub struct PackedNodeRef(u32);

/// A child of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NodeRef {
    /// Index of an inner node.
    Inner(u32),
    /// Index of the first element of a leaf.
    Leaf(u32),
    /// The only item of a leaf, which is stored in the node itself.
    Item(ItemId),
}

/// Of a [`PackedNodeRef`]: set for leaves. Of a [`BvhEntry`]: set for the last item of a leaf.
const LEAF_BIT: u32 = 1 << 31;

/// Of a [`PackedNodeRef`] with [`LEAF_BIT`]: set if the leaf is a single item.
const ITEM_BIT: u32 = 1 << 30;

impl PackedNodeRef {
    /// An unused child. Its value is valid in every hierarchy.
    const EMPTY: PackedNodeRef = PackedNodeRef::item(ItemId(0));

    pub(super) const fn inner(index: u32) -> Self {
        PackedNodeRef(index & !LEAF_BIT)
    }

    pub(super) const fn leaf(first: u32) -> Self {
        PackedNodeRef(first & !ITEM_BIT | LEAF_BIT)
    }

    pub(super) const fn item(item: ItemId) -> Self {
        PackedNodeRef(item.0 | LEAF_BIT | ITEM_BIT)
    }

    #[inline(always)]
    pub(super) const fn unpack(self) -> NodeRef {
        let index = self.0 & !(LEAF_BIT | ITEM_BIT);
        match (self.0 & LEAF_BIT, self.0 & ITEM_BIT) {
            (0, _) => NodeRef::Inner(self.0),
            (_, 0) => NodeRef::Leaf(index),
            _ => NodeRef::Item(ItemId(index)),
        }
    }
}

/// Of a [`BvhEntry`] during construction: set if the item will be in a block.
const BLOCK_BIT: u32 = 1 << 30;

/// An item in a leaf of a [`Bvh`](super::Bvh), with a mark for the last item of the leaf.
///
/// Ids have 30 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(transparent)]
pub struct BvhEntry(u32);

impl BvhEntry {
    /// The initial value for buffers.
    pub const EMPTY: BvhEntry = BvhEntry(LEAF_BIT);
    /// Largest number of items of a hierarchy.
    pub(super) const MAX_ITEMS: usize = BLOCK_BIT as usize;

    /// The entry as it is stored in a baked scene.
    #[cfg(feature = "baked")]
    pub(crate) const fn word(self) -> u32 {
        self.0
    }

    pub(super) const fn new(item: ItemId, is_in_block: bool) -> Self {
        BvhEntry(item.0 & !(LEAF_BIT | BLOCK_BIT) | if is_in_block { BLOCK_BIT } else { 0 })
    }

    /// Whether the item will be tested in a block, together with others of its leaf. Valid during
    /// construction only.
    pub(super) const fn is_in_block(self) -> bool {
        self.0 & BLOCK_BIT != 0
    }

    pub(super) const fn mark_last(&mut self) {
        self.0 |= LEAF_BIT;
    }

    #[inline(always)]
    pub(super) const fn item(self) -> ItemId {
        ItemId(self.0 & !(LEAF_BIT | BLOCK_BIT))
    }

    #[inline(always)]
    pub(super) const fn is_last(self) -> bool {
        self.0 & LEAF_BIT != 0
    }
}

/// Ray data for the tests of nodes, broadcast to all children.
#[derive(Clone, Copy, Debug)]
pub(super) struct TraversalRay([TraversalAxis; 3]);

/// One axis of a [`TraversalRay`].
#[derive(Clone, Copy, Debug)]
struct TraversalAxis {
    origin: Real4,
    inverse: Real4,
    /// Whether the direction is negative: the ray enters a box through its upper plane.
    is_negative: bool,
}

impl TraversalRay {
    pub(super) fn new(ray: &Ray) -> Self {
        let axis = |origin, inverse| TraversalAxis {
            origin: Real4::splat(origin),
            inverse: Real4::splat(inverse),
            is_negative: !(inverse >= 0.0),
        };
        let (o, i) = (ray.origin, ray.inverse_direction);
        TraversalRay([axis(o.x, i.x), axis(o.y, i.y), axis(o.z, i.z)])
    }
}

/// Result of the test of a ray against the bounds of all children of a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoxHits {
    /// The `t` at which the ray enters each box; zero if its origin is inside.
    pub(super) t_entry: Real4,
    /// One bit per child: set if the ray enters its box within `t_max`.
    pub(super) mask: u32,
}

impl BvhNode {
    /// A node without children, the initial value for buffers.
    pub const EMPTY: BvhNode = BvhNode {
        bounds: [[Real4::splat(Real::INFINITY), Real4::splat(Real::NEG_INFINITY)]; 3],
        children: [PackedNodeRef::EMPTY; CHILDREN],
        skip_link: 0,
        padding: [0; 3],
    };

    /// Sets the bounds of a child; does nothing if `child` is not below [`CHILDREN`].
    pub(super) fn set_bounds(&mut self, child: usize, aabb: &Aabb) {
        let (min, max) = (aabb.min.to_array(), aabb.max.to_array());
        for (planes, (min, max)) in self.bounds.iter_mut().zip(min.into_iter().zip(max)) {
            for (lanes, plane) in planes.iter_mut().zip([min, max]) {
                if let Some(element) = lanes.0.get_mut(child) {
                    *element = plane;
                }
            }
        }
    }

    /// The node as it is stored in a baked scene.
    #[cfg(feature = "baked")]
    pub(crate) fn words(&self) -> [u32; 32] {
        let mut words = [0; 32];
        let planes = self.bounds.iter().flatten().flat_map(|lanes| lanes.0).map(f32::to_bits);
        let rest = self.children.iter().map(|child| child.0).chain([self.skip_link]);
        for (word, value) in words.iter_mut().zip(planes.chain(rest)) {
            *word = value;
        }
        words
    }

    /// All four children, unused ones included.
    #[cfg(feature = "baked")]
    pub(super) const fn all_children(&self) -> [PackedNodeRef; CHILDREN] {
        self.children
    }

    /// The children in use.
    pub(super) fn children(&self) -> impl Iterator<Item = PackedNodeRef> + '_ {
        let [[min, max], ..] = &self.bounds;
        let is_used = min.0.iter().zip(&max.0).map(|(min, max)| min <= max);
        self.children.iter().zip(is_used).filter(|(_, is_used)| *is_used).map(|(child, _)| *child)
    }

    #[inline(always)]
    pub(super) fn child(&self, index: usize) -> PackedNodeRef {
        self.children.get(index).copied().unwrap_or(PackedNodeRef::EMPTY)
    }

    pub(super) fn set_child(&mut self, index: usize, node: PackedNodeRef) {
        if let Some(child) = self.children.get_mut(index) {
            *child = node;
        }
    }

    #[inline(always)]
    pub(super) const fn skip_link(&self) -> u32 {
        self.skip_link
    }

    pub(super) const fn set_skip_link(&mut self, index: u32) {
        self.skip_link = index;
    }

    /// Tests the ray against the bounds of all children.
    ///
    /// It does the operations of [`Aabb::intersect`] in the same order, so that each `t_entry` is the same,
    /// bit for bit, except that negative ones become zero.
    #[inline(always)]
    pub(super) fn intersect(&self, ray: &TraversalRay, t_max: Real) -> BoxHits {
        let (mut t_entry, mut t_exit) = (Real4::splat(0.0), Real4::splat(Real::MAX));
        for (planes, axis) in self.bounds.iter().zip(&ray.0) {
            #[expect(clippy::indexing_slicing, reason = "0 or 1, of two")]
            let (near, far) = (planes[usize::from(axis.is_negative)], planes[usize::from(!axis.is_negative)]);
            t_entry = ((near - axis.origin) * axis.inverse).max(t_entry);
            t_exit = ((far - axis.origin) * axis.inverse).min(t_exit);
        }
        let t_last = (t_exit * Real4::splat(WIDEN)).min(Real4::splat(t_max));
        BoxHits { t_entry, mask: t_entry.compare(t_last, |entry, last| entry <= last) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Vec3, vec3};

    /// Coordinates from a small set, so that rays often lie in planes of boxes.
    fn coordinates(seed: &mut u32) -> Vec3 {
        let mut next = || {
            *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            [-1.0, -0.5, -0.0, 0.0, 0.25, 1.0 / 3.0, 1.0, 2.0][(*seed >> 28) as usize / 2]
        };
        vec3(next(), next(), next())
    }

    #[test]
    fn a_node_and_its_boxes_agree_on_every_ray() {
        let mut seed = 1;
        let mut hit_count = 0;
        for _ in 0..20_000 {
            let boxes =
                [(); CHILDREN].map(|()| Aabb::enclosing([coordinates(&mut seed), coordinates(&mut seed)]));
            let (origin, direction) = (coordinates(&mut seed), coordinates(&mut seed));
            if direction == Vec3::ZERO {
                continue;
            }
            let ray = Ray::new(origin, direction);
            let mut node = BvhNode::EMPTY;
            for (aabb, child) in boxes.iter().zip(0..CHILDREN - 1) {
                node.set_bounds(child, aabb);
            }
            let t_max = 1.5;
            let hits = node.intersect(&TraversalRay::new(&ray), t_max);
            for (aabb, child) in boxes.iter().zip(0..CHILDREN - 1) {
                let span = aabb.intersect(&ray).filter(|span| span.t_entry <= t_max);
                assert_eq!(hits.mask >> child & 1 != 0, span.is_some(), "{aabb:?} {ray:?}");
                if let Some(span) = span {
                    hit_count += 1;
                    let t_entry = if span.t_entry > 0.0 { span.t_entry } else { 0.0 };
                    assert_eq!(hits.t_entry.0[child], t_entry, "{aabb:?} {ray:?}");
                }
            }
            assert_eq!(hits.mask >> (CHILDREN - 1), 0, "an unused child is never hit");
        }
        assert!(hit_count > 5_000, "{hit_count}");
    }
}
