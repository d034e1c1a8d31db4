//! One split: where it promises the least work.

use core::mem::swap;

use super::Run;
use super::node::Slot;
use crate::geometry::Aabb;
use crate::math::{Real, Vec3};

/// Bins along each axis.
const BINS: usize = 16;

/// What the visit of a node costs, in tests of one run: a run and a node ask four of their own.
const VISIT: Real = 1.0;

/// What the test of an item costs that stands in no run, or is alone in one.
const TEST: Real = 3.0;

/// A leaf has at most so many items, if there are nodes enough.
const MOST: u32 = 8;

/// Items to be tested: in runs with others, or each by itself.
#[derive(Clone, Copy)]
struct Tests {
    grouped: u32,
    single: u32,
}

impl Tests {
    const NONE: Tests = Tests { grouped: 0, single: 0 };

    const fn of(slot: Slot) -> Self {
        let grouped = slot.is_grouped() as u32;
        Tests { grouped, single: 1 - grouped }
    }

    const fn and(self, other: Tests) -> Tests {
        Tests { grouped: self.grouped + other.grouped, single: self.single + other.single }
    }

    const fn count(self) -> u32 {
        self.grouped + self.single
    }

    /// What they cost, inside a box, times the surface of what it is inside of.
    fn cost(self, aabb: &Aabb) -> Real {
        if self.count() == 0 {
            return 0.0;
        }
        let runs = self.grouped.div_ceil(Run::ITEMS as u32) as Real;
        surface(aabb) * (runs + self.single as Real * TEST)
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
    tests: Tests,
}

impl Bin {
    const EMPTY: Bin = Bin { aabb: Aabb::EMPTY, tests: Tests::NONE };

    fn and(self, other: Bin) -> Bin {
        Bin { aabb: self.aabb.union(other.aabb), tests: self.tests.and(other.tests) }
    }

    fn cost(&self) -> Real {
        self.tests.cost(&self.aabb)
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
pub(super) fn split(boxes: &[Aabb], items: &mut [Slot], even: bool) -> Option<Split> {
    let box_of = |slot: &Slot| boxes.get(slot.item().0 as usize).copied().unwrap_or(Aabb::EMPTY);
    let count = items.len() as u32;
    let (mut all, mut middles) = (Bin::EMPTY, Aabb::EMPTY);
    let bin_of = |slot: &Slot| Bin { aabb: box_of(slot), tests: Tests::of(*slot) };
    for slot in items.iter() {
        let bin = bin_of(slot);
        let middle = middle(&bin.aabb);
        all = all.and(bin);
        middles = middles.union(Aabb { min: middle, max: middle });
    }

    let bins = Bins::of(&middles);
    let best = if even { None } else { best(items.iter().map(bin_of), &bins) };
    let stay = if count <= MOST { all.cost() } else { Real::INFINITY };
    match best {
        Some(best) => {
            if !(best.cost + VISIT * surface(&all.aabb) < stay) {
                return None;
            }
            let in_first = |slot: &Slot| {
                let places = bins.places(&box_of(slot));
                places.get(best.axis).is_some_and(|place| *place < best.border)
            };
            partition(items, in_first);
            Some(Split { boxes: best.boxes, count: best.count })
        }
        None if count <= MOST => None,
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
fn best(items: impl Iterator<Item = Bin>, bins: &Bins) -> Option<Best> {
    let mut filled = [[Bin::EMPTY; BINS]; 3];
    for item in items {
        for (axis, place) in filled.iter_mut().zip(bins.places(&item.aabb)) {
            if let Some(bin) = axis.get_mut(place) {
                *bin = bin.and(item);
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
            if before.tests.count() == 0 || behind.tests.count() == 0 {
                continue;
            }
            let cost = before.cost() + behind.cost();
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                let boxes = [before.aabb, behind.aabb];
                best = Some(Best { axis, border, cost, boxes, count: before.tests.count() });
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
