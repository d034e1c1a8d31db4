//! Selection of a ray tracer by effect set and tally.
//!
//! The ray tracer is compiled for each combination of acceleration structure, effect set and tally, without run-time
//! switches in its loop. Values are converted to types here, once for each picture.

use strahl_core::accel::Accelerator;
use strahl_core::scene::{EffectSet, Effects};
use strahl_core::tally::Counters;
#[cfg(not(feature = "double"))]
use strahl_core::tally::RayCounters;
use strahl_core::trace::TracerError;
use strahl_core::{AllEffects, Camera, Limits, Real, Scene, World};

use crate::ray_tracer::{RayTracerFactory, TracerFactory};

/// The parameters of ray tracers.
#[derive(Clone, Copy, Debug)]
pub struct TracerRequest {
    /// The maximum ray level.
    pub levels: u8,
    /// The minimum ray weight, in `[0, 1]`.
    pub cutoff: f32,
    /// Whether the last occluder of a light is tested first.
    pub shadow_cache: bool,
    /// Whether tests are counted in addition to rays.
    pub count_tests: bool,
}

/// Selects the effect set and the tally of ray tracers, for an acceleration structure of type `A`.
pub type SelectRayTracers<A> =
    for<'w, 's> fn(&'w World<'s, A>, Camera, TracerRequest) -> SelectedRayTracers<'w>;

/// Ray tracers with the selected types, as a trait object.
pub type SelectedRayTracers<'w> = Result<Box<dyn RayTracerFactory + 'w>, TracerError>;

/// The effects that a scene and a camera require.
pub fn required_effects(scene: &Scene<'_>, camera: &Camera) -> EffectSet {
    EffectSet { depth_of_field: camera.has_depth_of_field(), ..scene.required_effects() }
}

impl TracerRequest {
    fn limits(&self) -> Limits {
        Limits { levels: self.levels, cutoff: Real::from(self.cutoff) }
    }
}

/// Ray tracers with effect set `E` that count rays.
#[cfg(not(feature = "double"))]
pub(crate) fn counting_rays<'w, A: Accelerator + Sync, E: Effects + Sync + 'w>(
    world: &'w World<'_, A>,
    camera: Camera,
    request: TracerRequest,
) -> SelectedRayTracers<'w> {
    let (limits, shadow_cache) = (request.limits(), request.shadow_cache);
    Ok(Box::new(TracerFactory::<A, E, RayCounters>::new(world, camera, limits, shadow_cache)?))
}

/// Ray tracers with effect set `E` that count rays and tests.
pub(crate) fn counting_tests<'w, A: Accelerator + Sync, E: Effects + Sync + 'w>(
    world: &'w World<'_, A>,
    camera: Camera,
    request: TracerRequest,
) -> SelectedRayTracers<'w> {
    let (limits, shadow_cache) = (request.limits(), request.shadow_cache);
    Ok(Box::new(TracerFactory::<A, E, Counters>::new(world, camera, limits, shadow_cache)?))
}

/// Ray tracers with all effects, for configurations that are used only in comparisons.
pub fn all_effects<'w, A: Accelerator + Sync>(
    world: &'w World<'_, A>,
    camera: Camera,
    request: TracerRequest,
) -> SelectedRayTracers<'w> {
    counting_tests::<A, AllEffects>(world, camera, request)
}
