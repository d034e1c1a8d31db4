//! A node: the boxes of up to four parts of the tree, side by side, and where they go on.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use crate::geometry::{Aabb, ItemId, Ray, WIDEN};
use crate::math::{LANES, Lanes, Real};

/// How many parts a node has at most.
pub(super) const PARTS: usize = LANES;

/// A split into up to four parts.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Node {
    /// For each axis the low walls of all parts and then the high ones: what is asked of one
    /// part can be asked of all at once. A part that is not there is a box that no ray meets.
    walls: [[Lanes; 2]; 3],
    children: [Child; PARTS],
    /// The first node behind this part of the tree.
    end: u32,
    /// Fills two cache lines where memory is aligned to them.
    reserve: [u32; 3],
}

#[cfg(not(feature = "double"))]
const _: () = assert!(size_of::<Node>() == 128);

/// Where a part goes on: at a node, in the items of a leaf, or at the only item of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, TryFromBytes, KnownLayout, Immutable)]
#[repr(transparent)]
pub struct Child(u32);

/// What a [`Child`] is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Goes {
    /// On, to the node of this number.
    On(u32),
    /// Out, to the items from this place on.
    Out(u32),
    /// Out, to this item alone.
    Lone(ItemId),
}

/// The bit that a leaf has and a node has not; that the last item of a leaf has.
const MARK: u32 = 1 << 31;

/// The bit of a leaf that is a lone item.
const LONE: u32 = 1 << 30;

impl Child {
    /// Where there is no part: what stands here is a thing that there is in every hierarchy.
    const NONE: Child = Child::lone(ItemId(0));

    pub(super) const fn node(place: u32) -> Self {
        Child(place & !MARK)
    }

    pub(super) const fn leaf(first: u32) -> Self {
        Child(first & !LONE | MARK)
    }

    pub(super) const fn lone(item: ItemId) -> Self {
        Child(item.0 | MARK | LONE)
    }

    #[inline(always)]
    pub(super) const fn goes(self) -> Goes {
        let number = self.0 & !(MARK | LONE);
        match (self.0 & MARK, self.0 & LONE) {
            (0, _) => Goes::On(self.0),
            (_, 0) => Goes::Out(number),
            _ => Goes::Lone(ItemId(number)),
        }
    }
}

/// The bit of an item that will be tested together with others, while the tree grows.
const GROUPED: u32 = 1 << 30;

/// An item in a leaf, and whether it is the leaf's last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, TryFromBytes, KnownLayout, Immutable)]
#[repr(transparent)]
pub struct Slot(u32);

impl Slot {
    /// A place to be overwritten.
    pub const EMPTY: Slot = Slot(MARK);
    /// How many items can be told apart.
    pub(super) const MOST: usize = GROUPED as usize;

    /// As it lies in memory.
    #[cfg(not(feature = "double"))]
    pub(crate) const fn word(self) -> u32 {
        self.0
    }

    pub(super) const fn of(item: ItemId, is_grouped: bool) -> Self {
        Slot(item.0 & !(MARK | GROUPED) | if is_grouped { GROUPED } else { 0 })
    }

    /// Whether it will be tested together with others of its leaf, for the price of one.
    pub(super) const fn is_grouped(self) -> bool {
        self.0 & GROUPED != 0
    }

    pub(super) const fn mark_last(&mut self) {
        self.0 |= MARK;
    }

    #[inline(always)]
    pub(super) const fn item(self) -> ItemId {
        ItemId(self.0 & !(MARK | GROUPED))
    }

    #[inline(always)]
    pub(super) const fn is_last(self) -> bool {
        self.0 & MARK != 0
    }
}

/// What of a ray the boxes need.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slabs([Slab; 3]);

#[derive(Clone, Copy, Debug)]
struct Slab {
    origin: Lanes,
    inverse: Lanes,
    /// Whether the ray meets the high wall first.
    falls: bool,
}

impl Slabs {
    pub(super) fn of(ray: &Ray) -> Self {
        let slab = |origin, inverse| Slab {
            origin: Lanes::splat(origin),
            inverse: Lanes::splat(inverse),
            falls: !(inverse >= 0.0),
        };
        let (o, i) = (ray.origin, ray.inverse);
        Slabs([slab(o.x, i.x), slab(o.y, i.y), slab(o.z, i.z)])
    }
}

/// Where a ray comes into the boxes of a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    /// At or behind the start of the ray.
    pub(super) entry: Lanes,
    /// A bit for each box that it comes into within reach.
    pub(super) meets: u32,
}

impl Node {
    /// A node to be overwritten: no ray meets it.
    pub const EMPTY: Node = Node {
        walls: [[Lanes::splat(Real::INFINITY), Lanes::splat(Real::NEG_INFINITY)]; 3],
        children: [Child::NONE; PARTS],
        end: 0,
        reserve: [0; 3],
    };

    /// Puts a part into one of the places; there is none behind the last.
    pub(super) fn put(&mut self, place: usize, aabb: &Aabb) {
        let (min, max) = (aabb.min.to_array(), aabb.max.to_array());
        for (walls, (low, high)) in self.walls.iter_mut().zip(min.into_iter().zip(max)) {
            for (lanes, wall) in walls.iter_mut().zip([low, high]) {
                if let Some(lane) = lanes.0.get_mut(place) {
                    *lane = wall;
                }
            }
        }
    }

    /// As it lies in memory.
    #[cfg(not(feature = "double"))]
    pub(crate) fn words(&self) -> [u32; 32] {
        let mut words = [0; 32];
        let walls = self.walls.iter().flatten().flat_map(|lanes| lanes.0).map(f32::to_bits);
        let rest = self.children.iter().map(|child| child.0).chain([self.end]);
        for (word, value) in words.iter_mut().zip(walls.chain(rest)) {
            *word = value;
        }
        words
    }

    /// All four, whether they are there or not.
    #[cfg(not(feature = "double"))]
    pub(super) const fn all_children(&self) -> [Child; PARTS] {
        self.children
    }

    /// The children whose boxes are there, whatever the ray.
    pub(super) fn children(&self) -> impl Iterator<Item = Child> + '_ {
        let [[low, high], ..] = &self.walls;
        let is_there = low.0.iter().zip(&high.0).map(|(low, high)| low <= high);
        self.children.iter().zip(is_there).filter(|(_, is_there)| *is_there).map(|(child, _)| *child)
    }

    #[inline(always)]
    pub(super) fn child(&self, place: usize) -> Child {
        self.children.get(place).copied().unwrap_or(Child::NONE)
    }

    pub(super) fn set_child(&mut self, place: usize, other: Child) {
        if let Some(child) = self.children.get_mut(place) {
            *child = other;
        }
    }

    #[inline(always)]
    pub(super) const fn end(&self) -> u32 {
        self.end
    }

    pub(super) const fn set_end(&mut self, end: u32) {
        self.end = end;
    }

    /// [`Aabb::span`] of all boxes at once: the same operations in the same order, so that an
    /// entry is the same, bit for bit, unless it lies before the start of the ray.
    #[inline(always)]
    pub(super) fn seen(&self, slabs: &Slabs, reach: Real) -> Seen {
        let (mut entry, mut exit) = (Lanes::splat(0.0), Lanes::splat(Real::MAX));
        for (walls, slab) in self.walls.iter().zip(&slabs.0) {
            let (near, far) = (walls[usize::from(slab.falls)], walls[usize::from(!slab.falls)]);
            entry = ((near - slab.origin) * slab.inverse).greatest(entry);
            exit = ((far - slab.origin) * slab.inverse).least(exit);
        }
        let last = (exit * Lanes::splat(WIDEN)).least(Lanes::splat(reach));
        Seen { entry, meets: entry.bits(last, |entry, last| entry <= last) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Vec3, vec3};

    /// Numbers on which walls and rays are likely to meet.
    fn coordinates(seed: &mut u32) -> Vec3 {
        let mut next = || {
            *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            [-1.0, -0.5, -0.0, 0.0, 0.25, 1.0 / 3.0, 1.0, 2.0][(*seed >> 28) as usize / 2]
        };
        vec3(next(), next(), next())
    }

    #[test]
    fn a_node_says_of_each_box_what_the_box_says_itself() {
        let mut seed = 1;
        let mut met = 0;
        for _ in 0..20_000 {
            let boxes = [(); PARTS].map(|()| Aabb::around([coordinates(&mut seed), coordinates(&mut seed)]));
            let (origin, direction) = (coordinates(&mut seed), coordinates(&mut seed));
            if direction == Vec3::ZERO {
                continue;
            }
            let ray = Ray::new(origin, direction);
            let mut node = Node::EMPTY;
            for (aabb, place) in boxes.iter().zip(0..PARTS - 1) {
                node.put(place, aabb);
            }
            let reach = 1.5;
            let seen = node.seen(&Slabs::of(&ray), reach);
            for (aabb, place) in boxes.iter().zip(0..PARTS - 1) {
                let span = aabb.span(&ray).filter(|span| span.entry <= reach);
                assert_eq!(seen.meets >> place & 1 != 0, span.is_some(), "{aabb:?} {ray:?}");
                if let Some(span) = span {
                    met += 1;
                    let entry = if span.entry > 0.0 { span.entry } else { 0.0 };
                    assert_eq!(seen.entry.0[place], entry, "{aabb:?} {ray:?}");
                }
            }
            assert_eq!(seen.meets >> (PARTS - 1), 0, "nothing is there");
        }
        assert!(met > 5_000, "{met}");
    }
}
