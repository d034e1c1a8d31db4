//! Runs: what stands in a leaf, side by side, four at a time.
//!
//! To hold a ray against a triangle of a mesh takes three steps through memory: the item's
//! shape, the places of its corners, its corners. A run has the corners of four items of a leaf
//! together with their numbers, and one quick question rules out most of them at once. What is
//! left is tested as ever, with the same corners: runs change how long an answer takes, never
//! the answer.

use super::node::Slot;
use crate::geometry::{FourTriangles, Geometry, ItemId, Ray, Shape};
use crate::math::{LANES, Vec3};

/// Up to four items of a leaf. Items that are no triangles may be among them; of those it knows
/// no more than the number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Run {
    triangles: FourTriangles,
    items: [Slot; LANES],
    /// A bit for each item that there is.
    filled: u8,
    /// A bit for each item that is a triangle.
    known: u8,
    /// Whether more runs of the leaf follow.
    goes_on: bool,
}

#[cfg(not(feature = "double"))]
const _: () = assert!(size_of::<Run>() == 164);

/// An item that a ray may meet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    pub(crate) item: ItemId,
    /// Its corners, when it is a triangle.
    pub(crate) corners: Option<[Vec3; 3]>,
}

impl Run {
    /// The most items of a run.
    pub const ITEMS: usize = LANES;

    /// A run to be overwritten.
    pub const EMPTY: Run = Run {
        triangles: FourTriangles::ZERO,
        items: [Slot::EMPTY; LANES],
        filled: 0,
        known: 0,
        goes_on: false,
    };

    /// The run of these items, the first four of them.
    pub(super) fn of(geometry: &Geometry<'_>, items: &[Slot], goes_on: bool) -> Self {
        let mut run = Run { goes_on, ..Run::EMPTY };
        for ((place, slot), item) in run.items.iter_mut().enumerate().zip(items) {
            *slot = *item;
            run.filled |= 1 << place;
            if let Some(Shape::Triangle(corners) | Shape::SmoothTriangle(corners)) =
                geometry.shape(item.item())
                && let Some(corners) = geometry.corners(*corners)
            {
                run.triangles.put(place, corners);
                run.known |= 1 << place;
            }
        }
        run
    }

    /// Its items.
    pub fn items(&self) -> impl Iterator<Item = ItemId> + '_ {
        self.picked(u32::MAX)
    }

    /// Bits for those items that the ray may meet; the others it certainly does not.
    #[inline(always)]
    pub(crate) fn may_meet(&self, ray: &Ray) -> u32 {
        let known = u32::from(self.known);
        let may = if known == 0 { 0 } else { self.triangles.may_meet(ray) };
        u32::from(self.filled) & (may | !known)
    }

    /// The items whose bits are set. It takes as many steps for any bits: where nothing is done
    /// with the items, nothing is left of it.
    #[inline(always)]
    pub(crate) fn picked(&self, bits: u32) -> impl Iterator<Item = ItemId> + '_ {
        let bits = bits & u32::from(self.filled);
        self.items
            .iter()
            .zip(0..)
            .filter(move |(_, place)| bits >> place & 1 != 0)
            .map(|(slot, _)| slot.item())
    }

    /// The first of the items whose bits are left; its bit is taken away. No iterator: those
    /// are moved about in memory, and most runs have one candidate or none.
    #[inline(always)]
    pub(crate) fn next(&self, left: &mut u32) -> Option<Candidate> {
        let place = left.trailing_zeros();
        let slot = self.items.get(place as usize)?;
        *left &= *left - 1;
        let is_known = u32::from(self.known) >> place & 1 != 0;
        let corners = if is_known { self.triangles.corners(place as usize) } else { None };
        Some(Candidate { item: slot.item(), corners })
    }

    #[inline(always)]
    pub(super) const fn goes_on(&self) -> bool {
        self.goes_on
    }
}
