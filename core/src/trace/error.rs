//! Why a tracer may refuse a world.

use core::fmt;

use crate::scene::EffectSet;

/// Why a tracer cannot trace a world.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TracerError {
    /// The scene asks for what this tracer was not built for.
    NotBuiltFor {
        /// What the scene asks for.
        asks: EffectSet,
    },
    /// There is no level, or more than the worker has room for.
    Levels {
        /// How many are wanted.
        wanted: u8,
        /// For how many there is room.
        most: usize,
    },
    /// The cutoff is not in `0..=1`.
    Cutoff,
}

impl fmt::Display for TracerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TracerError::NotBuiltFor { .. } => {
                f.write_str("the scene asks for effects that this tracer was not built for")
            }
            TracerError::Levels { wanted, most } => write!(f, "{wanted} levels wanted, 1 to {most} possible"),
            TracerError::Cutoff => f.write_str("the cutoff is not in 0..=1"),
        }
    }
}

impl core::error::Error for TracerError {}
