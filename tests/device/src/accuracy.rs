//! The cost of accuracy on the chip: the golden scene with other levels, cutoffs and samplers.
//!
//! The firmware of each precision draws these pictures, and the host computes their errors
//! (`tests/examples/accuracy.rs`). The first is the golden picture.

use core::fmt;

use strahl_core::accel::{Accelerator, List, group_count};
use strahl_core::geometry::Aabb;
use strahl_core::image::{
    AdaptiveSampler, CacheEntry, ContrastThreshold, CornerRowCache, RegularSampler, Sampler,
    StochasticSampler, Subdivision,
};
use strahl_core::tally::{Counters, RayKind, Tally};
use strahl_core::trace::PixelSample;
use strahl_core::{Camera, CenterSampler, Limits, Real, Scene, World};

use crate::draw::{DrawCost, DrawSettings, PixelBytes, bytes, draw};
use crate::scene::{GoldenEffects, ITEMS, LEVELS, LIMITS, SIZE, VIEW, parts};

/// Settings of one picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccuracyRun {
    /// Levels and cutoff.
    pub limits: Limits,
    /// Sampler.
    pub sampling: FirmwareSampler,
}

/// Levels, cutoff and sampler, separated by spaces.
impl fmt::Display for AccuracyRun {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.limits.levels, self.limits.cutoff, self.sampling)
    }
}

/// Sampler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FirmwareSampler {
    /// One ray per pixel.
    Single,
    /// A regular grid of `n` times `n` rays.
    Regular(u16),
    /// Adaptive subdivision: maximum depth, and contrast threshold.
    Adaptive(u8, Real),
    /// This number of stochastic rays.
    Stochastic(u32),
}

/// As on the command line.
impl fmt::Display for FirmwareSampler {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FirmwareSampler::Single => f.write_str("single"),
            FirmwareSampler::Regular(n) => write!(f, "regular:{n}"),
            FirmwareSampler::Adaptive(depth, threshold) => write!(f, "adaptive:{depth}:{threshold}"),
            FirmwareSampler::Stochastic(n) => write!(f, "stochastic:{n}"),
        }
    }
}

const fn run(levels: u8, cutoff: Real, sampling: FirmwareSampler) -> AccuracyRun {
    AccuracyRun { limits: Limits { levels, cutoff }, sampling }
}

/// The cutoff of the golden picture.
const CUTOFF: Real = LIMITS.cutoff;

/// All pictures.
pub const RUNS: [AccuracyRun; 14] = [
    run(LIMITS.levels, CUTOFF, FirmwareSampler::Single),
    run(1, CUTOFF, FirmwareSampler::Single),
    run(2, CUTOFF, FirmwareSampler::Single),
    run(3, CUTOFF, FirmwareSampler::Single),
    run(4, CUTOFF, FirmwareSampler::Single),
    run(5, CUTOFF, FirmwareSampler::Single),
    run(LIMITS.levels, 0.0, FirmwareSampler::Single),
    run(LIMITS.levels, 1.0 / 64.0, FirmwareSampler::Single),
    run(LIMITS.levels, 1.0 / 8.0, FirmwareSampler::Single),
    run(LIMITS.levels, CUTOFF, FirmwareSampler::Regular(2)),
    run(LIMITS.levels, CUTOFF, FirmwareSampler::Regular(3)),
    run(LIMITS.levels, CUTOFF, FirmwareSampler::Adaptive(2, 0.0625)),
    run(LIMITS.levels, CUTOFF, FirmwareSampler::Stochastic(4)),
    run(LIMITS.levels, CUTOFF, FirmwareSampler::Stochastic(9)),
];

const WIDTH: usize = SIZE.width() as usize;

/// Buffers for a list and for an adaptive sampler, in static RAM.
pub struct ProvidedBuffers {
    boxes: [Aabb; ITEMS],
    groups: [Aabb; group_count(ITEMS)],
    row: [PixelBytes; WIDTH],
    corners: [PixelSample; WIDTH + 1],
    cache: [CacheEntry; 64],
}

impl ProvidedBuffers {
    /// Empty buffers.
    pub const NEW: ProvidedBuffers = ProvidedBuffers {
        boxes: [Aabb::EMPTY; ITEMS],
        groups: [Aabb::EMPTY; group_count(ITEMS)],
        row: [[[0; size_of::<f32>()]; 3]; WIDTH],
        corners: [PixelSample::BLACK; WIDTH + 1],
        cache: [CacheEntry::EMPTY; 64],
    };
}

/// Draws all pictures. Calls `take` with each row, and after each picture `drawn` with its cost and `end`
/// with its number of rays.
pub fn all(
    buffers: &mut ProvidedBuffers,
    clock: impl Fn() -> u32,
    mut take: impl FnMut(&[PixelBytes]) -> bool,
    mut draw_result: impl FnMut(&AccuracyRun, DrawCost<()>),
    mut end: impl FnMut(u64),
) -> Result<(), &'static str> {
    let scene = Scene::new(parts()).map_err(|_| "invalid scene")?;
    for (bounds, item) in buffers.boxes.iter_mut().zip(parts().geometry.all_bounds()) {
        *bounds = item;
    }
    let list = List::with_boxes(&buffers.boxes, &mut buffers.groups).map_err(|_| "too few boxes")?;
    let world = World::new(scene, list);
    let camera = Camera::new(&VIEW, SIZE).map_err(|_| "invalid camera")?;
    for run in &RUNS {
        let settings = DrawSettings { size: SIZE, camera, limits: run.limits };
        let mut corner_buffers = (&mut buffers.row[..], &mut buffers.corners[..], &mut buffers.cache[..]);
        let cost = picture(&world, settings, run.sampling, (), &mut corner_buffers, &clock, &mut take)?;
        draw_result(run, cost);
        end(rays(&world, settings, run.sampling, &mut corner_buffers)?);
    }
    Ok(())
}

/// Number of rays of a picture, which is drawn again, because counting costs instructions and stack.
#[inline(never)]
fn rays<A: Accelerator>(
    world: &World<'_, A>,
    settings: DrawSettings,
    sampling: FirmwareSampler,
    corner_buffers: &mut CornerBuffers<'_>,
) -> Result<u64, &'static str> {
    let counted = picture(world, settings, sampling, Counters::new(), corner_buffers, || 0, |_| true)?;
    Ok(RayKind::ALL.into_iter().map(|kind| counted.tally.rays[kind]).sum())
}

type CornerBuffers<'m> = (&'m mut [PixelBytes], &'m mut [PixelSample], &'m mut [CacheEntry]);

fn picture<A: Accelerator, T: Tally>(
    world: &World<'_, A>,
    settings: DrawSettings,
    sampling: FirmwareSampler,
    tally: T,
    (row, corners, cache): &mut CornerBuffers<'_>,
    clock: impl Fn() -> u32,
    take: impl FnMut(&[PixelBytes]) -> bool,
) -> Result<DrawCost<T>, &'static str> {
    let invalid = "invalid sampler settings";
    match sampling {
        FirmwareSampler::Single => draw_result(world, settings, &mut CenterSampler, tally, row, clock, take),
        FirmwareSampler::Regular(n) => {
            let mut regular = RegularSampler::new(n).ok_or(invalid)?;
            draw_result(world, settings, &mut regular, tally, row, clock, take)
        }
        FirmwareSampler::Adaptive(depth, threshold) => {
            let contrast = ContrastThreshold::new(threshold).ok_or(invalid)?;
            let subdivision = Subdivision::new(depth, contrast).ok_or(invalid)?;
            let mut adaptive = AdaptiveSampler::new(subdivision, CornerRowCache::new(corners), cache);
            draw_result(world, settings, &mut adaptive, tally, row, clock, take)
        }
        FirmwareSampler::Stochastic(n) => {
            let mut stochastic = StochasticSampler::new(n).ok_or(invalid)?;
            draw_result(world, settings, &mut stochastic, tally, row, clock, take)
        }
    }
}

/// Not inlined, so that each instance has its own stack frame.
#[inline(never)]
fn draw_result<A: Accelerator, S: Sampler, T: Tally>(
    world: &World<'_, A>,
    settings: DrawSettings,
    sampler: &mut S,
    tally: T,
    row: &mut [PixelBytes],
    clock: impl Fn() -> u32,
    take: impl FnMut(&[PixelBytes]) -> bool,
) -> Result<DrawCost<T>, &'static str> {
    draw::<_, GoldenEffects, _, _, _, LEVELS>(world, settings, sampler, tally, row, clock, bytes, take)
}
