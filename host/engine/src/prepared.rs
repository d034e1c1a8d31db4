//! The prepared effect sets, from which a scene gets the smallest that contains what it asks for.
//!
//! Copies of the ray tracer's loop are a budget, for they make the program and its build large: hierarchy and list, one of
//! which `auto` chooses, with seven sets and one that counts tests are 16, grid and octree with two and one 6, eight rarely
//! used accelerators 8, and double precision has 13. What a scene pays for what it does not use is in
//! `tests/reports/effects.md`; another set is worth its copies where that is much.

use strahl_core::accel::Accelerator;
use strahl_core::geometry::ShapeSet;
use strahl_core::scene::{EffectSet, Effects, LightKind, LightSet, TextureSet};
use strahl_core::{AllEffects, Camera, World};

use crate::effects::{ChosenRayTracers, TracerRequest, counting_rays, counting_tests, required_effects};

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
                if $name::SET.is_superset(asks) {
                    return stringify!($name);
                }
            )*
            "AllEffects"
        }

        /// Ray tracers with all prepared sets to choose from.
        ///
        /// Every set counts the same, and a caller who counts tests does not hurry: one set does it.
        pub fn usual<'w, A: Accelerator + Sync>(
            world: &'w World<'_, A>,
            camera: Camera,
            request: TracerRequest,
        ) -> ChosenRayTracers<'w> {
            let asks = required_effects(world.scene(), &camera);
            if request.count_tests {
                return counting_tests::<A, AllEffects>(world, camera, request);
            }
            $(
                if $name::SET.is_superset(&asks) {
                    return counting_rays::<A, $name>(world, camera, request);
                }
            )*
            counting_rays::<A, AllEffects>(world, camera, request)
        }
    };
}

/// Lights without extent: no penumbra.
const POINT_LIKE: LightSet = LightSet::of(&[LightKind::Point, LightKind::Directional, LightKind::Spot]);

prepared_sets! {
    /// Textures and ambient light alone.
    Unlit = EffectSet { shapes: ShapeSet::ALL, textures: TextureSet::ALL, ..EffectSet::NONE };
    /// Opaque surfaces: highlights, shadows, mirrors.
    Opaque = EffectSet {
        smooth_shading: true,
        lights: POINT_LIKE,
        highlight: true,
        shadows: true,
        reflection: true,
        ..Unlit::SET
    };
    /// And clear glass.
    Clear = EffectSet { transmission: true, ..Opaque::SET };
    /// And distributed ray tracing: penumbra, depth of field, gloss, motion.
    Distributed =
        EffectSet { lights: LightSet::ALL, penumbra: true, depth_of_field: true, gloss: true, motion_blur: true, ..Clear::SET };
    /// Whitted's model with absorbing glass: everything that one ray per point shows.
    Whitted = EffectSet { lights: LightSet::ALL, absorption: true, ..Clear::SET };
    /// Glass that colors light and shadow.
    Stained = EffectSet { colored_shadows: true, absorption: true, ..Clear::SET };
}

/// Ray tracers with few sets to choose from, for accelerators that are asked for by name.
pub fn by_name<'w, A: Accelerator + Sync>(
    world: &'w World<'_, A>,
    camera: Camera,
    request: TracerRequest,
) -> ChosenRayTracers<'w> {
    let asks = required_effects(world.scene(), &camera);
    if request.count_tests {
        counting_tests::<A, AllEffects>(world, camera, request)
    } else if Whitted::SET.is_superset(&asks) {
        counting_rays::<A, Whitted>(world, camera, request)
    } else {
        counting_rays::<A, AllEffects>(world, camera, request)
    }
}
