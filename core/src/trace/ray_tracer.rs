//! Tracing one camera sample, whatever the types behind it.

use super::{PixelSample, Tracer, Worker};
use crate::accel::Accelerator;
use crate::scene::{CameraSample, Effects};
use crate::tally::Tally;

/// Traces camera samples, whatever scene, accelerator, effects and tally are behind it.
///
/// [`Tracer::with_worker`] makes one, and a closure is one. The trait is object-safe: code that is to be
/// compiled once for all tracers takes `&mut dyn RayTracer`.
pub trait RayTracer {
    /// The light that arrives along one camera ray, and what that ray hits.
    fn trace(&mut self, sample: CameraSample) -> PixelSample;

    /// Forgets what is remembered of earlier samples, so that the work that follows does not depend on
    /// them. The light never does.
    fn reset(&mut self) {}
}

impl<F: FnMut(CameraSample) -> PixelSample> RayTracer for F {
    fn trace(&mut self, sample: CameraSample) -> PixelSample {
        self(sample)
    }
}

impl<'w, 's, A: Accelerator, E: Effects, const LEVELS: usize> Tracer<'w, 's, A, E, LEVELS> {
    /// This tracer at work: what [`render()`](crate::render()) and samplers take.
    pub fn with_worker<'t, T: Tally, const SHADOW_CACHE_ENTRIES: usize>(
        &'t self,
        worker: &'t mut Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>,
    ) -> impl RayTracer {
        TracerWithWorker { tracer: self, worker }
    }
}

/// A tracer, and what it changes while it traces.
struct TracerWithWorker<'t, Tracer, Worker> {
    tracer: &'t Tracer,
    worker: &'t mut Worker,
}

impl<'w, 's, A: Accelerator, E: Effects, T: Tally, const LEVELS: usize, const SHADOW_CACHE_ENTRIES: usize>
    RayTracer
    for TracerWithWorker<'_, Tracer<'w, 's, A, E, LEVELS>, Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>>
{
    #[inline(always)]
    fn trace(&mut self, sample: CameraSample) -> PixelSample {
        self.tracer.trace(sample, self.worker)
    }

    fn reset(&mut self) {
        self.worker.clear_caches();
    }
}
