//! From a description to a picture, and what it took.

use std::time::{Duration, Instant};

use strahl_core::{Counters, EffectSet, Scene, Shape};
use strahl_picture::Picture;

use crate::description::Description;
use crate::finding::{self, Finding};
use crate::plan::asked_by;
use crate::precision::Precision;
use crate::progress::Watch;
use crate::stock;
use crate::studio::{Drawn, NoFrame, Studio};
use crate::wanted::Wanted;
use crate::{double, draw};

/// A picture, and what it took.
#[derive(Debug)]
pub struct Frame {
    /// The picture.
    pub picture: Picture,
    /// What was computed with.
    pub precision: Precision,
    /// What was in the scene.
    pub facts: Facts,
    /// How items were found.
    pub accelerator: finding::Facts,
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
    /// What is in this scene.
    pub fn of(description: &Description, scene: &Scene<'_>) -> Self {
        let parts = scene.parts();
        let is_triangle = |s: &&Shape| matches!(s, Shape::Triangle(_) | Shape::SmoothTriangle(_));
        Facts {
            objects: parts.geometry.shapes.len(),
            triangles: parts.geometry.shapes.iter().filter(is_triangle).count(),
            lights: parts.lights.len(),
            asks: asked_by(description, scene),
        }
    }
}

/// What is done with a scene: the last picture that is traced, and what was wanted of it.
pub type Work<'w> = &'w mut dyn FnMut(&dyn Studio) -> Result<(Wanted, Drawn), NoFrame>;

/// Makes the tables and the accelerator once, and lets `work` trace pictures with them: the
/// frame is that of the last.
pub fn open(
    description: &Description,
    precision: Precision,
    finding: &Finding,
    work: Work<'_>,
) -> Result<Frame, NoFrame> {
    let clock = Instant::now();
    let stock = stock::single::Stock::new(description);
    let facts = Facts::of(description, &stock.scene().map_err(NoFrame::wrong)?);
    let mut build = Duration::ZERO;
    let mut last = None;
    let mut work = |studio: &dyn Studio| {
        build = clock.elapsed();
        last = Some(work(studio));
    };
    match precision {
        Precision::Single => draw::open(&stock, &description.view, finding, &mut work)?,
        Precision::Double => {
            drop(stock);
            let stock = stock::double::Stock::new(description);
            double::draw::open(&stock, &description.view, finding, &mut work)?;
        }
    }
    let (wanted, drawn) = last.unwrap_or_else(|| Err(NoFrame::wrong("nothing was traced")))?;
    Ok(Frame {
        picture: Picture { size: wanted.picture(), colors: drawn.colors },
        precision,
        facts,
        accelerator: drawn.accelerator,
        counters: drawn.counts,
        build,
        trace: drawn.trace,
        trace_cpu: drawn.trace_cpu,
    })
}

/// Traces what is described.
pub fn trace(description: &Description, wanted: &Wanted, watch: &Watch) -> Result<Frame, NoFrame> {
    open(description, wanted.precision, &wanted.finding, &mut |studio| {
        Ok((wanted.clone(), studio.trace(wanted, watch)?))
    })
}
