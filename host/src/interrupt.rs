//! Why work ends before it is done.

use std::fmt;

/// Why work was stopped.
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
