//! When to stop: the user's Ctrl-C and the system's polite request.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};

/// Who stopped the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// Ctrl-C.
    Interrupted,
    /// SIGTERM: the same command may be tried again.
    Terminated,
}

impl Stop {
    /// The exit status.
    pub fn status(self) -> u8 {
        match self {
            Stop::Interrupted => 130,
            Stop::Terminated => 75,
        }
    }
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Stop::Interrupted => "interrupted",
            Stop::Terminated => "stopped by SIGTERM",
        })
    }
}

/// Flags that signals raise, and that work asks between two pixels.
#[derive(Clone, Debug, Default)]
pub struct Signals {
    interrupted: Arc<AtomicBool>,
    terminated: Arc<AtomicBool>,
}

impl Signals {
    /// Listens for both signals from now on.
    pub fn listen() -> std::io::Result<Self> {
        let signals = Signals::default();
        signal_hook::flag::register(SIGINT, Arc::clone(&signals.interrupted))?;
        signal_hook::flag::register(SIGTERM, Arc::clone(&signals.terminated))?;
        Ok(signals)
    }

    /// `Err` once a signal has come.
    pub fn check(&self) -> Result<(), Stop> {
        if self.interrupted.load(Ordering::Relaxed) {
            Err(Stop::Interrupted)
        } else if self.terminated.load(Ordering::Relaxed) {
            Err(Stop::Terminated)
        } else {
            Ok(())
        }
    }
}
