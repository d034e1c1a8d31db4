//! Mailbox: a small per-ray cache of tested items.
//!
//! Grid and octree list an item in every cell that its bounds overlap, so that a ray comes across the same
//! item several times. The mailbox lets [`MailboxQuery`] leave out the repeated tests. This is safe: if the
//! first test found a hit *beyond* the current cell, the query has kept the hit and shortened `t_max` to it.
//! The traversal continues through the cells that begin within `t_max`, and the item need not be tested again
//! in the cell of the hit.
//!
//! Neighboring items evict each other from a small mailbox: 8 entries save almost no time, 64 do.
//!
//! Source: Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987
//! (ray stamps).
//! Difference: the stamps are in a table of fixed size instead of in the items, which stay immutable.

use core::ops::ControlFlow;

use super::Query;
use crate::geometry::{Aabb, ItemId, Ray};
use crate::math::Real;

/// The last item that was stored in an entry, and the stamp of the ray that was tested against it.
#[derive(Clone, Copy, Debug)]
struct MailboxEntry {
    item: u32,
    ray_stamp: u32,
}

/// A stamp that no ray has.
const UNUSED_STAMP: u32 = 0;

/// A direct-mapped cache of the items that the current ray has already been tested against.
///
/// Entry `i` serves all items whose id is `i` modulo `ENTRIES`; a later item evicts an earlier one. An
/// evicted item is tested again, so the cache never changes a result. The accelerator starts each ray
/// itself, at the cost of one addition and without a clear: the entries of earlier rays carry other stamps.
///
/// * `ENTRIES` is zero (no cache) or a power of two, checked at compile time.
/// * Memory: 8 bytes per entry, and 4 bytes for the stamp.
#[derive(Clone, Debug)]
pub struct Mailbox<const ENTRIES: usize> {
    /// Stamp of the current ray.
    ray_stamp: u32,
    entries: [MailboxEntry; ENTRIES],
}

impl<const ENTRIES: usize> Mailbox<ENTRIES> {
    /// An empty mailbox.
    pub const fn new() -> Self {
        const { assert!(ENTRIES == 0 || ENTRIES.is_power_of_two()) };
        let unused = MailboxEntry { item: 0, ray_stamp: UNUSED_STAMP };
        Mailbox { ray_stamp: UNUSED_STAMP, entries: [unused; ENTRIES] }
    }

    /// Removes all entries. Needed only when the stamps wrap around.
    pub(super) fn clear(&mut self) {
        *self = Self::new();
    }

    /// Starts a new ray, which has been tested against no item.
    #[inline]
    pub(super) fn begin_ray(&mut self) {
        if self.ray_stamp == u32::MAX {
            self.clear();
        }
        self.ray_stamp += 1;
    }

    /// Stores `item` for the current ray. Returns true if it was stored already, so that its test can be left
    /// out; an item that was evicted in between counts as not stored.
    #[inline(always)]
    pub(super) fn check_and_insert(&mut self, item: u32) -> bool {
        if ENTRIES == 0 {
            return false;
        }
        let index = item as usize & (ENTRIES.wrapping_sub(1));
        let Some(entry) = self.entries.get_mut(index) else { return false };
        let was_stored = entry.ray_stamp == self.ray_stamp && entry.item == item;
        *entry = MailboxEntry { item, ray_stamp: self.ray_stamp };
        was_stored
    }
}

impl<const ENTRIES: usize> Default for Mailbox<ENTRIES> {
    fn default() -> Self {
        Self::new()
    }
}

/// A query behind a mailbox: it tests only items that are new to the ray and whose bounds the ray hits.
pub(super) struct MailboxQuery<'a, Q, const ENTRIES: usize> {
    pub(super) ray: &'a Ray,
    /// Bounds by item index, or empty: then items are tested without a test of their bounds.
    pub(super) item_bounds: &'a [Aabb],
    pub(super) mailbox: &'a mut Mailbox<ENTRIES>,
    pub(super) query: &'a mut Q,
}

impl<Q: Query, const ENTRIES: usize> MailboxQuery<'_, Q, ENTRIES> {
    /// Tests the items of one cell. Continues with the remaining `t_max`.
    #[inline(always)]
    pub(super) fn test_items(&mut self, items: &[u32]) -> ControlFlow<(), Real> {
        self.query.count_leaf_visit();
        for item in items {
            if self.mailbox.check_and_insert(*item) {
                self.query.count_mailbox_hit();
                continue;
            }
            if let Some(aabb) = self.item_bounds.get(*item as usize) {
                self.query.count_box_tests(1);
                // Only if strictly beyond: at equal `t` the item with the lower id wins, and it may be this
                // one.
                if !aabb.intersect(self.ray).is_some_and(|span| span.t_entry <= self.query.t_max()) {
                    continue;
                }
            }
            self.query.test_item(ItemId(*item))?;
        }
        ControlFlow::Continue(self.query.t_max())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_item_is_tested_once_per_ray() {
        let mut mailbox = Mailbox::<8>::new();
        for _ in 0..3 {
            mailbox.begin_ray();
            assert!(!mailbox.check_and_insert(5) && !mailbox.check_and_insert(0));
            assert!(
                mailbox.check_and_insert(5) && mailbox.check_and_insert(0) && mailbox.check_and_insert(5)
            );
        }
    }

    #[test]
    fn items_of_one_entry_evict_each_other_and_are_never_confused() {
        let mut mailbox = Mailbox::<8>::new();
        mailbox.begin_ray();
        assert!(
            !mailbox.check_and_insert(3) && !mailbox.check_and_insert(11) && !mailbox.check_and_insert(3)
        );
        assert!(mailbox.check_and_insert(3) && !mailbox.check_and_insert(19));
        let mut single = Mailbox::<1>::new();
        single.begin_ray();
        assert!(!single.check_and_insert(u32::MAX) && single.check_and_insert(u32::MAX));
        assert!(!single.check_and_insert(0));
    }

    #[test]
    fn a_mailbox_without_entries_never_skips_a_test() {
        let mut mailbox = Mailbox::<0>::new();
        mailbox.begin_ray();
        assert!((0..4).all(|_| !mailbox.check_and_insert(0)));
        assert_eq!(size_of::<Mailbox<0>>(), 4);
        assert_eq!(size_of::<Mailbox<64>>(), 4 + 64 * 8);
    }

    #[test]
    fn a_cleared_mailbox_skips_no_test() {
        let mut mailbox = Mailbox::<8>::new();
        mailbox.begin_ray();
        assert!(!mailbox.check_and_insert(5));
        mailbox.clear();
        mailbox.begin_ray();
        assert!(!mailbox.check_and_insert(5));
    }

    #[test]
    fn no_ray_is_confused_with_an_earlier_one_when_the_stamps_wrap_around() {
        let mut mailbox = Mailbox::<4>::new();
        // The state that the first two rays leave.
        for stamp in 1..=2 {
            mailbox.begin_ray();
            assert_eq!(mailbox.ray_stamp, stamp);
            assert!(!mailbox.check_and_insert(stamp));
        }
        mailbox.ray_stamp = u32::MAX - 2;
        for ray in 0..6 {
            mailbox.begin_ray();
            assert!(mailbox.ray_stamp != UNUSED_STAMP);
            assert!((0..4).all(|item| !mailbox.check_and_insert(item)), "{ray}");
            assert!((0..4).all(|item| mailbox.check_and_insert(item)), "{ray}");
        }
        assert_eq!(mailbox.ray_stamp, 4, "the stamps have started again");
    }
}
