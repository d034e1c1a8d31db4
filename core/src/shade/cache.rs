//! Shadow cache: who stood in the way of a light is asked first the next time.
//!
//! Neighbouring points lie in the shadow of the same thing. If that still stands in the way,
//! the point is dark and nothing needs to be looked for; if it does not, one test was in vain.
//! Where light arrived the last time nobody is asked.
//! It is the same test of the same ray, so that the answer is the same either way ("The Light
//! Buffer: A Shadow-Testing Accelerator", Haines and Greenberg, 1986, has the idea).
//!
//! Where light passes through glass nobody is remembered: how much arrives is found surface by
//! surface, and to ask out of turn could give another answer where surfaces nearly touch.

use crate::accel::Accelerator;
use crate::geometry::ItemId;

/// Who stood last in the way of each light, for each level of rays.
///
/// Slot `i` serves every light and level whose number is `i` modulo `SLOTS`; a later one
/// replaces an earlier one. It may ask the wrong item, which costs a test and no truth.
///
/// * Shape: `SLOTS` is zero, which remembers nothing, or a power of two; checked when compiled.
/// * Memory: 4 bytes for each slot.
#[derive(Clone, Debug)]
pub(crate) struct ShadowCache<const SLOTS: usize> {
    blockers: [ItemId; SLOTS],
    is_used: bool,
}

/// What is remembered between rays: by the accelerator, and of shadows.
pub(crate) struct Memory<A: Accelerator, const SHADOWS: usize> {
    pub(crate) scratch: A::Scratch,
    pub(crate) shadows: ShadowCache<SHADOWS>,
}

impl<A: Accelerator, const SHADOWS: usize> Memory<A, SHADOWS> {
    pub(crate) fn new() -> Self {
        Memory { scratch: A::Scratch::default(), shadows: ShadowCache::EMPTY }
    }

    /// As new, but no cache is used that was not used before.
    pub(crate) fn forget(&mut self) {
        self.scratch = A::Scratch::default();
        self.shadows.blockers = ShadowCache::EMPTY.blockers;
    }
}

/// From a surface that a ray of some level has met to a light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Toward {
    /// Which light.
    pub(crate) light: usize,
    /// The level of the ray.
    pub(crate) level: u8,
}

/// No item has the highest number.
const NOBODY: ItemId = ItemId(u32::MAX);

/// Levels that do not share a slot while there are slots enough.
const LEVELS_APART: usize = 8;

impl<const SLOTS: usize> ShadowCache<SLOTS> {
    pub(crate) const EMPTY: Self = {
        const { assert!(SLOTS == 0 || SLOTS.is_power_of_two()) };
        ShadowCache { blockers: [NOBODY; SLOTS], is_used: SLOTS > 0 }
    };

    /// Remembers nobody from now on.
    pub(crate) fn turn_off(&mut self) {
        *self = ShadowCache { is_used: false, ..Self::EMPTY };
    }

    /// Who is to be asked first.
    pub(crate) fn last(&self, toward: Toward) -> Option<ItemId> {
        self.blockers.get(Self::slot(toward)).copied().filter(|item| *item != NOBODY)
    }

    /// Remembers who stands in the way.
    pub(crate) fn remember(&mut self, toward: Toward, item: ItemId) {
        if self.is_used
            && let Some(slot) = self.blockers.get_mut(Self::slot(toward))
        {
            *slot = item;
        }
    }

    /// Light arrives: nobody is to be asked the next time.
    pub(crate) fn forget(&mut self, toward: Toward) {
        self.remember(toward, NOBODY);
    }

    /// Without slots, a place that is not there.
    fn slot(toward: Toward) -> usize {
        let number =
            toward.light.wrapping_mul(LEVELS_APART).wrapping_add(usize::from(toward.level) % LEVELS_APART);
        if SLOTS > 0 { number % SLOTS } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_light_has_its_own_blocker_on_each_level() {
        let mut cache = ShadowCache::<16>::EMPTY;
        let [a, b] = [Toward { light: 0, level: 1 }, Toward { light: 1, level: 1 }];
        cache.remember(a, ItemId(7));
        assert_eq!((cache.last(a), cache.last(b)), (Some(ItemId(7)), None));
        cache.remember(b, ItemId(8));
        cache.remember(Toward { level: 2, ..a }, ItemId(9));
        assert_eq!((cache.last(a), cache.last(b)), (Some(ItemId(7)), Some(ItemId(8))));
        cache.forget(a);
        assert_eq!((cache.last(a), cache.last(b)), (None, Some(ItemId(8))));
    }

    #[test]
    fn a_cache_without_slots_or_turned_off_remembers_nobody() {
        let mut cache = ShadowCache::<0>::EMPTY;
        let toward = Toward { light: 0, level: 1 };
        cache.remember(toward, ItemId(7));
        assert_eq!(cache.last(toward), None);
        let mut cache = ShadowCache::<16>::EMPTY;
        cache.turn_off();
        cache.remember(toward, ItemId(7));
        assert_eq!(cache.last(toward), None);
    }
}
