//! Rays through arbitrary worlds.

use strahl_core::accel::Accelerator;
use strahl_core::geometry::{Aabb, BoundingSphere};
use strahl_core::scene::Effects;
use strahl_core::tally::{Counters, RayCounters, Tally};
use strahl_core::trace::TracerError;
use strahl_core::{AllEffects, Limits, ListWithoutBounds, Scene, Tracer, Worker, World};

use crate::accel::{ArbitraryAccelerator, lists};
use crate::any::{any, used};
use crate::image;
use crate::scene::{LimitedDistanceEffects, SpheresOnly, any_camera, any_parts, any_sample};
use crate::tally::DiscardingTally;
use crate::text::displayed;

pub fn entry_points() {
    let Ok(scene) = Scene::new(any_parts()) else { return };
    for list in lists(&mut [Aabb::EMPTY], [&mut [BoundingSphere::EMPTY], &mut [BoundingSphere::EMPTY]]) {
        traced::<_, AllEffects, _, 64>(&World::new(scene, list), Counters::new());
        traced::<_, AllEffects, _, 5>(&World::new(scene, list), ());
    }
    traced::<_, SpheresOnly, _, 1>(&World::new(scene, ArbitraryAccelerator), DiscardingTally);
    traced::<_, SpheresOnly, _, 1>(&World::new(scene, ListWithoutBounds(any(1))), RayCounters::new());
    traced::<_, LimitedDistanceEffects, _, 2>(&World::new(scene, ListWithoutBounds(any(1))), ());
    displayed(any(TracerError::Cutoff(2.0)));
}

/// Traces rays, and renders pictures with every sampler and sink.
pub fn traced<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(world: &World<'_, A>, tally: T) {
    let Some(camera) = any_camera() else { return };
    let limits = any(Limits::DEFAULT);
    let Ok(tracer) = Tracer::<A, E, LEVELS>::new(world, camera, limits) else { return };
    let mut uncached_worker = Worker::<A, (), LEVELS, 0>::with_cache_size(());
    uncached_worker = Worker::without_shadow_cache(uncached_worker);
    used((
        Tracer::trace(&tracer, any_sample(), &mut uncached_worker),
        any(Worker::<A, (), LEVELS, 0>::SIZE_IN_BYTES),
    ));
    let mut worker = Worker::new(tally);
    used(Tracer::trace(&tracer, any_sample(), &mut worker));

    Worker::clear_caches(&mut worker);
    image::sampled(&tracer, &mut worker);

    used(Worker::tally(&worker));
    used(Worker::tally_mut(&mut worker));
    used(Worker::into_tally(worker));
}
