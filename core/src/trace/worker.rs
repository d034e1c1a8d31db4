//! All that changes while a picture is traced.

use super::task::TaskStack;
use crate::accel::Accelerator;
use crate::shade::WorkerCaches;

/// What one thread of control needs beside the world, which all share.
///
/// Nothing in it changes a picture: a worker that is made anew for every pixel gives the same.
/// `LEVELS` is how many levels of rays there is room for, 1 to 64; `SHADOW_CACHE_ENTRIES` how many slots
/// the shadow cache has, zero (no cache) or a power of two.
pub struct Worker<A: Accelerator, T, const LEVELS: usize, const SHADOW_CACHE_ENTRIES: usize = 16> {
    pub(super) caches: WorkerCaches<A, SHADOW_CACHE_ENTRIES>,
    pub(super) tasks: TaskStack<LEVELS>,
    pub(super) tally: T,
}

impl<A: Accelerator, T, const LEVELS: usize> Worker<A, T, LEVELS> {
    /// A worker with a shadow cache of the usual size, that reports to `tally`.
    pub fn new(tally: T) -> Self {
        Worker::with_cache_size(tally)
    }
}

impl<A: Accelerator, T, const LEVELS: usize, const SHADOW_CACHE_ENTRIES: usize>
    Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>
{
    /// How many bytes one takes, known when compiling: a task for each
    /// level, what the accelerator's walk remembers, 4 for each slot of the shadow cache, and the
    /// tally.
    pub const SIZE_IN_BYTES: usize = size_of::<Self>();

    /// A worker with a shadow cache of `SHADOW_CACHE_ENTRIES` slots, that reports to `tally`.
    pub fn with_cache_size(tally: T) -> Self {
        Worker { caches: WorkerCaches::new(), tasks: TaskStack::new(), tally }
    }

    /// Turns the shadow cache off: nobody is asked first whether he still stands in the light.
    pub fn without_shadow_cache(mut self) -> Self {
        self.caches.shadow_cache.disable();
        self
    }

    /// Who has been told.
    pub fn tally(&self) -> &T {
        &self.tally
    }

    /// Who has been told, to be emptied or exchanged.
    pub fn tally_mut(&mut self) -> &mut T {
        &mut self.tally
    }

    /// Who has been told, when the work is done.
    pub fn into_tally(self) -> T {
        self.tally
    }

    /// Forgets all that it remembers of earlier rays, so that the work that follows does not depend on
    /// what was traced before. The tally stays as it is.
    pub fn clear_caches(&mut self) {
        self.caches.clear();
    }
}
