//! When to stop: the user's Ctrl-C, the system's polite request, and news.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use strahl_engine::{Interrupt, Progress};

use crate::failure::Failure;

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
}

impl Progress for Signals {
    /// `Err` once a signal has come.
    fn check(&self) -> Result<(), Interrupt> {
        if self.interrupted.load(Ordering::Relaxed) {
            Err(Interrupt::Interrupted)
        } else if self.terminated.load(Ordering::Relaxed) {
            Err(Interrupt::Terminated)
        } else if self.outdated.load(Ordering::Relaxed) {
            Err(Interrupt::Outdated)
        } else {
            Ok(())
        }
    }
}
