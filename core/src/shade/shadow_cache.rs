//! Shadow cache: the last occluder of a light is tested first.
//!
//! Neighboring points usually lie in the shadow of the same item. If the last occluder still occludes the
//! light, no traversal is needed; if not, one test was superfluous. After an unoccluded shadow ray, nothing
//! is tested first. The occluder is tested with the same function against the same ray, so the cache never
//! changes a result.
//!
//! Shadow rays that pass through transmitting surfaces do not use the cache: their transmittance is found
//! surface by surface, and testing out of order could change the result where surfaces nearly touch.
//!
//! Source: Haines and Greenberg, "The Light Buffer: A Shadow-Testing Accelerator", IEEE CG&A 1986.
//! Difference: entries per light and ray level.

use crate::accel::Accelerator;
use crate::geometry::ItemId;

/// A direct-mapped cache of the last occluder of each light, per ray level.
///
/// Entry `i` serves all pairs of light and level whose number is `i` modulo `ENTRIES`; a later pair evicts an
/// earlier one. A wrong entry costs one test and never changes a result.
///
/// * `ENTRIES` is zero (no cache) or a power of two, checked at compile time.
/// * Memory: 4 bytes per entry.
#[derive(Clone, Debug)]
pub(crate) struct ShadowCache<const ENTRIES: usize> {
    occluders: [ItemId; ENTRIES],
    is_enabled: bool,
}

/// The caches of a worker: memory that is kept between rays and changes nothing but the time.
///
/// `ENTRIES`: size of the shadow cache.
pub(crate) struct WorkerCaches<A: Accelerator, const ENTRIES: usize> {
    /// Scratch memory of the accelerator.
    pub(crate) scratch: A::Scratch,
    /// The last occluders.
    pub(crate) shadow_cache: ShadowCache<ENTRIES>,
}

impl<A: Accelerator, const ENTRIES: usize> WorkerCaches<A, ENTRIES> {
    /// Empty caches.
    pub(crate) fn new() -> Self {
        WorkerCaches { scratch: A::Scratch::default(), shadow_cache: ShadowCache::EMPTY }
    }

    /// Empties the caches. A disabled shadow cache stays disabled.
    pub(crate) fn clear(&mut self) {
        self.scratch = A::Scratch::default();
        self.shadow_cache.occluders = ShadowCache::EMPTY.occluders;
    }
}

/// What a shadow cache entry is looked up by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowCacheKey {
    /// Index of the light in the scene.
    pub(crate) light: usize,
    /// Level of the ray that hit the shaded point.
    pub(crate) level: u8,
}

/// Marks an empty entry: no item has the highest id.
const NO_ITEM: ItemId = ItemId(u32::MAX);

/// Entries per light: levels that differ modulo this number do not evict each other in a large cache.
const LEVELS_PER_LIGHT: usize = 8;

impl<const ENTRIES: usize> ShadowCache<ENTRIES> {
    /// An empty, enabled cache.
    pub(crate) const EMPTY: Self = {
        const { assert!(ENTRIES == 0 || ENTRIES.is_power_of_two()) };
        ShadowCache { occluders: [NO_ITEM; ENTRIES], is_enabled: ENTRIES > 0 }
    };

    /// Empties the cache and ignores later insertions.
    pub(crate) fn disable(&mut self) {
        *self = ShadowCache { is_enabled: false, ..Self::EMPTY };
    }

    /// The occluder to test first, if there is one.
    pub(crate) fn last_occluder(&self, key: ShadowCacheKey) -> Option<ItemId> {
        self.occluders.get(Self::index(key)).copied().filter(|item| *item != NO_ITEM)
    }

    /// Stores the last occluder.
    pub(crate) fn insert(&mut self, key: ShadowCacheKey, item: ItemId) {
        if self.is_enabled
            && let Some(entry) = self.occluders.get_mut(Self::index(key))
        {
            *entry = item;
        }
    }

    /// Removes the entry, because the light is not occluded.
    pub(crate) fn remove(&mut self, key: ShadowCacheKey) {
        self.insert(key, NO_ITEM);
    }

    /// Index of the entry; out of range if there are no entries.
    fn index(key: ShadowCacheKey) -> usize {
        let hash =
            key.light.wrapping_mul(LEVELS_PER_LIGHT).wrapping_add(usize::from(key.level) % LEVELS_PER_LIGHT);
        if ENTRIES > 0 { hash % ENTRIES } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn occluders_are_stored_per_light_and_level() {
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
    fn an_empty_or_disabled_cache_returns_no_occluder() {
        let mut cache = ShadowCache::<0>::EMPTY;
        let key = ShadowCacheKey { light: 0, level: 1 };
        cache.insert(key, ItemId(7));
        assert_eq!(cache.last_occluder(key), None);
        let mut cache = ShadowCache::<16>::EMPTY;
        cache.disable();
        cache.insert(key, ItemId(7));
        assert_eq!(cache.last_occluder(key), None);
    }
}
