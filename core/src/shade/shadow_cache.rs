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
    occluders: [ItemId; SLOTS],
    is_enabled: bool,
}

/// What is remembered between rays: by the accelerator, and of shadows.
pub(crate) struct WorkerCaches<A: Accelerator, const SHADOWS: usize> {
    pub(crate) scratch: A::Scratch,
    pub(crate) shadow_cache: ShadowCache<SHADOWS>,
}

impl<A: Accelerator, const SHADOWS: usize> WorkerCaches<A, SHADOWS> {
    pub(crate) fn new() -> Self {
        WorkerCaches { scratch: A::Scratch::default(), shadow_cache: ShadowCache::EMPTY }
    }

    /// As new, but no cache is used that was not used before.
    pub(crate) fn clear(&mut self) {
        self.scratch = A::Scratch::default();
        self.shadow_cache.occluders = ShadowCache::EMPTY.occluders;
    }
}

/// From a surface that a ray of some level has met to a light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowCacheKey {
    /// Which light.
    pub(crate) light: usize,
    /// The level of the ray.
    pub(crate) level: u8,
}

/// No item has the highest number.
const NO_ITEM: ItemId = ItemId(u32::MAX);

/// Levels that do not share a slot while there are slots enough.
const LEVELS_PER_LIGHT: usize = 8;

impl<const SLOTS: usize> ShadowCache<SLOTS> {
    pub(crate) const EMPTY: Self = {
        const { assert!(SLOTS == 0 || SLOTS.is_power_of_two()) };
        ShadowCache { occluders: [NO_ITEM; SLOTS], is_enabled: SLOTS > 0 }
    };

    /// Remembers nobody from now on.
    pub(crate) fn disable(&mut self) {
        *self = ShadowCache { is_enabled: false, ..Self::EMPTY };
    }

    /// Who is to be asked first.
    pub(crate) fn last_occluder(&self, toward: ShadowCacheKey) -> Option<ItemId> {
        self.occluders.get(Self::index(toward)).copied().filter(|item| *item != NO_ITEM)
    }

    /// Remembers who stands in the way.
    pub(crate) fn insert(&mut self, toward: ShadowCacheKey, item: ItemId) {
        if self.is_enabled
            && let Some(slot) = self.occluders.get_mut(Self::index(toward))
        {
            *slot = item;
        }
    }

    /// Light arrives: nobody is to be asked the next time.
    pub(crate) fn remove(&mut self, toward: ShadowCacheKey) {
        self.insert(toward, NO_ITEM);
    }

    /// Without slots, a place that is not there.
    fn index(toward: ShadowCacheKey) -> usize {
        let number = toward
            .light
            .wrapping_mul(LEVELS_PER_LIGHT)
            .wrapping_add(usize::from(toward.level) % LEVELS_PER_LIGHT);
        if SLOTS > 0 { number % SLOTS } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_light_has_its_own_blocker_on_each_level() {
        let mut cache = ShadowCache::<16>::EMPTY;
        let [a, b] = [ShadowCacheKey { light: 0, level: 1 }, ShadowCacheKey { light: 1, level: 1 }];
        cache.insert(a, ItemId(7));
        assert_eq!((cache.last_occluder(a), cache.last_occluder(b)), (Some(ItemId(7)), None));
        cache.insert(b, ItemId(8));
        cache.insert(ShadowCacheKey { level: 2, ..a }, ItemId(9));
        assert_eq!((cache.last_occluder(a), cache.last_occluder(b)), (Some(ItemId(7)), Some(ItemId(8))));
        cache.remove(a);
        assert_eq!((cache.last_occluder(a), cache.last_occluder(b)), (None, Some(ItemId(8))));
    }

    #[test]
    fn a_cache_without_slots_or_turned_off_remembers_nobody() {
        let mut cache = ShadowCache::<0>::EMPTY;
        let toward = ShadowCacheKey { light: 0, level: 1 };
        cache.insert(toward, ItemId(7));
        assert_eq!(cache.last_occluder(toward), None);
        let mut cache = ShadowCache::<16>::EMPTY;
        cache.disable();
        cache.insert(toward, ItemId(7));
        assert_eq!(cache.last_occluder(toward), None);
    }
}
