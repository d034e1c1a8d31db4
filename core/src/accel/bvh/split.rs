//! One split: where it promises the least work.

use core::mem::swap;

use super::Run;
use super::build::Leaves;
use super::node::Slot;
use crate::geometry::Aabb;
use crate::math::{Real, Vec3};

/// Bins along each axis.
const BINS: usize = 16;

/// What a walk pays.
#[derive(Clone, Copy)]
pub(super) struct Costs {
    /// For the visit of a node, in tests of one item.
    visit: Real,
    /// Items are tested so many at once, for the price of all.
    together: u32,
    /// A leaf has at most so many items, if there are nodes enough.
    leaf: u32,
}

impl Costs {
    pub(super) const fn of(leaves: Leaves) -> Self {
        match leaves {
            Leaves::Singly => Costs { visit: 1.0, together: 1, leaf: 8 },
            Leaves::Runs => Costs { visit: 4.0, together: Run::ITEMS as u32, leaf: 8 },
        }
    }

    /// For items inside a box, times the surface of what they are inside of.
    fn tests(self, aabb: &Aabb, count: u32) -> Real {
        if count == 0 { 0.0 } else { surface(aabb) * count.next_multiple_of(self.together) as Real }
    }
}

/// Items in two halves, the first ones and the rest.
pub(super) struct Split {
    /// The boxes of both.
    pub(super) boxes: [Aabb; 2],
    /// How many are in the first.
    pub(super) count: u32,
}

/// Items whose boxes have their middles in one bin.
#[derive(Clone, Copy)]
struct Bin {
    aabb: Aabb,
    count: u32,
}

impl Bin {
    const EMPTY: Bin = Bin { aabb: Aabb::EMPTY, count: 0 };

    fn and(self, other: Bin) -> Bin {
        Bin { aabb: self.aabb.union(other.aabb), count: self.count + other.count }
    }
}

/// Half the surface of a box.
pub(super) fn surface(aabb: &Aabb) -> Real {
    let size = aabb.max - aabb.min;
    size.x * size.y + size.y * size.z + size.z * size.x
}

/// Twice the middle of a box.
fn middle(aabb: &Aabb) -> Vec3 {
    aabb.min + aabb.max
}

/// The bins of all axes, for items whose middles lie in one box.
#[derive(Clone, Copy)]
struct Bins {
    low: Vec3,
    scale: Vec3,
}

impl Bins {
    fn of(middles: &Aabb) -> Self {
        // Of an axis along which all middles agree the scale is infinite, and every item is in
        // the first bin or, where that is no number, too.
        let scale = Vec3::splat(BINS as Real) / (middles.max - middles.min);
        Bins { low: middles.min, scale }
    }

    /// The bins of an item, one for each axis.
    #[inline(always)]
    fn places(&self, aabb: &Aabb) -> [usize; 3] {
        let at = (middle(aabb) - self.low) * self.scale;
        // A conversion to an integer saturates, and makes no number zero.
        let bin = |x: Real| {
            let bin = x as u32;
            if bin < BINS as u32 { bin as usize } else { BINS - 1 }
        };
        [bin(at.x), bin(at.y), bin(at.z)]
    }
}

/// Splits `items` into two halves, and reorders them; none when they had better stay together.
///
/// With `even` into equal halves.
pub(super) fn split(boxes: &[Aabb], items: &mut [Slot], costs: Costs, even: bool) -> Option<Split> {
    let box_of = |slot: &Slot| boxes.get(slot.item().0 as usize).copied().unwrap_or(Aabb::EMPTY);
    let count = items.len() as u32;
    let (mut all, mut middles) = (Aabb::EMPTY, Aabb::EMPTY);
    for slot in items.iter() {
        let aabb = box_of(slot);
        let middle = middle(&aabb);
        all = all.union(aabb);
        middles = middles.union(Aabb { min: middle, max: middle });
    }

    let bins = Bins::of(&middles);
    let best = if even { None } else { best(items.iter().map(box_of), &bins, costs) };
    let stay = if count <= costs.leaf { costs.tests(&all, count) } else { Real::INFINITY };
    match best {
        Some(best) => {
            if !(best.cost + costs.visit * surface(&all) < stay) {
                return None;
            }
            let in_first = |slot: &Slot| {
                let places = bins.places(&box_of(slot));
                places.get(best.axis).is_some_and(|place| *place < best.border)
            };
            partition(items, in_first);
            Some(Split { boxes: best.boxes, count: best.count })
        }
        None if count <= costs.leaf => None,
        None => {
            let half = count / 2;
            let round = |items: &[Slot]| items.iter().map(box_of).fold(Aabb::EMPTY, Aabb::union);
            let (first, second) = items.split_at_checked(half as usize)?;
            Some(Split { boxes: [round(first), round(second)], count: half })
        }
    }
}

/// The best split found.
struct Best {
    axis: usize,
    /// The first bin of the second half.
    border: usize,
    cost: Real,
    boxes: [Aabb; 2],
    /// Items in the first half.
    count: u32,
}

/// The best of all borders between bins; none when all middles agree.
fn best(boxes: impl Iterator<Item = Aabb>, bins: &Bins, costs: Costs) -> Option<Best> {
    let mut filled = [[Bin::EMPTY; BINS]; 3];
    for aabb in boxes {
        for (axis, place) in filled.iter_mut().zip(bins.places(&aabb)) {
            if let Some(bin) = axis.get_mut(place) {
                *bin = bin.and(Bin { aabb, count: 1 });
            }
        }
    }
    let mut best: Option<Best> = None;
    for (filled, axis) in filled.iter().zip(0..) {
        // What lies behind each border, from the last to the first.
        let mut behind = [Bin::EMPTY; BINS];
        let mut all = Bin::EMPTY;
        for (bin, behind) in filled.iter().rev().zip(behind.iter_mut().rev()) {
            all = all.and(*bin);
            *behind = all;
        }
        let mut before = Bin::EMPTY;
        for ((bin, behind), border) in filled.iter().zip(behind.iter().skip(1)).zip(1..) {
            before = before.and(*bin);
            if before.count == 0 || behind.count == 0 {
                continue;
            }
            let cost = costs.tests(&before.aabb, before.count) + costs.tests(&behind.aabb, behind.count);
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                let boxes = [before.aabb, behind.aabb];
                best = Some(Best { axis, border, cost, boxes, count: before.count });
            }
        }
    }
    best
}

/// Moves what belongs into the first half before the rest.
fn partition(items: &mut [Slot], in_first: impl Fn(&Slot) -> bool) {
    let mut rest = items.iter_mut();
    while let Some(early) = rest.find(|slot| !in_first(slot))
        && let Some(late) = rest.rfind(|slot| in_first(slot))
    {
        swap(early, late);
    }
}
