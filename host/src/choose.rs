//! Values become types, once, around the whole render.
//!
//! The tracer's loop is compiled for each combination of accelerator, effects and tally; the
//! loop itself holds no mode. Of the prepared sets of effects the smallest that holds what the
//! scene asks for is taken.

use std::fmt;

use strahl_core::{
    Accelerator, Camera, Counters, EffectSet, Effects, Everything, Limits, Rgb, Scene, Size, Tracer,
    TracerError, World,
};

use crate::progress::Watch;
use crate::signals::Stop;
use crate::workers::{self, Count, Cut, LEVELS, Sampling};

/// Light and shadow, but no secondary rays.
struct Local;

impl Effects for Local {
    const SET: EffectSet =
        EffectSet { reflection: false, transmission: false, absorption: false, ..EffectSet::ALL };
}

/// Mirrors, but nothing that light passes through.
struct Mirrors;

impl Effects for Mirrors {
    const SET: EffectSet = EffectSet { reflection: true, ..Local::SET };
}

/// What picture is wanted, and how the work is done.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// Width and height.
    pub size: Size,
    /// Levels and cutoff.
    pub limits: Limits,
    /// Rays in a pixel.
    pub sampling: Sampling,
    /// Threads and tiles.
    pub cut: Cut,
    /// Whether the work is counted.
    pub counted: bool,
}

/// Why nothing was traced.
#[derive(Debug)]
pub enum NotTraced {
    /// The tracer refuses.
    Tracer(TracerError),
    /// A signal came.
    Stopped(Stop),
}

impl fmt::Display for NotTraced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotTraced::Tracer(error) => error.fmt(f),
            NotTraced::Stopped(stop) => stop.fmt(f),
        }
    }
}

/// Linear colours, row by row, and the work where it was counted.
type Traced = (Vec<Rgb>, Option<Counters>);

/// Traces the picture that is wanted.
pub fn trace<A: Accelerator + Sync>(
    scene: Scene<'_>,
    accelerator: A,
    camera: Camera,
    wanted: &Wanted,
    watch: &Watch,
) -> Result<Traced, NotTraced> {
    let asks = scene.effects();
    let world = World::new(scene, accelerator);
    let job = Job { world: &world, camera, wanted, watch };
    if Local::SET.contains(&asks) {
        job.with::<Local>()
    } else if Mirrors::SET.contains(&asks) {
        job.with::<Mirrors>()
    } else {
        job.with::<Everything>()
    }
}

struct Job<'j, 's, A> {
    world: &'j World<'s, A>,
    camera: Camera,
    wanted: &'j Wanted,
    watch: &'j Watch,
}

impl<A: Accelerator + Sync> Job<'_, '_, A> {
    fn with<E: Effects + Sync>(&self) -> Result<Traced, NotTraced> {
        if self.wanted.counted {
            let (colors, counters) = self.run::<E, Counters>()?;
            Ok((colors, Some(counters)))
        } else {
            let (colors, ()) = self.run::<E, ()>()?;
            Ok((colors, None))
        }
    }

    fn run<E: Effects + Sync, T: Count>(&self) -> Result<(Vec<Rgb>, T), NotTraced> {
        let Wanted { size, limits, sampling, cut, .. } = *self.wanted;
        let tracer =
            Tracer::<A, E, LEVELS>::new(self.world, self.camera, limits).map_err(NotTraced::Tracer)?;
        workers::trace(&tracer, sampling, size, cut, self.watch).map_err(NotTraced::Stopped)
    }
}
