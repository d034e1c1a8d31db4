//! Progress reports and cancellation.

use std::fmt;
use std::time::Instant;

/// Receives progress reports, and can cancel the work. Called concurrently by all threads.
pub trait Progress: Sync {
    /// Work on this many pixels starts.
    fn begin(&self, _pixels: usize) {}

    /// This many more pixels are done.
    fn done(&self, _pixels: usize) {}

    /// Called between pixels; an error cancels the work.
    fn check(&self) -> Result<(), Interrupt> {
        Ok(())
    }
}

/// Why work was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interrupt {
    /// Ctrl-C.
    Interrupted,
    /// SIGTERM; the same command can be retried.
    Terminated,
    /// The input files have changed since the start.
    Outdated,
    /// The time limit is exceeded.
    TimeLimit,
}

impl fmt::Display for Interrupt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Interrupt::Interrupted => "interrupted",
            Interrupt::Terminated => "stopped by SIGTERM",
            Interrupt::Outdated => "the scene has changed",
            Interrupt::TimeLimit => "time limit exceeded",
        })
    }
}

/// Reports nothing and never cancels.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoProgress;

impl Progress for NoProgress {}

/// Adds a deadline to another progress.
pub struct Deadline<'p> {
    progress: &'p dyn Progress,
    end: Option<Instant>,
}

impl<'p> Deadline<'p> {
    /// Cancels the work at `end`, if any.
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
