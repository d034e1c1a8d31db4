//! Interruption of a command by SIGINT, SIGTERM, or a change of the scene.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use strahl_engine::{Interrupt, Progress};

use crate::error::CommandError;

/// Flags set by signals and by changes of the scene. Workers check them between two pixels.
#[derive(Clone, Debug, Default)]
pub struct Signals {
    interrupted: Arc<AtomicBool>,
    terminated: Arc<AtomicBool>,
    scene_changed: Arc<AtomicBool>,
}

impl Signals {
    /// Registers handlers of SIGINT and SIGTERM.
    pub fn register() -> Result<Self, CommandError> {
        let signals = Signals::default();
        let failed = |error| CommandError::Usage(format!("cannot register signal handlers: {error}"));
        signal_hook::flag::register(SIGINT, Arc::clone(&signals.interrupted)).map_err(failed)?;
        signal_hook::flag::register(SIGTERM, Arc::clone(&signals.terminated)).map_err(failed)?;
        Ok(signals)
    }

    /// Flag to set when the scene changes and to clear when rendering starts.
    pub fn scene_changed(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.scene_changed)
    }
}

impl Progress for Signals {
    /// `Err` once a signal has arrived or the scene has changed.
    fn check(&self) -> Result<(), Interrupt> {
        if self.interrupted.load(Ordering::Relaxed) {
            Err(Interrupt::Interrupted)
        } else if self.terminated.load(Ordering::Relaxed) {
            Err(Interrupt::Terminated)
        } else if self.scene_changed.load(Ordering::Relaxed) {
            Err(Interrupt::Outdated)
        } else {
            Ok(())
        }
    }
}
