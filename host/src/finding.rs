//! How items are found: what can be asked for, and what there is.

use std::time::Duration;

use clap::ValueEnum;

/// How items are found. None of it changes an answer, all of it the time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Finding {
    /// The accelerator; none is the one that suits the scene.
    pub accelerator: Option<Kind>,
    /// What the list puts round items and groups of them.
    pub bounds: Option<Bounds>,
}

/// An accelerator, as the command line names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Accel {
    /// What suits the scene.
    Auto,
    /// Every item in turn.
    List,
}

impl Accel {
    /// Which; none when it is to be found out.
    pub fn kind(self) -> Option<Kind> {
        match self {
            Accel::Auto => None,
            Accel::List => Some(Kind::List),
        }
    }
}

/// An accelerator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Every item in turn.
    List,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Kind; 1] = [Kind::List];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Kind::List => "list",
        }
    }
}

/// What the list puts round items and groups of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Bounds {
    /// Nothing: every item is held against every ray.
    None,
    /// Boxes.
    Box,
}

/// What an accelerator is like.
#[derive(Clone, Copy, Debug)]
pub struct Facts {
    /// Which it is.
    pub kind: Kind,
    /// Why it was taken.
    pub reason: &'static str,
    /// The memory it uses.
    pub bytes: usize,
    /// Its regions.
    pub regions: usize,
    /// How long it took to build.
    pub build: Duration,
}
