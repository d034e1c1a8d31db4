//! The effect sets for which ray tracers are compiled. A scene uses the smallest set that contains its required effects.
//!
//! The number of compiled ray tracers determines the size and the build time of the program: BVH and list, which `auto`
//! selects, have eight each (seven sets, and one that counts tests), grid and octree three each, eight other configurations
//! one each, and double precision 13. `tests/reports/effects.md` shows the cost of unused effects in a set; a further
//! set is justified if that cost is large.

use strahl_core::accel::Accelerator;
use strahl_core::geometry::ShapeSet;
use strahl_core::scene::{EffectSet, Effects, LightKind, LightSet, TextureSet};
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

/// Lights without area: no penumbra.
const POINT_LIKE: LightSet = LightSet::of(&[LightKind::Point, LightKind::Directional, LightKind::Spot]);

prepared_sets! {
    /// Textures and ambient light only.
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
    /// `Opaque`, and clear glass.
    Clear = EffectSet { transmission: true, ..Opaque::SET };
    /// `Clear`, and distributed ray tracing: penumbra, depth of field, gloss, motion blur.
    Distributed =
        EffectSet { lights: LightSet::ALL, penumbra: true, depth_of_field: true, gloss: true, motion_blur: true, ..Clear::SET };
    /// Whitted ray tracing with absorbing glass: all effects without distributed ray tracing, except colored shadows.
    Whitted = EffectSet { lights: LightSet::ALL, absorption: true, ..Clear::SET };
    /// `Clear`, and absorbing glass with colored shadows.
    Stained = EffectSet { colored_shadows: true, absorption: true, ..Clear::SET };
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
