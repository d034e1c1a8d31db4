//! One ray tracer for each tile, whatever the types behind it.
//!
//! Samplers, tiles and threads call a `dyn` [`CountingRayTracer`] once for each camera ray, so that all that is done with
//! the answers is compiled once and not for every accelerator and effect set.

use std::marker::PhantomData;

use strahl_core::accel::Accelerator;
use strahl_core::scene::{CameraSample, Effects};
use strahl_core::tally::{CountedEvent, Counters, RayCounters, Tally, TraceEvent};
use strahl_core::trace::{PixelSample, RayTracer, TracerError};
use strahl_core::{Camera, Limits, Tracer, Worker, World};
use strahl_settings::MAX_LEVELS;

use crate::progress::Progress;

/// A tracer with a worker of its own, which may count.
pub trait CountingRayTracer: RayTracer {
    /// What has been counted since the last call.
    fn take_counters(&mut self) -> Counters;
}

/// Makes a ray tracer for each tile.
pub trait RayTracerFactory: Sync {
    /// One that remembers nothing yet. Once `progress` stops the work, its answers may be incomplete.
    fn ray_tracer<'t>(&'t self, progress: &'t dyn Progress) -> Box<dyn CountingRayTracer + 't>;
}

/// A tracer whose workers report to a `T`.
pub struct TracerFactory<'w, 's, A, E, T> {
    tracer: Tracer<'w, 's, A, E, MAX_LEVELS>,
    shadow_cache: bool,
    tally: PhantomData<fn() -> T>,
}

impl<'w, 's, A: Accelerator, E: Effects, T> TracerFactory<'w, 's, A, E, T> {
    /// For a scene and a camera.
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
        let worker = Worker::new(Stoppable { tally: T::default(), progress, left: BETWEEN });
        let worker = if self.shadow_cache { worker } else { worker.without_shadow_cache() };
        Box::new(Working { tracer: &self.tracer, worker })
    }
}

/// A tracer and its worker.
struct Working<'t, 'w, 's, A: Accelerator, E, T> {
    tracer: &'t Tracer<'w, 's, A, E, MAX_LEVELS>,
    worker: Worker<A, Stoppable<'t, T>, MAX_LEVELS>,
}

impl<A: Accelerator, E: Effects, T: CounterTally> RayTracer for Working<'_, '_, '_, A, E, T> {
    fn trace(&mut self, sample: CameraSample) -> PixelSample {
        self.tracer.trace(sample, &mut self.worker)
    }
}

impl<A: Accelerator, E: Effects, T: CounterTally> CountingRayTracer for Working<'_, '_, '_, A, E, T> {
    fn take_counters(&mut self) -> Counters {
        self.worker.tally_mut().tally.take()
    }
}

/// So many rays of one tree are traced before it is asked again whether to stop.
const BETWEEN: u32 = 1 << 12;

/// A tally that gives up a tree of rays when the work is to stop.
struct Stoppable<'p, T> {
    tally: T,
    progress: &'p dyn Progress,
    /// Rays until the next check.
    left: u32,
}

impl<T: Tally> Tally for Stoppable<'_, T> {
    const COUNTS_TESTS: bool = T::COUNTS_TESTS;

    #[inline(always)]
    fn count(&mut self, event: CountedEvent) {
        self.tally.count(event);
    }

    #[inline(always)]
    fn trace_event(&mut self, step: TraceEvent) {
        self.tally.trace_event(step);
    }

    #[inline(always)]
    fn is_cancelled(&mut self) -> bool {
        match self.left.checked_sub(1) {
            Some(left) => {
                self.left = left;
                false
            }
            None => {
                let stops = self.progress.check().is_err();
                self.left = if stops { 0 } else { BETWEEN };
                stops
            }
        }
    }
}

/// A tally that counts.
pub trait CounterTally: Tally + Default {
    /// What has been counted since the last call.
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
