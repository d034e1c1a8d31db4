//! Values become types, once, around the whole render.
//!
//! The tracer's loop is compiled for each combination of accelerator, effects and tally; the
//! loop itself holds no mode. Of the prepared sets of effects the smallest that holds what the
//! scene asks for is taken. (The accelerator's type is chosen before, in
//! [`accelerators`](crate::accelerators).)
//!
//! Copies of the loop are a budget, for they make the program and its build large: three usual
//! accelerators with four sets and two tallies are 24, nine seldom ones 9, and the twin has 13.

use strahl_core::{Accelerator, EffectSet, Effects, Everything};

use crate::draw::{Job, Traced};
use crate::frame::NoFrame;
pub use crate::wanted::Wanted;

/// Everything that needs one ray for each place: Whitted's model.
struct Whitted;

impl Effects for Whitted {
    const SET: EffectSet = EffectSet {
        colored_shadows: false,
        penumbra: false,
        lens: false,
        gloss: false,
        motion: false,
        ..EffectSet::ALL
    };
}

/// Light and shadow, but no secondary rays.
struct Local;

impl Effects for Local {
    const SET: EffectSet =
        EffectSet { reflection: false, transmission: false, absorption: false, ..Whitted::SET };
}

/// Mirrors, but nothing that light passes through.
struct Mirrors;

impl Effects for Mirrors {
    const SET: EffectSet = EffectSet { reflection: true, ..Local::SET };
}

/// Traces the picture that is wanted.
pub fn trace<A: Accelerator + Sync>(job: &Job<'_, '_, A>) -> Result<Traced, NoFrame> {
    if job.is_general() {
        return job.counted::<Everything>();
    }
    let asks = job.asks();
    if Local::SET.contains(&asks) {
        with::<A, Local>(job)
    } else if Mirrors::SET.contains(&asks) {
        with::<A, Mirrors>(job)
    } else if Whitted::SET.contains(&asks) {
        with::<A, Whitted>(job)
    } else {
        with::<A, Everything>(job)
    }
}

fn with<A: Accelerator + Sync, E: Effects + Sync>(job: &Job<'_, '_, A>) -> Result<Traced, NoFrame> {
    if job.is_counted() { job.counted::<E>() } else { job.uncounted::<E>() }
}
