//! A direct-mapped cache of samples by their grid coordinates, in a caller-provided buffer.

use crate::trace::PixelSample;

/// An entry of the sample cache of an [`AdaptiveSampler`](super::AdaptiveSampler) or a
/// [`PixelSelector`](super::PixelSelector): grid coordinates and the sample there.
#[derive(Clone, Copy, Debug)]
pub struct CacheEntry {
    key: Option<(u32, u32)>,
    sample: PixelSample,
}

impl CacheEntry {
    /// The empty entry, the initial value for buffers.
    pub const EMPTY: CacheEntry = CacheEntry { key: None, sample: PixelSample::BLACK };
}

/// A direct-mapped cache of samples.
///
/// Coordinates with the same hash share an entry, and the later evicts the earlier. An evicted sample is
/// traced again, so the cache never changes a result.
#[derive(Debug)]
pub(super) struct SampleCache<'m>(&'m mut [CacheEntry]);

impl<'m> SampleCache<'m> {
    pub(super) fn new(entries: &'m mut [CacheEntry]) -> Self {
        let mut cache = SampleCache(entries);
        cache.clear();
        cache
    }

    pub(super) fn clear(&mut self) {
        self.0.fill(CacheEntry::EMPTY);
    }

    /// The sample at these coordinates: the cached one, otherwise that of `trace`, which is cached.
    pub(super) fn get_or_trace(
        &mut self,
        x: u32,
        y: u32,
        trace: impl FnOnce() -> PixelSample,
    ) -> PixelSample {
        let key = Some((x, y));
        let index = index_of(x, y, self.0.len());
        match self.0.get_mut(index) {
            None => trace(),
            Some(entry) if entry.key == key => entry.sample,
            Some(entry) => {
                let sample = trace();
                *entry = CacheEntry { key, sample };
                sample
            }
        }
    }
}

/// Index of the entry of these coordinates, by multiplicative hashing (Knuth). Neighbors get distant entries.
fn index_of(x: u32, y: u32, length: usize) -> usize {
    let hash = x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77).rotate_left(16);
    let hash = (hash ^ hash >> 15).wrapping_mul(0xc2b2_ae3d);
    // The upper bits are the better ones, so the hash is scaled instead of reduced modulo the length.
    ((u64::from(hash) * length as u64) >> 32) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Real, Rgb};
    use crate::trace::HitId;

    #[test]
    fn a_cached_sample_is_never_returned_for_another_key() {
        for length in [0, 1, 2, 7, 64] {
            let mut entries = [CacheEntry::EMPTY; 64];
            let mut cache = SampleCache::new(&mut entries[..length]);
            let mut traced = 0;
            for round in 0..3 {
                for x in 0..8 {
                    for y in 0..8 {
                        let expected =
                            PixelSample { color: Rgb::gray((8 * x + y) as Real), hit: HitId::Nothing };
                        let found = cache.get_or_trace(x, y, || {
                            traced += 1;
                            expected
                        });
                        assert_eq!(found, expected, "{length} {round}");
                        // Immediately again: the entry has not been evicted.
                        cache.get_or_trace(x, y, || {
                            assert_eq!(length, 0);
                            expected
                        });
                    }
                }
            }
            assert!(traced >= 64 && traced <= 192, "{length}");
        }
    }
}
