//! The prepared effect sets: which ray tracer a scene gets.
//!
//! The ray tracer's loop is compiled for each combination of accelerator, effects and tally; the loop itself holds no
//! mode. Of the prepared effect sets the smallest is taken that contains what the scene asks for.
//!
//! Copies of the loop are a budget, for they make the program and its build large: hierarchy and list, one of which
//! `auto` chooses, with fifteen sets and one that counts tests are 32, grid and octree with three and one 8, eight
//! rarely used accelerators 8, and double precision has 13. What a scene pays for what it does not use is in
//! `tests/reports/effects.md`; another set is worth its copies where that is much.

use strahl_core::{Accelerator, EffectSet, Effects, Everything, LightKind, LightSet, ShapeSet, TextureSet};

use crate::engine::request::{Chosen, Request};

/// The prepared sets, from the smallest on, and the choice between them.
macro_rules! prepared_sets {
    ($($(#[$doc:meta])* $name:ident = $set:expr;)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl Effects for $name {
                const SET: EffectSet = $set;
            }
        )*

        /// The name of the first prepared set that contains all of `asks`.
        pub fn prepared_for(asks: &EffectSet) -> &'static str {
            $(
                if $name::SET.contains(asks) {
                    return stringify!($name);
                }
            )*
            "Everything"
        }

        /// Ray tracers with all prepared sets to choose from.
        ///
        /// Every set counts the same, and a caller who counts tests does not hurry: one set does it.
        pub fn usual<'w, A: Accelerator + Sync>(request: &Request<'w, '_, A>) -> Chosen<'w> {
            let asks = request.asks();
            if request.is_counted() {
                return request.counting_tests::<Everything>();
            }
            $(
                if $name::SET.contains(&asks) {
                    return request.counting_rays::<$name>();
                }
            )*
            request.counting_rays::<Everything>()
        }
    };
}

/// Lights with a place but no extent, and those without a place.
const LAMPS: LightSet = LightSet::of(&[LightKind::Point, LightKind::Directional, LightKind::Spot]);

prepared_sets! {
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

/// Ray tracers with few sets to choose from, for accelerators that are asked for by name.
pub fn by_name<'w, A: Accelerator + Sync>(request: &Request<'w, '_, A>) -> Chosen<'w> {
    let asks = request.asks();
    if request.is_counted() {
        request.counting_tests::<Everything>()
    } else if LampMirrors::SET.contains(&asks) {
        request.counting_rays::<LampMirrors>()
    } else if Whitted::SET.contains(&asks) {
        request.counting_rays::<Whitted>()
    } else {
        request.counting_rays::<Everything>()
    }
}

/// Ray tracers of one set, for accelerators whose sizes only comparisons use.
pub fn rarely_used<'w, A: Accelerator + Sync>(request: &Request<'w, '_, A>) -> Chosen<'w> {
    request.counting_tests::<Everything>()
}
