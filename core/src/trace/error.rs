//! Why a tracer may refuse a world.

use core::fmt;

use crate::math::Decimal;
use crate::scene::EffectSet;

/// Why a tracer cannot trace a world.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TracerError {
    /// The scene or the camera needs effects that are not in the tracer's set.
    MissingEffects {
        /// The effects that are needed and not in the set.
        missing: EffectSet,
    },
    /// The limits ask for no level, or for more than the tracer has room for.
    Levels {
        /// Levels of the limits.
        requested: u8,
        /// The tracer's `LEVELS`.
        max: usize,
    },
    /// The cutoff of the limits is not in `0..=1`.
    Cutoff(f32),
}

impl fmt::Display for TracerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TracerError::MissingEffects { missing } => write!(
                f,
                "the scene needs effects that the tracer leaves out: {missing}; add them to `Effects::SET`, or use \
                 `AllEffects`"
            ),
            TracerError::Levels { requested, max } => {
                write!(f, "`levels` is {requested}, must be in 1..={max}: `LEVELS` of the tracer")
            }
            TracerError::Cutoff(cutoff) => write!(f, "`cutoff` is {}, must be in 0..=1", Decimal(*cutoff)),
        }
    }
}

impl core::error::Error for TracerError {}
