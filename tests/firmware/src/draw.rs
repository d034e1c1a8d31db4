//! Draws a world row by row, without a frame buffer: all of the picture that there ever is in
//! memory is one row.

// Who includes this file may use a part of it.
#![allow(dead_code)]
#![allow(clippy::too_many_arguments)] // each is one of a kind

use strahl_core::accel::Accelerator;
use strahl_core::image::{Pixel, Sampler, Sink};
use strahl_core::scene::Effects;
use strahl_core::tally::Tally;
use strahl_core::{Camera, Limits, Real, Resolution, Rgb, Tile, Tracer, Worker, World, render};

/// The linear colour of a pixel as little-endian single precision.
pub type Bytes = [[u8; size_of::<f32>()]; 3];

/// A colour as it goes into files.
pub fn bytes(color: Rgb) -> Bytes {
    #[allow(clippy::unnecessary_cast)] // it is none in double precision
    let single = |channel: Real| channel as f32;
    [color.r, color.g, color.b].map(|channel| single(channel).to_le_bytes())
}

/// The widest picture that there is memory for.
pub const WIDEST: usize = 128;

/// One row.
pub type Row = [Bytes; WIDEST];

/// A row without anything in it.
pub const DARK: Row = [[[0; size_of::<f32>()]; 3]; WIDEST];

/// Which picture.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// How large.
    pub size: Resolution,
    /// From where.
    pub camera: Camera,
    /// How deep.
    pub limits: Limits,
}

/// What it took.
#[derive(Clone, Copy, Debug)]
pub struct Took<T> {
    /// Instructions, as a clock counted them.
    pub instructions: u64,
    /// Bytes of the worker, which tells nobody.
    pub worker: usize,
    /// Who has been told what happened.
    pub tally: T,
}

/// Draws all rows with one ray or more in each pixel. `clock` counts instructions up, `pixel` says
/// how a colour is kept, and `take` is given each row and says whether it could take it.
///
/// Answers what it took, or why there is no picture.
pub fn draw<A: Accelerator, E: Effects, S: Sampler, P, T: Tally, const LEVELS: usize>(
    world: &World<'_, A>,
    wanted: Wanted,
    sampler: &mut S,
    tally: T,
    row: &mut [P],
    clock: impl Fn() -> u32,
    pixel: impl Fn(Rgb) -> P,
    take: impl FnMut(&[P]) -> bool,
) -> Result<Took<T>, &'static str> {
    let Wanted { size, camera, limits } = wanted;
    let tracer = Tracer::<A, E, LEVELS>::new(world, camera, limits).map_err(|_| "no tracer")?;
    if row.len() != size.width() as usize {
        return Err("a row has another width");
    }
    let mut worker = Worker::new(tally);
    let start = clock();
    let mut rows = Rows { row, filled: 0, pixel, take, clock, start, instructions: 0 };
    render(&mut tracer.with_worker(&mut worker), sampler, Tile::full(size).pixels(), &mut rows)?;
    let instructions = rows.instructions;
    Ok(Took { instructions, worker: Worker::<A, (), LEVELS>::SIZE_IN_BYTES, tally: worker.into_tally() })
}

/// Gathers pixels into rows, and counts what is between one row and the next.
struct Rows<'r, P, F, T, C> {
    row: &'r mut [P],
    filled: usize,
    pixel: F,
    take: T,
    clock: C,
    start: u32,
    instructions: u64,
}

impl<P, F: Fn(Rgb) -> P, T: FnMut(&[P]) -> bool, C: Fn() -> u32> Sink for Rows<'_, P, F, T, C> {
    type Error = &'static str;

    fn put(&mut self, _: Pixel, color: Rgb) -> Result<(), &'static str> {
        if let Some(slot) = self.row.get_mut(self.filled) {
            *slot = (self.pixel)(color);
        }
        self.filled += 1;
        if self.filled < self.row.len() {
            return Ok(());
        }
        // A row takes less than 2^32.
        self.instructions += u64::from((self.clock)().wrapping_sub(self.start));
        let taken = (self.take)(self.row);
        (self.filled, self.start) = (0, (self.clock)());
        if taken { Ok(()) } else { Err("a row cannot be written") }
    }
}
