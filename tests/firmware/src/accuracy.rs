//! What accuracy costs on the chip: the golden scene with fewer levels, other cutoffs, and more rays
//! in a pixel.
//!
//! The firmware of either precision draws these pictures, and a host says how far off they are
//! (`tests/examples/accuracy.rs`). The first is the golden picture itself.

// Who includes this file may use a part of it.
#![allow(dead_code)]

use core::fmt;

use strahl_core::accel::{Accelerator, List, group_count};
use strahl_core::geometry::Aabb;
use strahl_core::image::{
    AdaptiveSampler, CacheEntry, ContrastThreshold, CornerRow, RegularSampler, Sampler, StochasticSampler,
    Subdivision,
};
use strahl_core::tally::{Counters, RayKind, Tally};
use strahl_core::trace::PixelSample;
use strahl_core::{Camera, CenterSampler, Limits, Real, Scene, World};

use crate::draw::{Bytes, Took, Wanted, bytes, draw};
use crate::scene::{Golden, ITEMS, LEVELS, LIMITS, SIZE, VIEW, parts};

/// One picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// How deep.
    pub limits: Limits,
    /// Which rays make a pixel.
    pub sampling: Sampling,
}

/// Which rays make a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    /// One.
    Single,
    /// So many times so many.
    Regular(u16),
    /// The corners, and those of quarters where they differ: so often, by more than so much.
    Adaptive(u8, Real),
    /// So many, without a raster.
    Stochastic(u32),
}

/// As the command line has it.
impl fmt::Display for Sampling {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Sampling::Single => f.write_str("single"),
            Sampling::Regular(n) => write!(f, "regular:{n}"),
            Sampling::Adaptive(depth, threshold) => write!(f, "adaptive:{depth}:{threshold}"),
            Sampling::Stochastic(n) => write!(f, "stochastic:{n}"),
        }
    }
}

const fn run(levels: u8, cutoff: Real, sampling: Sampling) -> Run {
    Run { limits: Limits { levels, cutoff }, sampling }
}

/// The cutoff of the golden picture.
const USUAL: Real = LIMITS.cutoff;

/// All of them.
pub const RUNS: [Run; 14] = [
    run(LIMITS.levels, USUAL, Sampling::Single),
    run(1, USUAL, Sampling::Single),
    run(2, USUAL, Sampling::Single),
    run(3, USUAL, Sampling::Single),
    run(4, USUAL, Sampling::Single),
    run(5, USUAL, Sampling::Single),
    run(LIMITS.levels, 0.0, Sampling::Single),
    run(LIMITS.levels, 1.0 / 64.0, Sampling::Single),
    run(LIMITS.levels, 1.0 / 8.0, Sampling::Single),
    run(LIMITS.levels, USUAL, Sampling::Regular(2)),
    run(LIMITS.levels, USUAL, Sampling::Regular(3)),
    run(LIMITS.levels, USUAL, Sampling::Adaptive(2, 0.0625)),
    run(LIMITS.levels, USUAL, Sampling::Stochastic(4)),
    run(LIMITS.levels, USUAL, Sampling::Stochastic(9)),
];

const WIDTH: usize = SIZE.width() as usize;

/// What is lent to a list and to an adaptive sampler: static RAM.
pub struct Lent {
    boxes: [Aabb; ITEMS],
    groups: [Aabb; group_count(ITEMS)],
    row: [Bytes; WIDTH],
    corners: [PixelSample; WIDTH + 1],
    kept: [CacheEntry; 64],
}

impl Lent {
    /// Nothing in it.
    pub const NEW: Lent = Lent {
        boxes: [Aabb::EMPTY; ITEMS],
        groups: [Aabb::EMPTY; group_count(ITEMS)],
        row: [[[0; size_of::<f32>()]; 3]; WIDTH],
        corners: [PixelSample::BLACK; WIDTH + 1],
        kept: [CacheEntry::EMPTY; 64],
    };
}

/// Draws one after the other. `take` is given the rows of each, `drawn` is told what it took, and
/// then `end` how many rays there were.
pub fn all(
    lent: &mut Lent,
    clock: impl Fn() -> u32,
    mut take: impl FnMut(&[Bytes]) -> bool,
    mut drawn: impl FnMut(&Run, Took<()>),
    mut end: impl FnMut(u64),
) -> Result<(), &'static str> {
    let scene = Scene::new(parts()).map_err(|_| "its parts make no scene")?;
    for (place, item) in lent.boxes.iter_mut().zip(parts().geometry.all_bounds()) {
        *place = item;
    }
    let list = List::with_boxes(&lent.boxes, &mut lent.groups).map_err(|_| "too few boxes")?;
    let world = World::new(scene, list);
    let camera = Camera::new(&VIEW, SIZE).map_err(|_| "the view shows nothing")?;
    for run in &RUNS {
        let wanted = Wanted { size: SIZE, camera, limits: run.limits };
        let mut rooms = (&mut lent.row[..], &mut lent.corners[..], &mut lent.kept[..]);
        let took = picture(&world, wanted, run.sampling, (), &mut rooms, &clock, &mut take)?;
        drawn(run, took);
        end(rays(&world, wanted, run.sampling, &mut rooms)?);
    }
    Ok(())
}

/// How many rays a picture takes: drawn once more, because counting costs instructions and stack.
#[inline(never)]
fn rays<A: Accelerator>(
    world: &World<'_, A>,
    wanted: Wanted,
    sampling: Sampling,
    rooms: &mut Rooms<'_>,
) -> Result<u64, &'static str> {
    let counted = picture(world, wanted, sampling, Counters::new(), rooms, || 0, |_| true)?;
    Ok(RayKind::ALL.into_iter().map(|kind| counted.tally.rays[kind]).sum())
}

type Rooms<'m> = (&'m mut [Bytes], &'m mut [PixelSample], &'m mut [CacheEntry]);

fn picture<A: Accelerator, T: Tally>(
    world: &World<'_, A>,
    wanted: Wanted,
    sampling: Sampling,
    tally: T,
    (row, corners, kept): &mut Rooms<'_>,
    clock: impl Fn() -> u32,
    take: impl FnMut(&[Bytes]) -> bool,
) -> Result<Took<T>, &'static str> {
    let none = "there is no such sampler";
    match sampling {
        Sampling::Single => drawn(world, wanted, &mut CenterSampler, tally, row, clock, take),
        Sampling::Regular(n) => {
            let mut regular = RegularSampler::new(n).ok_or(none)?;
            drawn(world, wanted, &mut regular, tally, row, clock, take)
        }
        Sampling::Adaptive(depth, threshold) => {
            let agreement = ContrastThreshold::new(threshold).ok_or(none)?;
            let parting = Subdivision::new(depth, agreement).ok_or(none)?;
            let mut adaptive = AdaptiveSampler::new(parting, CornerRow::new(corners), kept);
            drawn(world, wanted, &mut adaptive, tally, row, clock, take)
        }
        Sampling::Stochastic(n) => {
            let mut stochastic = StochasticSampler::new(n).ok_or(none)?;
            drawn(world, wanted, &mut stochastic, tally, row, clock, take)
        }
    }
}

/// Not inlined: each has the stack that it needs, and not that of another beside it.
#[inline(never)]
fn drawn<A: Accelerator, S: Sampler, T: Tally>(
    world: &World<'_, A>,
    wanted: Wanted,
    sampler: &mut S,
    tally: T,
    row: &mut [Bytes],
    clock: impl Fn() -> u32,
    take: impl FnMut(&[Bytes]) -> bool,
) -> Result<Took<T>, &'static str> {
    draw::<_, Golden, _, _, _, LEVELS>(world, wanted, sampler, tally, row, clock, bytes, take)
}
