//! Draws a world row by row, without a frame buffer: only one row of the picture is in memory.

#![allow(clippy::too_many_arguments)] // of different types

use strahl_core::accel::Accelerator;
use strahl_core::image::{Pixel, Sampler, Sink};
use strahl_core::scene::Effects;
use strahl_core::tally::Tally;
use strahl_core::{Camera, Limits, Real, Resolution, Rgb, Tile, Tracer, Worker, World, render};

/// Linear color of a pixel, as little-endian `f32`.
pub type PixelBytes = [[u8; size_of::<f32>()]; 3];

/// Converts a color to its bytes in files.
pub fn bytes(color: Rgb) -> PixelBytes {
    #[allow(clippy::unnecessary_cast)] // necessary in double precision
    let single = |channel: Real| channel as f32;
    [color.r, color.g, color.b].map(|channel| single(channel).to_le_bytes())
}

/// Maximum width of a picture, in pixels.
pub const MAX_WIDTH: usize = 128;

/// One row.
pub type PixelRow = [PixelBytes; MAX_WIDTH];

/// A black row.
pub const BLACK_ROW: PixelRow = [[[0; size_of::<f32>()]; 3]; MAX_WIDTH];

/// Settings of a picture.
#[derive(Clone, Copy, Debug)]
pub struct DrawSettings {
    /// Resolution.
    pub size: Resolution,
    /// Camera.
    pub camera: Camera,
    /// Levels and cutoff.
    pub limits: Limits,
}

/// Cost of a picture.
#[derive(Clone, Copy, Debug)]
pub struct DrawCost<T> {
    /// Number of instructions, from the clock.
    pub instructions: u64,
    /// Size of the worker without a tally, in bytes.
    pub worker: usize,
    /// Tally of the trace.
    pub tally: T,
}

/// Draws all rows. `clock` returns an increasing count of instructions, `pixel` converts a color, and `take`
/// receives each row and returns whether it succeeded.
///
/// Returns the cost, or the reason of a failure.
pub fn draw<A: Accelerator, E: Effects, S: Sampler, P, T: Tally, const LEVELS: usize>(
    world: &World<'_, A>,
    settings: DrawSettings,
    sampler: &mut S,
    tally: T,
    row: &mut [P],
    clock: impl Fn() -> u32,
    pixel: impl Fn(Rgb) -> P,
    take: impl FnMut(&[P]) -> bool,
) -> Result<DrawCost<T>, &'static str> {
    let DrawSettings { size, camera, limits } = settings;
    let tracer = Tracer::<A, E, LEVELS>::new(world, camera, limits).map_err(|_| "no tracer")?;
    if row.len() != size.width() as usize {
        return Err("the row buffer has another width");
    }
    let mut worker = Worker::new(tally);
    let start = clock();
    let mut rows = RowSink { row, filled: 0, pixel, take, clock, start, instructions: 0 };
    render(&mut tracer.with_worker(&mut worker), sampler, Tile::full(size).pixels(), &mut rows)?;
    let instructions = rows.instructions;
    Ok(DrawCost { instructions, worker: Worker::<A, (), LEVELS>::SIZE_IN_BYTES, tally: worker.into_tally() })
}

/// Collects pixels into rows, and counts instructions between the rows.
struct RowSink<'r, P, F, T, C> {
    row: &'r mut [P],
    filled: usize,
    pixel: F,
    take: T,
    clock: C,
    start: u32,
    instructions: u64,
}

impl<P, F: Fn(Rgb) -> P, T: FnMut(&[P]) -> bool, C: Fn() -> u32> Sink for RowSink<'_, P, F, T, C> {
    type Error = &'static str;

    fn put(&mut self, _: Pixel, color: Rgb) -> Result<(), &'static str> {
        if let Some(slot) = self.row.get_mut(self.filled) {
            *slot = (self.pixel)(color);
        }
        self.filled += 1;
        if self.filled < self.row.len() {
            return Ok(());
        }
        // A row takes fewer than 2^32 instructions.
        self.instructions += u64::from((self.clock)().wrapping_sub(self.start));
        let is_written = (self.take)(self.row);
        (self.filled, self.start) = (0, (self.clock)());
        if is_written { Ok(()) } else { Err("a row cannot be written") }
    }
}
