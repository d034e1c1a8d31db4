//! The memory that changes while a picture is traced.

use super::task::TaskStack;
use crate::accel::Accelerator;
use crate::shade::WorkerCaches;

/// The mutable memory of one thread that traces: caches, the stack of rays, and a tally.
///
/// Its content never changes a picture: a new worker for every pixel gives the same pixels. It has a fixed
/// size and does not allocate.
///
/// * `T`: tally that receives events, or `()`.
/// * `LEVELS`: largest number of ray levels, 1 to 64.
/// * `SHADOW_CACHE_ENTRIES`: size of the shadow cache: zero (no cache) or a power of two.
///
/// ```
/// use strahl_core::tally::Counters;
/// use strahl_core::{ListWithoutBounds, Worker};
///
/// let worker = Worker::<ListWithoutBounds, _, 5>::new(Counters::new());
/// assert_eq!(worker.into_tally().rays.sum(), 0);
///
/// // The size is known at compile time.
/// const _: () = assert!(Worker::<ListWithoutBounds, (), 5>::SIZE_IN_BYTES < 1024);
/// ```
pub struct Worker<A: Accelerator, T, const LEVELS: usize, const SHADOW_CACHE_ENTRIES: usize = 16> {
    pub(super) caches: WorkerCaches<A, SHADOW_CACHE_ENTRIES>,
    pub(super) tasks: TaskStack<LEVELS>,
    pub(super) tally: T,
}

impl<A: Accelerator, T, const LEVELS: usize> Worker<A, T, LEVELS> {
    /// A worker with a shadow cache of 16 entries that reports to `tally`.
    pub fn new(tally: T) -> Self {
        Worker::with_cache_size(tally)
    }
}

impl<A: Accelerator, T, const LEVELS: usize, const SHADOW_CACHE_ENTRIES: usize>
    Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>
{
    /// Size in bytes: one pending ray per level, the scratch memory of the accelerator, 4 bytes per entry of the
    /// shadow cache, and the tally.
    pub const SIZE_IN_BYTES: usize = size_of::<Self>();

    /// A worker with a shadow cache of `SHADOW_CACHE_ENTRIES` entries, zero or a power of two, that reports
    /// to `tally`.
    pub fn with_cache_size(tally: T) -> Self {
        Worker { caches: WorkerCaches::new(), tasks: TaskStack::new(), tally }
    }

    /// The same worker without a shadow cache: every shadow ray traverses the accelerator.
    pub fn without_shadow_cache(mut self) -> Self {
        self.caches.shadow_cache.disable();
        self
    }

    /// The tally that the tracer reports to.
    pub fn tally(&self) -> &T {
        &self.tally
    }

    /// The tally, to be reset or replaced.
    pub fn tally_mut(&mut self) -> &mut T {
        &mut self.tally
    }

    /// Returns the tally, dropping the rest.
    pub fn into_tally(self) -> T {
        self.tally
    }

    /// Clears all caches, so that counters of the following rays do not depend on earlier ones. The tally is
    /// kept.
    pub fn clear_caches(&mut self) {
        self.caches.clear();
    }
}
