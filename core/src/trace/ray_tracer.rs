//! The interface between samplers and tracers.

use super::{PixelSample, Tracer, Worker};
use crate::accel::Accelerator;
use crate::scene::{CameraSample, Effects};
use crate::tally::Tally;

/// Traces camera samples. Hides the types of the scene, accelerator, effects and tally from samplers.
///
/// [`Tracer::with_worker`] returns one, and every closure from [`CameraSample`] to [`PixelSample`] is one.
/// The trait is object-safe: code that is compiled once for all tracers takes `&mut dyn RayTracer`.
///
/// ```
/// use strahl_core::image::{Pixel, Sampler};
/// use strahl_core::scene::CameraSample;
/// use strahl_core::trace::{HitId, PixelSample};
/// use strahl_core::{CenterSampler, Rgb};
///
/// // A closure instead of a scene: a horizontal gradient.
/// let mut gradient =
///     |sample: CameraSample| PixelSample { color: Rgb::gray(sample.point.x / 8.0), hit: HitId::Nothing };
/// let sample = CenterSampler.sample_pixel(Pixel { x: 3, y: 0 }, &mut gradient);
/// assert_eq!(sample.color, Rgb::gray(3.5 / 8.0));
/// ```
pub trait RayTracer {
    /// Traces one camera sample: its radiance and the item that the camera ray hits.
    fn trace(&mut self, sample: CameraSample) -> PixelSample;

    /// Clears all caches, so that counters of the following samples do not depend on earlier ones. Radiance
    /// never does.
    fn reset(&mut self) {}
}

impl<F: FnMut(CameraSample) -> PixelSample> RayTracer for F {
    fn trace(&mut self, sample: CameraSample) -> PixelSample {
        self(sample)
    }
}

impl<'w, 's, A: Accelerator, E: Effects, const LEVELS: usize> Tracer<'w, 's, A, E, LEVELS> {
    /// This tracer with a worker: the ray tracer that [`render()`](crate::render()) and samplers take.
    ///
    /// [`RayTracer::reset`] clears the caches of the worker.
    pub fn with_worker<'t, T: Tally, const SHADOW_CACHE_ENTRIES: usize>(
        &'t self,
        worker: &'t mut Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>,
    ) -> impl RayTracer {
        TracerWithWorker { tracer: self, worker }
    }
}

/// A tracer and its worker.
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
