//! From a scene to linear colours, for either precision.

use std::marker::PhantomData;
use std::time::{Duration, Instant};

use super::accelerators::{Purpose, build};
use super::choose;
use super::strahl::{
    Accelerator, Camera, Counters, EffectSet, Effects, Everything, Limits, RayKind, Real, Rgb, Sample, Scene,
    Sight, Size, Tally, Tracer, Worker, World,
};
use super::tables::{Stock, view};
use super::workers::{self, Eye, Eyes, LEVELS};
use crate::counts::Counts;
use crate::description::View;
use crate::finding::Facts;
use crate::frame::{Drawn, NoFrame};
use crate::progress::Watch;
use crate::sheet::{Cost, Sheet};
use crate::wanted::{Looped, Wanted};

/// Traces the scene of these tables.
pub fn trace(stock: &Stock, from: &View, wanted: &Wanted, watch: &Watch) -> Result<Drawn, NoFrame> {
    let scene = stock.scene().map_err(NoFrame::wrong)?;
    let size = wanted.size;
    let size = Size::new(size.width(), size.height()).ok_or_else(|| NoFrame::wrong("no such size"))?;
    let camera = Camera::new(&view(from), size).map_err(NoFrame::wrong)?;
    build(&scene, &wanted.finding, Drawing { scene, camera, size, wanted, watch }).map_err(NoFrame::wrong)?
}

/// Everything that is needed for a picture but an accelerator.
struct Drawing<'d, 's> {
    scene: Scene<'s>,
    camera: Camera,
    size: Size,
    wanted: &'d Wanted,
    watch: &'d Watch,
}

impl Purpose for Drawing<'_, '_> {
    type Answer = Result<Drawn, NoFrame>;

    fn with<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> Self::Answer {
        self.traced(accelerator, facts, choose::trace)
    }

    fn seldom<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> Self::Answer {
        self.traced(accelerator, facts, |job| job.counted::<Everything>())
    }
}

impl<'s> Drawing<'_, 's> {
    fn traced<A: Accelerator + Sync>(
        self,
        accelerator: A,
        facts: Facts,
        trace: impl FnOnce(&Job<'_, 's, A>) -> Result<Traced, NoFrame>,
    ) -> Result<Drawn, NoFrame> {
        let Drawing { scene, camera, size, wanted, watch } = self;
        let (clock, cpu) = (Instant::now(), cpu_time());
        let world = World::new(scene, accelerator);
        let (colors, counts) = trace(&Job { world: &world, camera, size, wanted, watch })?;
        Ok(Drawn {
            colors,
            accelerator: facts,
            counts,
            trace: clock.elapsed(),
            trace_cpu: cpu_time().saturating_sub(cpu),
        })
    }
}

/// A picture to be traced by a tracer whose type is still to be chosen.
pub struct Job<'j, 's, A> {
    world: &'j World<'s, A>,
    camera: Camera,
    size: Size,
    wanted: &'j Wanted,
    watch: &'j Watch,
}

/// Colours, and the work where it was counted.
pub type Traced = (Vec<strahl_core::Rgb>, Option<Counts>);

impl<'s, A: Accelerator + Sync> Job<'_, 's, A> {
    /// What the scene and the camera ask for.
    pub fn asks(&self) -> EffectSet {
        EffectSet { lens: self.camera.has_lens(), ..self.world.scene().effects() }
    }

    /// Whether the work is to be counted.
    pub fn is_counted(&self) -> bool {
        self.wanted.counted || self.wanted.sheet.is_some()
    }

    /// Whether the loop that holds everything is asked for.
    pub fn is_general(&self) -> bool {
        self.wanted.looped == Looped::General
    }

    /// Traces it with the effects `E`, and counts.
    pub fn counted<E: Effects + Sync>(&self) -> Result<Traced, NoFrame> {
        self.run::<E, Counters>()
    }

    /// Traces it with the effects `E`.
    pub fn uncounted<E: Effects + Sync>(&self) -> Result<Traced, NoFrame> {
        self.run::<E, ()>()
    }

    fn run<E: Effects + Sync, T: Count>(&self) -> Result<Traced, NoFrame> {
        let limits = self.wanted.limits;
        let limits = Limits { levels: limits.levels, cutoff: Real::from(limits.cutoff) };
        let tracer = Tracer::<A, E, LEVELS>::new(self.world, self.camera, limits).map_err(NoFrame::wrong)?;
        let eyes =
            Tracing { tracer, shadow_cache: self.wanted.shadow_cache, tally: PhantomData::<fn() -> T> };
        let charging;
        let eyes: &dyn Eyes = match &self.wanted.sheet {
            None => &eyes,
            Some(sheet) => {
                charging = Charging { eyes: &eyes, sheet };
                &charging
            }
        };
        let (colors, counted) =
            workers::trace(eyes, self.wanted, self.size, self.watch).map_err(NoFrame::Stopped)?;
        Ok((rounded(colors), counted.as_ref().map(counts)))
    }
}

/// A tracer whose workers report to a `T`.
struct Tracing<'t, 's, A, E, T> {
    tracer: Tracer<'t, 's, A, E, LEVELS>,
    shadow_cache: bool,
    tally: PhantomData<fn() -> T>,
}

impl<A: Accelerator + Sync, E: Effects + Sync, T: Count> Eyes for Tracing<'_, '_, A, E, T> {
    fn open(&self) -> Box<dyn Eye + '_> {
        let worker = Worker::new(T::default());
        let worker = if self.shadow_cache { worker } else { worker.without_shadow_cache() };
        Box::new(Looking { tracer: &self.tracer, worker })
    }
}

/// A tracer at work.
struct Looking<'l, 't, 's, A: Accelerator, E, T> {
    tracer: &'l Tracer<'t, 's, A, E, LEVELS>,
    worker: Worker<A, T, LEVELS>,
}

impl<A: Accelerator, E: Effects, T: Count> Eye for Looking<'_, '_, '_, A, E, T> {
    fn look(&mut self, sample: Sample) -> Sight {
        self.tracer.look(sample, &mut self.worker)
    }

    fn counters(&self) -> Option<&Counters> {
        self.worker.tally().counters()
    }
}

/// Eyes of which every look is charged to a pixel.
struct Charging<'c> {
    eyes: &'c dyn Eyes,
    sheet: &'c Sheet,
}

impl Eyes for Charging<'_> {
    fn open(&self) -> Box<dyn Eye + '_> {
        Box::new(Charged { eye: self.eyes.open(), sheet: self.sheet })
    }
}

/// One of them.
struct Charged<'c> {
    eye: Box<dyn Eye + 'c>,
    sheet: &'c Sheet,
}

impl Eye for Charged<'_> {
    fn look(&mut self, sample: Sample) -> Sight {
        let before = self.eye.counters().copied().unwrap_or_default();
        let sight = self.eye.look(sample);
        let after = self.eye.counters().copied().unwrap_or_default();
        let spent = |of: fn(&Counters, RayKind) -> u64| {
            RayKind::ALL.map(|kind| (of(&after, kind) - of(&before, kind)) as u32)
        };
        let cost = Cost {
            rays: spent(Counters::rays),
            boxes: spent(Counters::boxes),
            shapes: spent(Counters::shapes),
            regions: spent(Counters::regions),
            skipped: spent(Counters::skipped),
        };
        #[allow(clippy::useless_conversion)] // in double precision
        self.sheet.charge(sample.place.x.into(), sample.place.y.into(), &cost);
        sight
    }

    fn counters(&self) -> Option<&Counters> {
        self.eye.counters()
    }
}

/// A tally that may be one of [`Counters`].
trait Count: Tally + Default {
    fn counters(&self) -> Option<&Counters>;
}

impl Count for () {
    fn counters(&self) -> Option<&Counters> {
        None
    }
}

impl Count for Counters {
    fn counters(&self) -> Option<&Counters> {
        Some(self)
    }
}

/// Colours in single precision; those of single precision stay where they are.
fn rounded(colors: Vec<Rgb>) -> Vec<strahl_core::Rgb> {
    #[allow(clippy::unnecessary_cast)] // in single precision
    let narrow = |c: Rgb| strahl_core::Rgb::new(c.r as f32, c.g as f32, c.b as f32);
    colors.into_iter().map(narrow).collect()
}

/// Counts that are the same for either precision.
fn counts(counters: &Counters) -> Counts {
    use super::strahl::{RayKind, ShapeKind};
    Counts {
        rays: RayKind::ALL.map(|kind| counters.rays(kind)),
        camera_hits: counters.camera_hits(),
        boxes: RayKind::ALL.map(|kind| counters.boxes(kind)),
        shapes: RayKind::ALL.map(|kind| counters.shapes(kind)),
        regions: RayKind::ALL.map(|kind| counters.regions(kind)),
        skipped: RayKind::ALL.map(|kind| counters.skipped(kind)),
        shadow_cache_asked: counters.shadow_cache_asked(),
        shadow_cache_hits: counters.shadow_cache_hits(),
        by_shape: ShapeKind::ALL.map(|kind| counters.by_shape(kind)),
        level_limit: counters.level_limit(),
        level_limit_weight: counters.level_limit_weight(),
        cutoff: counters.cutoff(),
        cutoff_weight: counters.cutoff_weight(),
        media_full: counters.media_full(),
    }
}

/// The processor time that this process has used on all threads.
#[cfg(unix)]
fn cpu_time() -> Duration {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(now.tv_sec.unsigned_abs(), now.tv_nsec.unsigned_abs() as u32)
}

/// Not known here.
#[cfg(not(unix))]
fn cpu_time() -> Duration {
    Duration::ZERO
}
