//! Values become types, once, around the whole render.
//!
//! The tracer's loop is compiled for each combination of accelerator, effects and tally; the
//! loop itself holds no mode. Of the prepared sets of effects the smallest that holds what the
//! scene asks for is taken. (The accelerator's type is chosen before, in
//! [`accelerators`](crate::accelerators).)
//!
//! Copies of the loop are a budget, for they make the program and its build large: the hierarchy
//! and the list, one of which is taken where nobody asks for another, with fifteen sets and one that
//! counts are 32, grid and octree with three and one 8, eight seldom ones 8, and the twin has 13.
//! What a scene pays for what it does not use is in `tests/reports/effects.md`; a further set is worth its
//! copies where that is much.

use strahl_core::{Accelerator, EffectSet, Effects, Everything, LightKind, LightSet, ShapeSet, TextureSet};

use crate::job::{Job, Traced};
use crate::studio::NoFrame;
pub use crate::wanted::Wanted;

/// A use for a set of effects.
pub trait Purpose {
    /// What comes of it.
    type Answer;

    /// Uses it; `name` is for the reader.
    fn with<E: Effects + Sync>(self, name: &'static str) -> Self::Answer;
}

/// The prepared sets, from the smallest on. The last holds everything.
macro_rules! prepared {
    ($($(#[$doc:meta])* $name:ident = $set:expr;)*) => {
        $(
            $(#[$doc])*
            struct $name;

            impl Effects for $name {
                const SET: EffectSet = $set;
            }
        )*

        /// Uses the first of the prepared sets that holds all that is asked for.
        pub fn fitting<P: Purpose>(asks: &EffectSet, purpose: P) -> P::Answer {
            $(
                if $name::SET.contains(asks) {
                    return purpose.with::<$name>(stringify!($name));
                }
            )*
            purpose.with::<Everything>("Everything")
        }
    };
}

/// Lights with a place but no extent, and those without a place.
const LAMPS: LightSet = LightSet::of(&[LightKind::Point, LightKind::Directional, LightKind::Spot]);

prepared! {
    /// Colours alone.
    Unlit = EffectSet { shapes: ShapeSet::ALL, textures: TextureSet::ALL, ..EffectSet::NONE };
    /// Matte things and mirrors in the light and shadow of the sun.
    Matte = EffectSet {
        lights: LightSet::of(&[LightKind::Directional]),
        shadows: true,
        reflection: true,
        ..Unlit::SET
    };
    /// Shadows with soft rims, but no secondary rays.
    SoftShadows = EffectSet {
        lights: LightSet::ALL,
        highlight: true,
        shadows: true,
        penumbra: true,
        ..Unlit::SET
    };
    /// Highlights and mirrors, but nothing that light passes through.
    Mirrors = EffectSet { highlight: true, ..Matte::SET };
    /// The same on smooth shapes.
    SmoothMirrors = EffectSet { smooth: true, ..Mirrors::SET };
    /// Mirrors that move.
    Moving = EffectSet { motion: true, ..Mirrors::SET };
    /// Mirrors and clear glass.
    Clear = EffectSet { transmission: true, ..Mirrors::SET };
    /// What is soft for it has more than one place or direction.
    Soft = EffectSet { penumbra: true, lens: true, gloss: true, ..Clear::SET };
    /// Mirrors by lamps.
    LampMirrors = EffectSet { lights: LAMPS, ..SmoothMirrors::SET };
    /// Clear glass by lamps.
    LampClear = EffectSet { lights: LAMPS, ..Clear::SET };
    /// What is soft, by lamps with an extent too.
    LampSoft = EffectSet { lights: LightSet::ALL, ..Soft::SET };
    /// Glass, in the light of the sun or of points.
    Glass = EffectSet {
        lights: LightSet::of(&[LightKind::Point, LightKind::Directional]),
        absorption: true,
        ..Clear::SET
    };
    /// Everything that needs one ray for each place: Whitted's model.
    Whitted = EffectSet {
        colored_shadows: false,
        penumbra: false,
        lens: false,
        gloss: false,
        motion: false,
        ..EffectSet::ALL
    };
    /// Glass that colours light and shadow.
    Stained = EffectSet { absorption: true, colored_shadows: true, ..Clear::SET };
}

/// Traces the picture that is wanted, with one of all the prepared sets.
///
/// What is counted is the same in all loops, and who counts does not hurry: one loop does it.
pub fn trace<A: Accelerator + Sync>(job: &Job<'_, '_, A>) -> Result<Traced, NoFrame> {
    if job.is_counted() { job.counting_all::<Everything>() } else { fitting(&job.asks(), job) }
}

/// The same with few of them, by what is taken only where it is asked for.
pub fn trace_as_asked<A: Accelerator + Sync>(job: &Job<'_, '_, A>) -> Result<Traced, NoFrame> {
    let asks = job.asks();
    if job.is_counted() {
        job.counting_all::<Everything>()
    } else if LampMirrors::SET.contains(&asks) {
        job.counting_rays::<LampMirrors>()
    } else if Whitted::SET.contains(&asks) {
        job.counting_rays::<Whitted>()
    } else {
        job.counting_rays::<Everything>()
    }
}

impl<A: Accelerator + Sync> Purpose for &Job<'_, '_, A> {
    type Answer = Result<Traced, NoFrame>;

    fn with<E: Effects + Sync>(self, _: &'static str) -> Self::Answer {
        self.counting_rays::<E>()
    }
}
