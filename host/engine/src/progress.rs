//! How far the work is, and whether it should go on: reported to the caller, which may stop it.

use std::fmt;
use std::time::Instant;

/// Told how far the work is, and asked between two pixels whether it should go on. Called by all threads.
pub trait Progress: Sync {
    /// Work on this many pixels begins.
    fn begin(&self, _pixels: usize) {}

    /// This many more of them are done.
    fn done(&self, _pixels: usize) {}

    /// `Err` when the work should stop.
    fn check(&self) -> Result<(), Interrupt> {
        Ok(())
    }
}

/// Why work was stopped before it was done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interrupt {
    /// Ctrl-C.
    Interrupted,
    /// SIGTERM: the same command may be tried again.
    Terminated,
    /// The input files have changed since the work began.
    Outdated,
    /// The time limit is over.
    TimeLimit,
}

impl fmt::Display for Interrupt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Interrupt::Interrupted => "interrupted",
            Interrupt::Terminated => "stopped by SIGTERM",
            Interrupt::Outdated => "the scene has changed",
            Interrupt::TimeLimit => "the time is over",
        })
    }
}

/// Shows nothing and never stops the work.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoProgress;

impl Progress for NoProgress {}

/// The same as another, but it stops the work at a point in time.
pub struct Deadline<'p> {
    progress: &'p dyn Progress,
    end: Option<Instant>,
}

impl<'p> Deadline<'p> {
    /// Stops the work at `end`, if there is one.
    pub fn new(progress: &'p dyn Progress, end: Option<Instant>) -> Self {
        Deadline { progress, end }
    }
}

impl Progress for Deadline<'_> {
    fn begin(&self, pixels: usize) {
        self.progress.begin(pixels);
    }

    fn done(&self, pixels: usize) {
        self.progress.done(pixels);
    }

    fn check(&self) -> Result<(), Interrupt> {
        match self.end {
            Some(end) if Instant::now() >= end => Err(Interrupt::TimeLimit),
            _ => self.progress.check(),
        }
    }
}
