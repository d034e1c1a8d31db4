//! One split of a range of items, by the binned surface area heuristic (SAH).
//!
//! The probability that a ray that hits a box also hits a box inside it is about the ratio of their surface
//! areas. So the expected cost of a split is one visit of the node plus, for each side, its relative surface
//! area times the cost of testing its items. Splits are tried at the boundaries of equally wide bins along
//! each axis; an item belongs to the bin of its center.
//!
//! Sources: Goldsmith and Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing", IEEE CG&A 1987;
//! Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE RT 2007.

use core::mem::swap;

use super::node::BvhEntry;
use crate::accel::TriangleBlock;
use crate::geometry::Aabb;
use crate::math::{Real, Vec3};

/// Number of bins along each axis.
const BINS: usize = 16;

/// Cost of visiting a node, in tests of one block: both test four volumes at once.
const NODE_COST: Real = 1.0;

/// Cost of testing an item that is not in a block, in tests of one block.
const ITEM_COST: Real = 3.0;

/// Largest number of items of a leaf, if there are enough nodes.
const MAX_LEAF_ITEMS: u32 = 8;

/// Number of items that are tested in blocks and one by one.
#[derive(Clone, Copy)]
struct ItemCounts {
    in_blocks: u32,
    single: u32,
}

impl ItemCounts {
    const ZERO: ItemCounts = ItemCounts { in_blocks: 0, single: 0 };

    const fn of(entry: BvhEntry) -> Self {
        let in_blocks = entry.is_in_block() as u32;
        ItemCounts { in_blocks, single: 1 - in_blocks }
    }

    const fn merged(self, other: ItemCounts) -> ItemCounts {
        ItemCounts { in_blocks: self.in_blocks + other.in_blocks, single: self.single + other.single }
    }

    const fn total(self) -> u32 {
        self.in_blocks + self.single
    }

    /// Cost of testing the items inside `aabb`, times half the surface area of the parent.
    fn cost(self, aabb: &Aabb) -> Real {
        if self.total() == 0 {
            return 0.0;
        }
        let blocks = self.in_blocks.div_ceil(TriangleBlock::CAPACITY as u32) as Real;
        half_area(aabb) * (blocks + self.single as Real * ITEM_COST)
    }
}

/// The two sides of a split; the entries of the left side come first.
pub(super) struct Split {
    /// Left and right.
    pub(super) bounds: [Aabb; 2],
    /// Number of items on the left side.
    pub(super) left_count: u32,
}

/// The items whose centers are in one bin.
#[derive(Clone, Copy)]
struct Bin {
    aabb: Aabb,
    items: ItemCounts,
}

impl Bin {
    const EMPTY: Bin = Bin { aabb: Aabb::EMPTY, items: ItemCounts::ZERO };

    fn merged(self, other: Bin) -> Bin {
        Bin { aabb: self.aabb.union(other.aabb), items: self.items.merged(other.items) }
    }

    fn cost(&self) -> Real {
        self.items.cost(&self.aabb)
    }
}

/// Half the surface area of a box.
pub(super) fn half_area(aabb: &Aabb) -> Real {
    let size = aabb.max - aabb.min;
    size.x * size.y + size.y * size.z + size.z * size.x
}

/// Twice the center of a box.
fn center2(aabb: &Aabb) -> Vec3 {
    aabb.min + aabb.max
}

/// The mapping from centers to bins, for all axes.
#[derive(Clone, Copy)]
struct Binning {
    min: Vec3,
    scale: Vec3,
}

impl Binning {
    /// `centers`: the box of all doubled centers.
    fn new(centers: &Aabb) -> Self {
        // If all centers agree along an axis, the scale is infinite and the product NaN, which selects bin 0.
        let scale = Vec3::splat(BINS as Real) / (centers.max - centers.min);
        Binning { min: centers.min, scale }
    }

    /// The bin of an item along each axis.
    #[inline(always)]
    fn bin_indices(&self, aabb: &Aabb) -> [usize; 3] {
        let position = (center2(aabb) - self.min) * self.scale;
        // The conversion to an integer saturates and maps NaN to zero.
        let bin = |x: Real| {
            let bin = x as u32;
            if bin < BINS as u32 { bin as usize } else { BINS - 1 }
        };
        [bin(position.x), bin(position.y), bin(position.z)]
    }
}

/// Splits `entries` in two and reorders them; `None` if they are better kept together in a leaf.
///
/// `bounds`: by item index. `equal_counts`: split into equal counts, if into anything.
pub(super) fn split(bounds: &[Aabb], entries: &mut [BvhEntry], equal_counts: bool) -> Option<Split> {
    let bounds_of = |entry: &BvhEntry| bounds.get(entry.item().0 as usize).copied().unwrap_or(Aabb::EMPTY);
    let count = entries.len() as u32;
    let (mut all, mut centers) = (Bin::EMPTY, Aabb::EMPTY);
    let bin_of = |entry: &BvhEntry| Bin { aabb: bounds_of(entry), items: ItemCounts::of(*entry) };
    for entry in entries.iter() {
        let bin = bin_of(entry);
        let center = center2(&bin.aabb);
        all = all.merged(bin);
        centers = centers.union(Aabb { min: center, max: center });
    }

    let binning = Binning::new(&centers);
    let best = if equal_counts { None } else { find_best_split(entries.iter().map(bin_of), &binning) };
    let leaf_cost = if count <= MAX_LEAF_ITEMS { all.cost() } else { Real::INFINITY };
    match best {
        Some(best) => {
            if !(best.cost + NODE_COST * half_area(&all.aabb) < leaf_cost) {
                return None;
            }
            let is_left = |entry: &BvhEntry| {
                let bins = binning.bin_indices(&bounds_of(entry));
                bins.get(best.axis).is_some_and(|bin| *bin < best.first_right_bin)
            };
            partition(entries, is_left);
            Some(Split { bounds: best.bounds, left_count: best.left_count })
        }
        None if count <= MAX_LEAF_ITEMS => None,
        None => {
            let left_count = count / 2;
            let union = |entries: &[BvhEntry]| entries.iter().map(bounds_of).fold(Aabb::EMPTY, Aabb::union);
            let (left, right) = entries.split_at_checked(left_count as usize)?;
            Some(Split { bounds: [union(left), union(right)], left_count })
        }
    }
}

/// The split with the lowest cost.
struct BestSplit {
    axis: usize,
    /// Index of the first bin of the right side.
    first_right_bin: usize,
    cost: Real,
    bounds: [Aabb; 2],
    /// Number of items on the left side.
    left_count: u32,
}

/// The best split at a boundary between bins; `None` if all centers agree.
fn find_best_split(items: impl Iterator<Item = Bin>, binning: &Binning) -> Option<BestSplit> {
    let mut bins = [[Bin::EMPTY; BINS]; 3];
    for item in items {
        for (axis, index) in bins.iter_mut().zip(binning.bin_indices(&item.aabb)) {
            if let Some(bin) = axis.get_mut(index) {
                *bin = bin.merged(item);
            }
        }
    }
    let mut best: Option<BestSplit> = None;
    for (bins, axis) in bins.iter().zip(0..) {
        // The right side of each boundary, from the last to the first.
        let mut right_sides = [Bin::EMPTY; BINS];
        let mut all = Bin::EMPTY;
        for (bin, right) in bins.iter().rev().zip(right_sides.iter_mut().rev()) {
            all = all.merged(*bin);
            *right = all;
        }
        let mut left = Bin::EMPTY;
        for ((bin, right), first_right_bin) in bins.iter().zip(right_sides.iter().skip(1)).zip(1..) {
            left = left.merged(*bin);
            if left.items.total() == 0 || right.items.total() == 0 {
                continue;
            }
            let cost = left.cost() + right.cost();
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                let (bounds, left_count) = ([left.aabb, right.aabb], left.items.total());
                best = Some(BestSplit { axis, first_right_bin, cost, bounds, left_count });
            }
        }
    }
    best
}

/// Moves the entries of the left side before the others.
fn partition(entries: &mut [BvhEntry], is_left: impl Fn(&BvhEntry) -> bool) {
    let mut rest = entries.iter_mut();
    while let Some(early) = rest.find(|entry| !is_left(entry))
        && let Some(late) = rest.rfind(|entry| is_left(entry))
    {
        swap(early, late);
    }
}
