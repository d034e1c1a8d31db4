//! From a scene to linear colours, for either precision.

use std::cell::RefCell;
use std::time::{Duration, Instant};

use super::accelerators::{Purpose, build};
use super::choose;
use super::job::{Job, Pixels, Traced};
use super::passes;
use super::strahl::{
    Accelerator, Camera, Counters, Everything, PerRayKind, RayKind, Sample, Scene, Sight, Size, World,
};
use super::tables::{Stock, view};
use super::workers::{self, Eye, Eyes};
use crate::description::View;
use crate::finding::{Facts, Finding};
use crate::pace::Pace;
use crate::progress::Watch;
use crate::sheet::{Cost, Sheet};
use crate::studio::{Drawn, NoFrame, Studio};
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

/// Eyes of which every look is charged to a pixel.
struct Charging<'c> {
    eyes: &'c dyn Eyes,
    sheet: &'c Sheet,
}

impl Eyes for Charging<'_> {
    fn open<'e>(&'e self, watch: &'e Watch) -> Box<dyn Eye + 'e> {
        Box::new(Charged { eye: self.eyes.open(watch), sheet: self.sheet, sum: None })
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
        let spent = |counts: PerRayKind| RayKind::ALL.map(|kind| counts[kind] as u32);
        let cost = Cost {
            rays: spent(counters.rays),
            boxes: spent(counters.boxes),
            shapes: spent(counters.shapes),
            regions: spent(counters.regions),
            skipped: spent(counters.skipped),
            level: counters.deepest,
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
