//! Mailboxes: an item that lies in many regions is tested once for each ray.
//!
//! A walk through regions meets an item in each region that it lies in. The lecture's first case
//! is that it was tested before: the mailbox knows, and the test is left out. The second case is
//! that the test found a hit *beyond* the region: the query keeps it and shortens its reach, the
//! walk goes on as long as regions begin within that reach, and nothing is lost when the item
//! turns up again in the region of the hit and the mailbox leaves it out.
//!
//! On the standard procedural databases 64 slots save a grid up to 36 % of its time (mount: 1.84
//! tests of shapes for each ray, and 5.46 without; gears 9 %, rings 8 %, teapot 13 %, balls none)
//! and an octree 6 to 16 %. 8 slots save nearly nothing: neighbours drive each other out.

use core::ops::ControlFlow;

use super::Query;
use crate::geometry::{Aabb, ItemId, Ray};
use crate::math::Real;

/// What a slot knows: the last item that came to it, and with which ray.
#[derive(Clone, Copy, Debug)]
struct Slot {
    item: u32,
    ray: u32,
}

/// No ray has this stamp.
const NO_RAY: u32 = 0;

/// A fixed number of slots that remember which items this ray has met.
///
/// Slot `i` serves all items whose number is `i` modulo `SLOTS`; a later item replaces an
/// earlier one. The mailbox may therefore forget, and an item is tested again, but it never
/// claims a meeting that did not happen. A new ray costs one addition, not a wipe: what earlier
/// rays have left carries their stamp. Only when the stamps run out are the slots wiped.
///
/// * Shape: `SLOTS` is zero or a power of two, checked when compiled. Zero forgets everything.
/// * Memory: 8 bytes per slot, and 4 for the stamp.
#[derive(Clone, Debug)]
pub struct Mailbox<const SLOTS: usize> {
    /// The stamp of the ray that is on its way.
    ray: u32,
    slots: [Slot; SLOTS],
}

impl<const SLOTS: usize> Mailbox<SLOTS> {
    /// A mailbox that has met nothing.
    pub const fn new() -> Self {
        const { assert!(SLOTS == 0 || SLOTS.is_power_of_two()) };
        Mailbox { ray: NO_RAY, slots: [Slot { item: 0, ray: NO_RAY }; SLOTS] }
    }

    /// Forgets every meeting.
    pub fn forget(&mut self) {
        *self = Self::new();
    }

    /// A new ray, which has met nothing.
    #[inline]
    pub(super) fn begin(&mut self) {
        if self.ray == u32::MAX {
            self.forget();
        }
        self.ray += 1;
    }

    /// Whether this ray has surely met the item before. It has now.
    #[inline(always)]
    pub(super) fn has_met(&mut self, item: u32) -> bool {
        if SLOTS == 0 {
            return false;
        }
        let place = item as usize & (SLOTS.wrapping_sub(1));
        let Some(slot) = self.slots.get_mut(place) else { return false };
        let met = slot.ray == self.ray && slot.item == item;
        *slot = Slot { item, ray: self.ray };
        met
    }
}

impl<const SLOTS: usize> Default for Mailbox<SLOTS> {
    fn default() -> Self {
        Self::new()
    }
}

/// A query that a ray walks for, and what the ray has met.
pub(super) struct Asking<'a, Q, const SLOTS: usize> {
    pub(super) ray: &'a Ray,
    /// Those of all items, or none.
    pub(super) boxes: &'a [Aabb],
    pub(super) mailbox: &'a mut Mailbox<SLOTS>,
    pub(super) query: &'a mut Q,
}

impl<Q: Query, const SLOTS: usize> Asking<'_, Q, SLOTS> {
    /// Offers the items of a region to the query, but those that the ray has met before and those
    /// whose box it misses. Goes on with the reach that is left.
    #[inline(always)]
    pub(super) fn offer(&mut self, items: &[u32]) -> ControlFlow<(), Real> {
        self.query.enter();
        for item in items {
            if self.mailbox.has_met(*item) {
                self.query.skipped();
                continue;
            }
            if let Some(aabb) = self.boxes.get(*item as usize) {
                self.query.boxes(1);
                // Strictly beyond: an item at the same distance may have the lower number, and must win.
                if !aabb.span(self.ray).is_some_and(|span| span.entry <= self.query.reach()) {
                    continue;
                }
            }
            self.query.test(ItemId(*item))?;
        }
        ControlFlow::Continue(self.query.reach())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_item_is_met_once_by_each_ray() {
        let mut mailbox = Mailbox::<8>::new();
        for _ in 0..3 {
            mailbox.begin();
            assert!(!mailbox.has_met(5) && !mailbox.has_met(0));
            assert!(mailbox.has_met(5) && mailbox.has_met(0) && mailbox.has_met(5));
        }
    }

    #[test]
    fn an_item_of_the_same_slot_drives_another_out_and_neither_is_mistaken() {
        let mut mailbox = Mailbox::<8>::new();
        mailbox.begin();
        assert!(!mailbox.has_met(3) && !mailbox.has_met(11) && !mailbox.has_met(3));
        assert!(mailbox.has_met(3) && !mailbox.has_met(19));
        let mut single = Mailbox::<1>::new();
        single.begin();
        assert!(!single.has_met(u32::MAX) && single.has_met(u32::MAX) && !single.has_met(0));
    }

    #[test]
    fn without_slots_nothing_is_remembered() {
        let mut mailbox = Mailbox::<0>::new();
        mailbox.begin();
        assert!((0..4).all(|_| !mailbox.has_met(0)));
        assert_eq!(size_of::<Mailbox<0>>(), 4);
        assert_eq!(size_of::<Mailbox<64>>(), 4 + 64 * 8);
    }

    #[test]
    fn nothing_is_met_that_a_forgotten_ray_has_met() {
        let mut mailbox = Mailbox::<8>::new();
        mailbox.begin();
        assert!(!mailbox.has_met(5));
        mailbox.forget();
        mailbox.begin();
        assert!(!mailbox.has_met(5));
    }

    #[test]
    fn when_the_stamps_run_out_no_ray_is_taken_for_an_earlier_one() {
        let mut mailbox = Mailbox::<4>::new();
        // As the first two rays would have left it.
        for ray in 1..=2 {
            mailbox.begin();
            assert_eq!(mailbox.ray, ray);
            assert!(!mailbox.has_met(ray));
        }
        mailbox.ray = u32::MAX - 2;
        for round in 0..6 {
            mailbox.begin();
            assert!(mailbox.ray != NO_RAY);
            assert!((0..4).all(|item| !mailbox.has_met(item)), "{round}");
            assert!((0..4).all(|item| mailbox.has_met(item)), "{round}");
        }
        assert_eq!(mailbox.ray, 4, "the stamps have begun again");
    }
}
