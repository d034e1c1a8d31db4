//! Draws a world row by row, without a frame buffer: all of the picture that there ever is in
//! memory are the bytes of one row.

use strahl_core::{
    Accelerator, Camera, Effects, Limits, Pixel, Rgb, Single, Size, Tile, Tracer, Worker, World, render,
};

/// The linear colour of a pixel as little-endian bytes.
pub type Bytes = [[u8; size_of::<f32>()]; 3];

/// The widest picture that there is memory for.
pub const WIDEST: usize = 128;

/// The bytes of one row.
pub type Row = [Bytes; WIDEST];

/// A row without anything in it.
pub const DARK: Row = [[[0; size_of::<f32>()]; 3]; WIDEST];

/// Which picture.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// How large.
    pub size: Size,
    /// From where.
    pub camera: Camera,
    /// How deep.
    pub limits: Limits,
}

/// Draws all rows. `measure` has the work of one row done; `take` is given its bytes and says
/// whether it could take them.
///
/// Answers the size of the worker, or why there is no picture.
pub fn draw<A: Accelerator, E: Effects, const LEVELS: usize>(
    world: &World<'_, A>,
    wanted: Wanted,
    row: &mut Row,
    mut measure: impl FnMut(&mut dyn FnMut()),
    mut take: impl FnMut(&[u8]) -> bool,
) -> Result<usize, &'static str> {
    let Wanted { size, camera, limits } = wanted;
    let tracer = Tracer::<A, E, LEVELS>::new(world, camera, limits).map_err(|_| "no tracer")?;
    let mut worker = Worker::new(());
    let row = row.get_mut(..size.width() as usize).ok_or("a row is too wide")?;
    for y in 0..size.height() {
        let pixels = Tile { first: Pixel { x: 0, y }, width: size.width(), height: 1 };
        measure(&mut || {
            let mut slots = row.iter_mut();
            let mut sink = |_: Pixel, color: Rgb| {
                if let Some(slot) = slots.next() {
                    *slot = [color.r, color.g, color.b].map(f32::to_le_bytes);
                }
            };
            let Ok(()) = render(&tracer, &mut Single, &mut worker, pixels.pixels(), &mut sink);
        });
        if !take(row.as_flattened().as_flattened()) {
            return Err("a row cannot be written");
        }
    }
    Ok(Worker::<A, (), LEVELS>::BYTES)
}
