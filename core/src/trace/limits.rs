//! How far the tree of rays is to go, and why a tracer may refuse.

use core::fmt;

use crate::math::Real;
use crate::scene::EffectSet;

/// Which picture is wanted: how far the tree of rays goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Levels of rays: 1 is the camera ray alone.
    pub levels: u8,
    /// A ray is sent when its weight in the brightest channel is more than this, in `0..=1`.
    pub cutoff: Real,
}

impl Limits {
    /// Five levels, and what could make half a step of an 8-bit picture.
    pub const DEFAULT: Limits = Limits { levels: 5, cutoff: 1.0 / 512.0 };
}

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
