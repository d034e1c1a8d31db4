//! What was seen at places in the picture, kept in lent memory.

use crate::trace::PixelSample;

/// A place and what was seen there.
#[derive(Clone, Copy, Debug)]
pub struct CacheEntry {
    key: Option<(u32, u32)>,
    sample: PixelSample,
}

impl CacheEntry {
    /// Nothing yet.
    pub const EMPTY: CacheEntry = CacheEntry { key: None, sample: PixelSample::BLACK };
}

/// A table of places. Each has one slot, which it shares with others: the later replaces the
/// earlier. So it may forget, and a place is traced again, but never takes one for another.
#[derive(Debug)]
pub(super) struct SampleCache<'m>(&'m mut [CacheEntry]);

impl<'m> SampleCache<'m> {
    pub(super) fn new(lent: &'m mut [CacheEntry]) -> Self {
        let mut memory = SampleCache(lent);
        memory.clear();
        memory
    }

    pub(super) fn clear(&mut self) {
        self.0.fill(CacheEntry::EMPTY);
    }

    /// What is seen at a place: what was kept, else what `trace` sees.
    pub(super) fn get_or_trace(
        &mut self,
        x: u32,
        y: u32,
        trace: impl FnOnce() -> PixelSample,
    ) -> PixelSample {
        let place = Some((x, y));
        let slot = index_of(x, y, self.0.len());
        match self.0.get_mut(slot) {
            None => trace(),
            Some(kept) if kept.key == place => kept.sample,
            Some(kept) => {
                let sample = trace();
                *kept = CacheEntry { key: place, sample };
                sample
            }
        }
    }
}

/// The slot of a place, by multiplicative hashing (Knuth): neighbours in every direction come
/// to lie apart.
fn index_of(x: u32, y: u32, slots: usize) -> usize {
    let hash = x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77).rotate_left(16);
    let hash = (hash ^ hash >> 15).wrapping_mul(0xc2b2_ae3d);
    // The upper bits are the good ones: a fraction of the table.
    ((u64::from(hash) * slots as u64) >> 32) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Real, Rgb};
    use crate::trace::HitId;

    #[test]
    fn what_is_kept_is_never_taken_for_another_place() {
        for slots in [0, 1, 2, 7, 64] {
            let mut lent = [CacheEntry::EMPTY; 64];
            let mut memory = SampleCache::new(&mut lent[..slots]);
            let mut traced = 0;
            for round in 0..3 {
                for x in 0..8 {
                    for y in 0..8 {
                        let truth =
                            PixelSample { color: Rgb::gray((8 * x + y) as Real), hit: HitId::Nothing };
                        let seen = memory.get_or_trace(x, y, || {
                            traced += 1;
                            truth
                        });
                        assert_eq!(seen, truth, "{slots} {round}");
                        // At once again: nothing came between.
                        memory.get_or_trace(x, y, || {
                            assert_eq!(slots, 0);
                            truth
                        });
                    }
                }
            }
            assert!(traced >= 64 && traced <= 192, "{slots}");
        }
    }
}
