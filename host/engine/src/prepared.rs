//! The effect sets for which ray tracers are compiled. A scene uses the smallest set that contains its required effects.
//!
//! The number of compiled ray tracers determines the size and the build time of the program: BVH and list, which `auto`
//! selects, have eight each (seven sets, and one that counts tests), grid and octree three each, eight other configurations
//! one each, and double precision 13. `tests/reports/effects.md` shows the cost of unused effects in a set; a further
//! set is justified if that cost is large.

use strahl_core::accel::Accelerator;
use strahl_core::geometry::ShapeKindSet;
use strahl_core::scene::{EffectSet, Effects, LightKind, LightKindSet, TextureKindSet};
use strahl_core::{AllEffects, Camera, World};

use crate::effects::{SelectedRayTracers, TracerRequest, counting_rays, counting_tests, required_effects};

/// Declares the prepared sets, from the smallest to the largest, and the selection of one of them.
macro_rules! prepared_sets {
    ($($(#[$doc:meta])* $name:ident = $set:expr;)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl Effects for $name {
                const SET: EffectSet = $set;
            }
        )*

        /// The name of the first prepared set that contains the `required` effects.
        pub fn prepared_for(required: &EffectSet) -> &'static str {
            $(
                if $name::SET.is_superset(required) {
                    return stringify!($name);
                }
            )*
            "AllEffects"
        }

        /// Ray tracers with the first of all prepared sets that contains the required effects.
        ///
        /// Counts do not depend on the set, so a request to count tests, which is slow anyway, uses only one set.
        pub fn all_prepared<'w, A: Accelerator + Sync>(
            world: &'w World<'_, A>,
            camera: Camera,
            request: TracerRequest,
        ) -> SelectedRayTracers<'w> {
            let required = required_effects(world.scene(), &camera);
            if request.count_tests {
                return counting_tests::<A, AllEffects>(world, camera, request);
            }
            $(
                if $name::SET.is_superset(&required) {
                    return counting_rays::<A, $name>(world, camera, request);
                }
            )*
            counting_rays::<A, AllEffects>(world, camera, request)
        }
    };
}

/// The sun: most scenes of the outdoors have no other light, and a choice between kinds of lights costs more than
/// every other effect that is not used.
const SUN: LightKindSet = LightKindSet::of(&[LightKind::Directional]);

prepared_sets! {
    /// Textures and ambient light only.
    Unlit = EffectSet { shapes: ShapeKindSet::ALL, textures: TextureKindSet::ALL, ..EffectSet::NONE };
    /// Opaque surfaces under directional lights: highlights, shadows, mirrors.
    Sunlit = EffectSet {
        smooth_shading: true,
        lights: SUN,
        highlight: true,
        shadows: true,
        reflection: true,
        ..Unlit::SET
    };
    /// Whitted ray tracing with absorbing glass: all effects without distributed ray tracing, except colored shadows.
    Whitted = EffectSet { lights: LightKindSet::ALL, transmission: true, absorption: true, ..Sunlit::SET };
    /// Opaque surfaces under lights with an area.
    SoftShadows = EffectSet { lights: LightKindSet::ALL, soft_shadows: true, ..Sunlit::SET };
    /// Distributed ray tracing under directional lights: depth of field, gloss, motion blur; and clear glass.
    SunlitDistributed =
        EffectSet { transmission: true, depth_of_field: true, gloss: true, motion_blur: true, ..Sunlit::SET };
    /// Absorbing glass with colored shadows, under lights without area.
    Stained = EffectSet {
        lights: LightKindSet::of(&[LightKind::Point, LightKind::Directional, LightKind::Spot]),
        colored_shadows: true,
        ..Whitted::SET
    };
}

/// Ray tracers with one of two sets, for structures that `auto` does not select.
pub fn few_prepared<'w, A: Accelerator + Sync>(
    world: &'w World<'_, A>,
    camera: Camera,
    request: TracerRequest,
) -> SelectedRayTracers<'w> {
    let required = required_effects(world.scene(), &camera);
    if request.count_tests {
        counting_tests::<A, AllEffects>(world, camera, request)
    } else if Whitted::SET.is_superset(&required) {
        counting_rays::<A, Whitted>(world, camera, request)
    } else {
        counting_rays::<A, AllEffects>(world, camera, request)
    }
}
