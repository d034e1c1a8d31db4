//! Where the parts of a hierarchy wait that a walk has seen and not yet visited.

use core::cmp::Ordering;

use heapless::Vec;
use heapless::binary_heap::{BinaryHeap, Min};

use super::node::Child;
use crate::math::Real;

/// A part of the tree that waits, and where the ray comes into its box.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    pub(super) entry: Real,
    pub(super) child: Child,
}

/// The nearer one is the smaller; equally near ones have an order too, so that walks are
/// repeatable.
impl Ord for Part {
    fn cmp(&self, other: &Self) -> Ordering {
        self.entry.total_cmp(&other.entry).then(self.child.cmp(&other.child))
    }
}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Part {}

/// Somewhere with room for a fixed number of parts that wait.
pub trait Waiting: Default {
    /// Nothing waits.
    fn clear(&mut self);

    /// Lets a part wait; gives it back when there is no room.
    fn wait(&mut self, part: Part) -> Result<(), Part>;

    /// The part that comes before `part` and all that waits; the others wait.
    fn first(&mut self, part: Part) -> Part;

    /// The next part that begins within `reach`. What begins beyond it is forgotten.
    fn next(&mut self, reach: Real) -> Option<Part>;
}

/// A stack: what was seen last comes next.
#[derive(Clone, Debug, Default)]
pub struct LastFirst<const PLACES: usize>(Vec<Part, PLACES>);

impl<const PLACES: usize> Waiting for LastFirst<PLACES> {
    #[inline(always)]
    fn clear(&mut self) {
        self.0.clear();
    }

    #[inline(always)]
    fn wait(&mut self, part: Part) -> Result<(), Part> {
        self.0.push(part)
    }

    #[inline(always)]
    fn first(&mut self, part: Part) -> Part {
        part
    }

    #[inline(always)]
    fn next(&mut self, reach: Real) -> Option<Part> {
        loop {
            let part = self.0.pop()?;
            // Strictly beyond: an item at the same distance may have the lower number, and must win.
            if !(part.entry > reach) {
                return Some(part);
            }
        }
    }
}

/// A heap: the nearest comes next, and when that is beyond reach, so is the rest.
#[derive(Clone, Debug, Default)]
pub struct NearestFirst<const PLACES: usize>(BinaryHeap<Part, Min, PLACES>);

impl<const PLACES: usize> Waiting for NearestFirst<PLACES> {
    fn clear(&mut self) {
        self.0.clear();
    }

    #[inline]
    fn wait(&mut self, part: Part) -> Result<(), Part> {
        self.0.push(part)
    }

    #[inline]
    fn first(&mut self, part: Part) -> Part {
        match self.0.peek_mut() {
            Some(mut nearest) if *nearest < part => core::mem::replace(&mut *nearest, part),
            _ => part,
        }
    }

    #[inline]
    fn next(&mut self, reach: Real) -> Option<Part> {
        let nearest = self.0.pop()?;
        (!(nearest.entry > reach)).then_some(nearest)
    }
}
