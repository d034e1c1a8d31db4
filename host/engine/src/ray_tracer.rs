//! Ray tracers of tiles, as trait objects.
//!
//! Samplers and tiles call a `dyn` [`CountingRayTracer`] once for each camera ray, so that they are compiled only once,
//! and not for every acceleration structure and effect set.

use std::marker::PhantomData;

use strahl_core::accel::Accelerator;
use strahl_core::scene::{CameraSample, Effects};
use strahl_core::tally::{CountedEvent, Counters, RayCounters, Tally, TraceEvent};
use strahl_core::trace::{PixelSample, RayTracer, TracerError};
use strahl_core::{Camera, Limits, Tracer, Worker, World};
use strahl_settings::MAX_LEVELS;

use crate::progress::Progress;

/// A ray tracer with its own worker and counters.
pub trait CountingRayTracer: RayTracer {
    /// Returns the counts since the last call.
    fn take_counters(&mut self) -> Counters;
}

/// Creates ray tracers, one for each tile.
pub trait RayTracerFactory: Sync {
    /// A ray tracer with empty caches. After `progress` has requested cancellation, its results may be incomplete.
    fn ray_tracer<'t>(&'t self, progress: &'t dyn Progress) -> Box<dyn CountingRayTracer + 't>;
}

/// Creates ray tracers whose workers report to a tally of type `T`.
pub struct TracerFactory<'w, 's, A, E, T> {
    tracer: Tracer<'w, 's, A, E, MAX_LEVELS>,
    shadow_cache: bool,
    tally: PhantomData<fn() -> T>,
}

impl<'w, 's, A: Accelerator, E: Effects, T> TracerFactory<'w, 's, A, E, T> {
    /// A factory for a scene and a camera.
    pub fn new(
        world: &'w World<'s, A>,
        camera: Camera,
        limits: Limits,
        shadow_cache: bool,
    ) -> Result<Self, TracerError> {
        let tracer = Tracer::new(world, camera, limits)?;
        Ok(TracerFactory { tracer, shadow_cache, tally: PhantomData })
    }
}

impl<A: Accelerator + Sync, E: Effects + Sync, T: CounterTally> RayTracerFactory
    for TracerFactory<'_, '_, A, E, T>
{
    fn ray_tracer<'t>(&'t self, progress: &'t dyn Progress) -> Box<dyn CountingRayTracer + 't> {
        let worker =
            Worker::new(CancellableTally { tally: T::default(), progress, remaining: RAYS_BETWEEN_CHECKS });
        let worker = if self.shadow_cache { worker } else { worker.without_shadow_cache() };
        Box::new(CancellableTracer { tracer: &self.tracer, worker })
    }
}

/// A tracer and its worker.
struct CancellableTracer<'t, 'w, 's, A: Accelerator, E, T> {
    tracer: &'t Tracer<'w, 's, A, E, MAX_LEVELS>,
    worker: Worker<A, CancellableTally<'t, T>, MAX_LEVELS>,
}

impl<A: Accelerator, E: Effects, T: CounterTally> RayTracer for CancellableTracer<'_, '_, '_, A, E, T> {
    fn trace(&mut self, sample: CameraSample) -> PixelSample {
        self.tracer.trace(sample, &mut self.worker)
    }
}

impl<A: Accelerator, E: Effects, T: CounterTally> CountingRayTracer
    for CancellableTracer<'_, '_, '_, A, E, T>
{
    fn take_counters(&mut self) -> Counters {
        self.worker.tally_mut().tally.take()
    }
}

/// The number of rays of one ray tree between two checks for cancellation.
const RAYS_BETWEEN_CHECKS: u32 = 1 << 12;

/// A tally that aborts a ray tree on cancellation.
struct CancellableTally<'p, T> {
    tally: T,
    progress: &'p dyn Progress,
    /// The number of rays until the next check.
    remaining: u32,
}

impl<T: Tally> Tally for CancellableTally<'_, T> {
    const COUNTS_TESTS: bool = T::COUNTS_TESTS;

    #[inline(always)]
    fn count(&mut self, event: CountedEvent) {
        self.tally.count(event);
    }

    #[inline(always)]
    fn trace_event(&mut self, event: TraceEvent) {
        self.tally.trace_event(event);
    }

    #[inline(always)]
    fn is_cancelled(&mut self) -> bool {
        match self.remaining.checked_sub(1) {
            Some(remaining) => {
                self.remaining = remaining;
                false
            }
            None => {
                let is_cancelled = self.progress.check().is_err();
                self.remaining = if is_cancelled { 0 } else { RAYS_BETWEEN_CHECKS };
                is_cancelled
            }
        }
    }
}

/// A tally that counts.
pub trait CounterTally: Tally + Default {
    /// Returns the counts since the last call.
    fn take(&mut self) -> Counters;
}

impl CounterTally for RayCounters {
    fn take(&mut self) -> Counters {
        std::mem::take(self).counters
    }
}

impl CounterTally for Counters {
    fn take(&mut self) -> Counters {
        std::mem::take(self)
    }
}
