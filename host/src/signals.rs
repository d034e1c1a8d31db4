//! When to stop: the user's Ctrl-C, the system's polite request, and news.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};

use crate::failure::Failure;

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

/// Flags that signals and news raise, and that work asks between two pixels.
#[derive(Clone, Debug, Default)]
pub struct Signals {
    interrupted: Arc<AtomicBool>,
    terminated: Arc<AtomicBool>,
    outdated: Arc<AtomicBool>,
}

impl Signals {
    /// Listens for both signals from now on.
    pub fn listen() -> Result<Self, Failure> {
        let signals = Signals::default();
        let deaf = |error| Failure::Usage(format!("cannot listen for signals: {error}"));
        signal_hook::flag::register(SIGINT, Arc::clone(&signals.interrupted)).map_err(deaf)?;
        signal_hook::flag::register(SIGTERM, Arc::clone(&signals.terminated)).map_err(deaf)?;
        Ok(signals)
    }

    /// What is raised when the work has become useless, and lowered when other work begins.
    pub fn outdated(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.outdated)
    }

    /// `Err` once a signal has come.
    pub fn check(&self) -> Result<(), Stop> {
        if self.interrupted.load(Ordering::Relaxed) {
            Err(Stop::Interrupted)
        } else if self.terminated.load(Ordering::Relaxed) {
            Err(Stop::Terminated)
        } else if self.outdated.load(Ordering::Relaxed) {
            Err(Stop::Outdated)
        } else {
            Ok(())
        }
    }
}
