//! A picture to be traced by a tracer whose type is still to be chosen, for either precision.

use std::marker::PhantomData;

use super::strahl::{
    Accelerator, Camera, Counters, EffectSet, Effects, Event, Limits, RayCounters, Real, Rgb, Sample, Sight,
    Step, Tally, Tracer, Worker, World,
};
use super::workers::{self, Eye, Eyes, LEVELS};
use crate::progress::Watch;
use crate::stop::Stop;
use crate::studio::NoFrame;
use crate::wanted::Wanted;

/// All pixels of a picture, or why they were given up.
pub type Pixels = Result<workers::Traced<Rgb>, Stop>;

/// A picture to be traced by a tracer whose type is still to be chosen.
pub struct Job<'j, 's, A> {
    pub(super) world: &'j World<'s, A>,
    pub(super) camera: Camera,
    pub(super) wanted: &'j Wanted,
    /// Asks eyes for all pixels, in some order.
    pub(super) all: &'j dyn Fn(&dyn Eyes) -> Pixels,
}

/// Colours, and the work: that of tests where it was to be counted.
pub type Traced = (Vec<strahl_core::Rgb>, Option<Counters>);

impl<'s, A: Accelerator + Sync> Job<'_, 's, A> {
    /// What the scene and the camera ask for.
    pub fn asks(&self) -> EffectSet {
        EffectSet { lens: self.camera.has_lens(), ..self.world.scene().effects() }
    }

    /// Whether tests are to be counted, and not only rays.
    pub fn is_counted(&self) -> bool {
        self.wanted.counted || self.wanted.sheet.is_some()
    }

    /// Traces it with the effects `E`, and counts everything.
    pub fn counting_all<E: Effects + Sync>(&self) -> Result<Traced, NoFrame> {
        self.run::<E, Counters>()
    }

    /// Traces it with the effects `E`, and counts rays.
    pub fn counting_rays<E: Effects + Sync>(&self) -> Result<Traced, NoFrame> {
        self.run::<E, RayCounters>()
    }

    fn run<E: Effects + Sync, T: Count>(&self) -> Result<Traced, NoFrame> {
        let limits = self.wanted.limits;
        let limits = Limits { levels: limits.levels, cutoff: Real::from(limits.cutoff) };
        let tracer = Tracer::<A, E, LEVELS>::new(self.world, self.camera, limits).map_err(NoFrame::wrong)?;
        let eyes =
            Tracing { tracer, shadow_cache: self.wanted.shadow_cache, tally: PhantomData::<fn() -> T> };
        let (colors, counted) = (self.all)(&eyes).map_err(NoFrame::Stopped)?;
        Ok((rounded(colors), counted))
    }
}

/// A tracer whose workers report to a `T`.
struct Tracing<'t, 's, A, E, T> {
    tracer: Tracer<'t, 's, A, E, LEVELS>,
    shadow_cache: bool,
    tally: PhantomData<fn() -> T>,
}

impl<A: Accelerator + Sync, E: Effects + Sync, T: Count> Eyes for Tracing<'_, '_, A, E, T> {
    fn open<'e>(&'e self, watch: &'e Watch) -> Box<dyn Eye + 'e> {
        let worker = Worker::new(Watched { tally: T::default(), watch, left: BETWEEN });
        let worker = if self.shadow_cache { worker } else { worker.without_shadow_cache() };
        Box::new(Looking { tracer: &self.tracer, worker })
    }
}

/// A tracer at work.
struct Looking<'l, 't, 's, A: Accelerator, E, T> {
    tracer: &'l Tracer<'t, 's, A, E, LEVELS>,
    worker: Worker<A, Watched<'l, T>, LEVELS>,
}

impl<A: Accelerator, E: Effects, T: Count> Eye for Looking<'_, '_, '_, A, E, T> {
    fn look(&mut self, sample: Sample) -> Sight {
        self.tracer.look(sample, &mut self.worker)
    }

    fn take(&mut self) -> Option<Counters> {
        self.worker.tally_mut().tally.take()
    }
}

/// So many rays of one tree are traced before it is asked again whether to stop.
const BETWEEN: u32 = 1 << 12;

/// A tally that gives up a tree of rays when the work is to stop.
struct Watched<'w, T> {
    tally: T,
    watch: &'w Watch,
    /// Rays until it is asked.
    left: u32,
}

impl<T: Tally> Tally for Watched<'_, T> {
    const TESTS: bool = T::TESTS;

    #[inline(always)]
    fn count(&mut self, event: Event) {
        self.tally.count(event);
    }

    #[inline(always)]
    fn tell(&mut self, step: Step) {
        self.tally.tell(step);
    }

    #[inline(always)]
    fn gives_up(&mut self) -> bool {
        match self.left.checked_sub(1) {
            Some(left) => {
                self.left = left;
                false
            }
            None => {
                let stops = self.watch.check().is_err();
                self.left = if stops { 0 } else { BETWEEN };
                stops
            }
        }
    }
}

/// A tally that may be one of [`Counters`].
trait Count: Tally + Default {
    fn take(&mut self) -> Option<Counters>;
}

impl Count for RayCounters {
    fn take(&mut self) -> Option<Counters> {
        Some(std::mem::take(self).counters)
    }
}

impl Count for Counters {
    fn take(&mut self) -> Option<Counters> {
        Some(std::mem::take(self))
    }
}

/// Colours in single precision; those of single precision stay where they are.
fn rounded(colors: Vec<Rgb>) -> Vec<strahl_core::Rgb> {
    #[allow(clippy::unnecessary_cast)] // in single precision
    let narrow = |c: Rgb| strahl_core::Rgb::new(c.r as f32, c.g as f32, c.b as f32);
    colors.into_iter().map(narrow).collect()
}
