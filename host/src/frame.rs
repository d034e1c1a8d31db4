//! From a description to a picture, and what it took.

use std::fmt;
use std::time::{Duration, Instant};

use strahl_core::{
    Aabb, BuildError, Camera, Counters, EffectSet, List, Scene, SceneError, Shape, ViewFault, groups_of,
};

use crate::choose::{self, NotTraced, Wanted};
use crate::description::Description;
use crate::picture::Picture;
use crate::progress::Watch;
use crate::stock::single::{self, Stock};

/// A picture, and what it took.
#[derive(Debug)]
pub struct Frame {
    /// The picture.
    pub picture: Picture,
    /// What was in the scene.
    pub facts: Facts,
    /// How items were found.
    pub accelerator: AcceleratorFacts,
    /// The work, where it was counted.
    pub counters: Option<Counters>,
    /// Wall-clock time of making the tables and the accelerator.
    pub build: Duration,
    /// Wall-clock time of tracing.
    pub trace: Duration,
    /// Processor time of tracing, the sum over all threads.
    pub trace_cpu: Duration,
}

/// What is in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Facts {
    /// All items.
    pub objects: usize,
    /// Those that are triangles.
    pub triangles: usize,
    /// All lights.
    pub lights: usize,
    /// What it asks for.
    pub asks: EffectSet,
}

impl Facts {
    fn of(scene: &Scene<'_>) -> Self {
        let parts = scene.parts();
        let is_triangle = |s: &&Shape| matches!(s, Shape::Triangle(_) | Shape::SmoothTriangle(_));
        Facts {
            objects: parts.geometry.shapes.len(),
            triangles: parts.geometry.shapes.iter().filter(is_triangle).count(),
            lights: parts.lights.len(),
            asks: scene.effects(),
        }
    }
}

/// What an accelerator is like.
#[derive(Clone, Copy, Debug)]
pub struct AcceleratorFacts {
    /// Its name on the command line.
    pub kind: &'static str,
    /// The memory it uses.
    pub bytes: usize,
    /// Its regions.
    pub regions: usize,
}

/// Why there is no picture.
#[derive(Debug)]
pub enum NoFrame {
    /// What is described makes no scene.
    Scene(SceneError),
    /// The view shows nothing.
    View(ViewFault),
    /// There is no accelerator for it.
    Build(BuildError),
    /// It was not traced, or not to its end.
    Trace(NotTraced),
}

impl fmt::Display for NoFrame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoFrame::Scene(error) => error.fmt(f),
            NoFrame::View(error) => error.fmt(f),
            NoFrame::Build(error) => error.fmt(f),
            NoFrame::Trace(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for NoFrame {}

/// Traces what is described.
pub fn trace(description: &Description, wanted: &Wanted, watch: &Watch) -> Result<Frame, NoFrame> {
    let clock = Instant::now();
    let stock = Stock::new(description);
    let scene = stock.scene().map_err(NoFrame::Scene)?;
    let camera = Camera::new(&single::view(&description.view), wanted.size).map_err(NoFrame::View)?;
    let boxes: Vec<Aabb> = scene.parts().geometry.all_bounds().collect();
    let mut groups = vec![Aabb::EMPTY; groups_of(boxes.len())];
    let list = List::boxed(&boxes, &mut groups).map_err(NoFrame::Build)?;
    let accelerator = AcceleratorFacts { kind: "list", bytes: list.bytes(), regions: groups_of(boxes.len()) };
    let build = clock.elapsed();

    let (clock, cpu) = (Instant::now(), cpu_time());
    let (colors, counters) = choose::trace(scene, list, camera, wanted, watch).map_err(NoFrame::Trace)?;
    Ok(Frame {
        picture: Picture { size: wanted.size, colors },
        facts: Facts::of(&scene),
        accelerator,
        counters,
        build,
        trace: clock.elapsed(),
        trace_cpu: cpu_time().saturating_sub(cpu),
    })
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
