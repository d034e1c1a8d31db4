//! Which ray tracer a scene gets: its effect set, and what it counts.
//!
//! The ray tracer's loop is compiled for each combination of accelerator, effect set and tally; the loop itself holds no
//! mode. The values become types here, once for each picture.

use strahl_core::accel::Accelerator;
use strahl_core::scene::{EffectSet, Effects};
use strahl_core::tally::Counters;
#[cfg(not(feature = "double"))]
use strahl_core::tally::RayCounters;
use strahl_core::trace::TracerError;
use strahl_core::{AllEffects, Camera, Limits, Real, Scene, World};

use crate::ray_tracer::{RayTracerFactory, TracerFactory};

/// What ray tracers are asked for.
#[derive(Clone, Copy, Debug)]
pub struct TracerRequest {
    /// Levels of rays.
    pub levels: u8,
    /// The least weight of a ray, in `0..=1`.
    pub cutoff: f32,
    /// Whether the last occluder of a light is tested first.
    pub shadow_cache: bool,
    /// Whether every test is counted, and not only rays.
    pub count_tests: bool,
}

/// Chooses effect set and tally of the ray tracers for a world with this accelerator.
pub type ChooseRayTracers<A> =
    for<'w, 's> fn(&'w World<'s, A>, Camera, TracerRequest) -> ChosenRayTracers<'w>;

/// Ray tracers whose types have been chosen.
pub type ChosenRayTracers<'w> = Result<Box<dyn RayTracerFactory + 'w>, TracerError>;

/// The effects that a scene and a camera require.
pub fn required_effects(scene: &Scene<'_>, camera: &Camera) -> EffectSet {
    EffectSet { depth_of_field: camera.has_depth_of_field(), ..scene.required_effects() }
}

impl TracerRequest {
    fn limits(&self) -> Limits {
        Limits { levels: self.levels, cutoff: Real::from(self.cutoff) }
    }
}

/// Ray tracers of this effect set that count rays.
#[cfg(not(feature = "double"))]
pub(crate) fn counting_rays<'w, A: Accelerator + Sync, E: Effects + Sync + 'w>(
    world: &'w World<'_, A>,
    camera: Camera,
    request: TracerRequest,
) -> ChosenRayTracers<'w> {
    let (limits, shadow_cache) = (request.limits(), request.shadow_cache);
    Ok(Box::new(TracerFactory::<A, E, RayCounters>::new(world, camera, limits, shadow_cache)?))
}

/// Ray tracers of this effect set that count every test, too.
pub(crate) fn counting_tests<'w, A: Accelerator + Sync, E: Effects + Sync + 'w>(
    world: &'w World<'_, A>,
    camera: Camera,
    request: TracerRequest,
) -> ChosenRayTracers<'w> {
    let (limits, shadow_cache) = (request.limits(), request.shadow_cache);
    Ok(Box::new(TracerFactory::<A, E, Counters>::new(world, camera, limits, shadow_cache)?))
}

/// Ray tracers of one set, for accelerators whose sizes only comparisons use.
pub fn rarely_used<'w, A: Accelerator + Sync>(
    world: &'w World<'_, A>,
    camera: Camera,
    request: TracerRequest,
) -> ChosenRayTracers<'w> {
    counting_tests::<A, AllEffects>(world, camera, request)
}
