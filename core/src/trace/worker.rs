//! All that changes while a picture is traced.

use super::task::Tasks;
use crate::accel::Accelerator;

/// What one thread of control needs beside the world, which all share.
///
/// Nothing in it changes a picture: a worker that is made anew for every pixel gives the same.
/// `LEVELS` is how many levels of rays there is room for, 1 to 64.
pub struct Worker<A: Accelerator, T, const LEVELS: usize> {
    pub(super) scratch: A::Scratch,
    pub(super) tasks: Tasks<LEVELS>,
    pub(super) tally: T,
}

impl<A: Accelerator, T, const LEVELS: usize> Worker<A, T, LEVELS> {
    /// How many bytes one takes, known when compiling: a [`Task`](super::task::Task) for each
    /// level, what the accelerator's walk remembers, and the tally.
    pub const BYTES: usize = size_of::<Self>();

    /// A worker that reports to `tally`.
    pub fn new(tally: T) -> Self {
        Worker { scratch: A::Scratch::default(), tasks: Tasks::new(), tally }
    }

    /// Who has been told.
    pub fn tally(&self) -> &T {
        &self.tally
    }

    /// Who has been told, when the work is done.
    pub fn into_tally(self) -> T {
        self.tally
    }

    /// Forgets all that it remembers of earlier rays, so that the work of a picture does not
    /// depend on what was traced before.
    pub(crate) fn forget(&mut self) {
        self.scratch = A::Scratch::default();
    }
}
