//! Errors of building a tracer.

use core::fmt;

use crate::math::Decimal;
use crate::scene::EffectSet;

/// Why [`Tracer::new`](crate::trace::Tracer::new) cannot build a tracer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TracerError {
    /// The scene or the camera needs effects that the tracer's [`Effects::SET`](crate::scene::Effects::SET)
    /// lacks.
    MissingEffects {
        /// The effects that are needed and not in that set.
        missing: EffectSet,
    },
    /// [`Limits::levels`](crate::trace::Limits::levels) is not in `1..=LEVELS`.
    Levels {
        /// The requested number of levels.
        requested: u8,
        /// `LEVELS` of the tracer.
        max: usize,
    },
    /// [`Limits::cutoff`](crate::trace::Limits::cutoff) has this value, which is not in `0..=1`.
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
