//! Why work ends before it is done.

use std::fmt;

/// Who stopped the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// Ctrl-C.
    Interrupted,
    /// SIGTERM: the same command may be tried again.
    Terminated,
    /// What is worked on is of yesterday: its files have changed.
    Outdated,
    /// The time that was given for it is over.
    Late,
}

impl Stop {
    /// The exit status.
    pub fn status(self) -> u8 {
        match self {
            Stop::Interrupted => 130,
            Stop::Terminated | Stop::Outdated | Stop::Late => 75,
        }
    }
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Stop::Interrupted => "interrupted",
            Stop::Terminated => "stopped by SIGTERM",
            Stop::Outdated => "the scene has changed",
            Stop::Late => "the time is over",
        })
    }
}
