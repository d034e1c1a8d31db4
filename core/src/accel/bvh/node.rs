//! A node: the boxes of its two halves, and where they go on.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use crate::geometry::{Aabb, ItemId, Ray, WIDEN};
use crate::math::Real;

/// A split: two halves with a box each.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Node {
    /// For each axis the low walls of both halves and the high ones, so that what is asked of
    /// one half can be asked of both at once.
    walls: [Walls; 3],
    children: [Child; 2],
    /// The first node behind this part of the tree.
    end: u32,
}

#[cfg(not(feature = "double"))]
const _: () = assert!(size_of::<Node>() == 60);

/// The walls of two boxes across one axis.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
struct Walls {
    low: [Real; 2],
    high: [Real; 2],
}

/// Where a half goes on: at a node, or in the items of a leaf.
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
}

/// The bit that a leaf has and a node has not; that the last item of a leaf has.
const MARK: u32 = 1 << 31;

impl Child {
    pub(super) const fn node(place: u32) -> Self {
        Child(place & !MARK)
    }

    pub(super) const fn leaf(first: u32) -> Self {
        Child(first | MARK)
    }

    #[inline(always)]
    pub(super) const fn goes(self) -> Goes {
        if self.0 & MARK == 0 { Goes::On(self.0) } else { Goes::Out(self.0 & !MARK) }
    }
}

/// An item in a leaf, and whether it is the leaf's last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, TryFromBytes, KnownLayout, Immutable)]
#[repr(transparent)]
pub struct Slot(u32);

impl Slot {
    /// A place to be overwritten.
    pub const EMPTY: Slot = Slot(MARK);
    /// How many items can be told apart.
    pub(super) const MOST: usize = MARK as usize;

    /// As it lies in memory.
    #[cfg(not(feature = "double"))]
    pub(crate) const fn word(self) -> u32 {
        self.0
    }

    pub(super) const fn of(item: ItemId) -> Self {
        Slot(item.0 & !MARK)
    }

    pub(super) const fn mark_last(&mut self) {
        self.0 |= MARK;
    }

    #[inline(always)]
    pub(super) const fn item(self) -> ItemId {
        ItemId(self.0 & !MARK)
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
    origin: Real,
    inverse: Real,
    /// Whether the ray meets the low wall first.
    rises: bool,
}

impl Slabs {
    pub(super) fn of(ray: &Ray) -> Self {
        let slab = |origin, inverse| Slab { origin, inverse, rises: inverse >= 0.0 };
        let (o, i) = (ray.origin, ray.inverse);
        Slabs([slab(o.x, i.x), slab(o.y, i.y), slab(o.z, i.z)])
    }
}

/// Where a ray comes into the two boxes of a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub(super) entry: [Real; 2],
    /// Whether it comes in at all, and within reach.
    pub(super) meets: [bool; 2],
}

impl Node {
    /// A node to be overwritten: no ray meets it.
    pub const EMPTY: Node = Node::of([Aabb::EMPTY; 2]);

    /// A node whose halves have these boxes, and no items yet.
    pub(super) const fn of([a, b]: [Aabb; 2]) -> Self {
        Node {
            walls: [
                Walls { low: [a.min.x, b.min.x], high: [a.max.x, b.max.x] },
                Walls { low: [a.min.y, b.min.y], high: [a.max.y, b.max.y] },
                Walls { low: [a.min.z, b.min.z], high: [a.max.z, b.max.z] },
            ],
            children: [Child::leaf(0); 2],
            end: 0,
        }
    }

    /// As it lies in memory.
    #[cfg(not(feature = "double"))]
    pub(crate) fn words(&self) -> [u32; 15] {
        let [x, y, z] = self.walls.map(|walls| [walls.low, walls.high]);
        let mut words = [0; 15];
        let walls = [x, y, z].into_iter().flatten().flatten().map(f32::to_bits);
        let rest = self.children.iter().map(|child| child.0).chain([self.end]);
        for (word, value) in words.iter_mut().zip(walls.chain(rest)) {
            *word = value;
        }
        words
    }

    #[inline(always)]
    pub(super) const fn children(&self) -> [Child; 2] {
        self.children
    }

    pub(super) const fn set_children(&mut self, children: [Child; 2]) {
        self.children = children;
    }

    #[inline(always)]
    pub(super) const fn end(&self) -> u32 {
        self.end
    }

    pub(super) const fn set_end(&mut self, end: u32) {
        self.end = end;
    }

    /// [`Aabb::span`] of both boxes at once, bit for bit: the same operations in the same
    /// order, four in a row. The far walls are counted backwards, so that all four look for
    /// the largest.
    #[inline(always)]
    pub(super) fn seen(&self, slabs: &Slabs, reach: Real) -> Seen {
        let mut ends = [Real::NEG_INFINITY, Real::NEG_INFINITY, -Real::MAX, -Real::MAX];
        for (walls, slab) in self.walls.iter().zip(&slabs.0) {
            let (near, far) = if slab.rises { (walls.low, walls.high) } else { (walls.high, walls.low) };
            let (forth, back) = (slab.inverse, -slab.inverse);
            let walls = [near[0], near[1], far[0], far[1]];
            let scale = [forth, forth, back, back];
            for ((end, wall), scale) in ends.iter_mut().zip(walls).zip(scale) {
                let t = (wall - slab.origin) * scale;
                *end = if t > *end { t } else { *end };
            }
        }
        let [first, second, first_exit, second_exit] = ends;
        let meets = |entry: Real, exit: Real| {
            let exit = -exit * WIDEN;
            entry <= exit && exit >= 0.0 && entry <= reach
        };
        Seen { entry: [first, second], meets: [meets(first, first_exit), meets(second, second_exit)] }
    }
}
