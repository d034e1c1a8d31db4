//! From a scene to linear colours, for either precision.

use std::cell::RefCell;
use std::marker::PhantomData;
use std::time::{Duration, Instant};

use super::accelerators::{Purpose, build};
use super::choose;
use super::passes;
use super::strahl::{
    Accelerator, Camera, Counters, EffectSet, Effects, Everything, Limits, RayCounters, RayKind, Real, Rgb,
    Sample, Scene, Sight, Size, Tally, Tracer, Worker, World,
};
use super::tables::{Stock, view};
use super::workers::{self, Eye, Eyes, LEVELS};
use crate::aim::pace::Pace;
use crate::counts::Counts;
use crate::description::View;
use crate::finding::{Facts, Finding};
use crate::frame::{Drawn, NoFrame, Studio};
use crate::progress::Watch;
use crate::sheet::{Cost, Sheet};
use crate::signals::Stop;
use crate::wanted::Wanted;

/// Builds the accelerator that is asked for over the scene of these tables, and lets `work` trace
/// pictures with it.
pub fn open(
    stock: &Stock,
    from: &View,
    finding: &Finding,
    work: &mut dyn FnMut(&dyn Studio),
) -> Result<(), NoFrame> {
    let scene = stock.scene().map_err(NoFrame::wrong)?;
    build(&scene, finding, Opening { scene, view: view(from), work }).map_err(NoFrame::wrong)
}

/// Everything that is needed for pictures but an accelerator.
struct Opening<'o, 's> {
    scene: Scene<'s>,
    view: super::strahl::View,
    work: &'o mut dyn FnMut(&dyn Studio),
}

impl Purpose for Opening<'_, '_> {
    type Answer = ();

    fn with<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) {
        self.opened(accelerator, facts, choose::trace);
    }

    fn asked<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) {
        self.opened(accelerator, facts, choose::trace_as_asked);
    }

    fn seldom<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) {
        self.opened(accelerator, facts, |job| job.counting_all::<Everything>());
    }
}

impl<'s> Opening<'_, 's> {
    fn opened<A: Accelerator + Sync>(
        self,
        accelerator: A,
        facts: Facts,
        trace: impl Fn(&Job<'_, 's, A>) -> Result<Traced, NoFrame>,
    ) {
        let Opening { scene, view, work } = self;
        work(&Opened { world: World::new(scene, accelerator), view, facts, trace });
    }
}

/// A world, and how a picture of it is traced.
struct Opened<'s, A, F> {
    world: World<'s, A>,
    view: super::strahl::View,
    facts: Facts,
    trace: F,
}

impl<'s, A, F> Opened<'s, A, F>
where
    A: Accelerator + Sync,
    F: Fn(&Job<'_, 's, A>) -> Result<Traced, NoFrame>,
{
    /// Traces a picture, `all` of whose pixels are asked for in some order.
    fn drawn(&self, wanted: &Wanted, all: &dyn Fn(&dyn Eyes, Size) -> Pixels) -> Result<Drawn, NoFrame> {
        let (clock, cpu) = (Instant::now(), cpu_time());
        let size = wanted.size;
        let size = Size::new(size.width(), size.height()).ok_or_else(|| NoFrame::wrong("no such size"))?;
        let camera = Camera::new(&self.view, size).map_err(NoFrame::wrong)?;
        let charged = |eyes: &dyn Eyes| match &wanted.sheet {
            Some(sheet) => all(&Charging { eyes, sheet }, size),
            None => all(eyes, size),
        };
        let job = Job { world: &self.world, camera, wanted, all: &charged };
        let (colors, counts) = (self.trace)(&job)?;
        Ok(Drawn {
            colors,
            accelerator: self.facts,
            counts,
            trace: clock.elapsed(),
            trace_cpu: cpu_time().saturating_sub(cpu),
        })
    }
}

impl<'s, A, F> Studio for Opened<'s, A, F>
where
    A: Accelerator + Sync,
    F: Fn(&Job<'_, 's, A>) -> Result<Traced, NoFrame>,
{
    fn trace(&self, wanted: &Wanted, watch: &Watch) -> Result<Drawn, NoFrame> {
        self.drawn(wanted, &|eyes, size| workers::trace(eyes, wanted, size, watch))
    }

    fn refine(&self, wanted: &Wanted, watch: &Watch, pace: &mut dyn Pace) -> Result<Drawn, NoFrame> {
        // Asked for once, whatever tracer is chosen.
        let pace = RefCell::new(pace);
        self.drawn(wanted, &|eyes, size| passes::trace(eyes, wanted, size, watch, &mut **pace.borrow_mut()))
    }
}

/// All pixels of a picture, or why they were given up.
type Pixels = Result<workers::Traced<Rgb>, Stop>;

/// A picture to be traced by a tracer whose type is still to be chosen.
pub struct Job<'j, 's, A> {
    world: &'j World<'s, A>,
    camera: Camera,
    wanted: &'j Wanted,
    all: &'j dyn Fn(&dyn Eyes) -> Pixels,
}

/// Colours, and the work: that of tests where it was to be counted.
pub type Traced = (Vec<strahl_core::Rgb>, Option<Counts>);

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

    fn take(&mut self) -> Option<Counters> {
        self.worker.tally_mut().take()
    }
}

/// Eyes of which every look is charged to a pixel.
struct Charging<'c> {
    eyes: &'c dyn Eyes,
    sheet: &'c Sheet,
}

impl Eyes for Charging<'_> {
    fn open(&self) -> Box<dyn Eye + '_> {
        Box::new(Charged { eye: self.eyes.open(), sheet: self.sheet, sum: None })
    }
}

/// One of them.
struct Charged<'c> {
    eye: Box<dyn Eye + 'c>,
    sheet: &'c Sheet,
    sum: Option<Counters>,
}

impl Eye for Charged<'_> {
    fn look(&mut self, sample: Sample) -> Sight {
        let sight = self.eye.look(sample);
        let Some(counters) = self.eye.take() else { return sight };
        let spent = |of: fn(&Counters, RayKind) -> u64| RayKind::ALL.map(|kind| of(&counters, kind) as u32);
        let cost = Cost {
            rays: spent(Counters::rays),
            boxes: spent(Counters::boxes),
            shapes: spent(Counters::shapes),
            regions: spent(Counters::regions),
            skipped: spent(Counters::skipped),
            level: counters.deepest(),
        };
        #[allow(clippy::useless_conversion)] // in double precision
        self.sheet.charge(sample.place.x.into(), sample.place.y.into(), &cost);
        workers::add(&mut self.sum, Some(counters));
        sight
    }

    fn take(&mut self) -> Option<Counters> {
        self.sum.take()
    }
}

/// A tally that may be one of [`Counters`].
trait Count: Tally + Default {
    fn take(&mut self) -> Option<Counters>;
}

impl Count for RayCounters {
    fn take(&mut self) -> Option<Counters> {
        Some(*std::mem::take(self).counters())
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

/// Counts that are the same for either precision.
fn counts(counters: &Counters) -> Counts {
    use super::strahl::ShapeKind;
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
        deepest: counters.deepest(),
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
