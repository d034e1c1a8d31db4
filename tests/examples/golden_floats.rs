//! Writes the linear colours of the golden scene into the file named by the first argument, as
//! the firmware `golden` does (`tests/firmware/check` compares both).
//!
//! The host goes the other way wherever there is one: a tracer that can do everything, a list
//! without boxes, a frame in memory. None of that may change a bit.

#[path = "../firmware/src/scene.rs"]
mod scene;

use std::error::Error;

use scene::{Golden, ITEMS, LEVELS, LIMITS, SIZE, VIEW, parts};
use strahl_core::{
    Camera, Effects, Everything, Frame, List, Rgb, Scene, Single, Tile, Tracer, Worker, World, render,
};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).ok_or("usage: golden_floats FILE")?;
    let scene = Scene::new(parts())?;
    assert_eq!(scene.effects(), Golden::SET);
    let world = World::new(scene, List::bare(ITEMS as u32));
    let tracer = Tracer::<_, Everything, LEVELS>::new(&world, Camera::new(&VIEW, SIZE)?, LIMITS)?;

    let tile = Tile::whole(SIZE);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Frame::new(tile, &mut colors).ok_or("the frame has another size")?;
    let Ok(()) = render(&tracer, &mut Single, &mut Worker::new(()), tile.pixels(), &mut frame);

    let bytes: Vec<u8> = colors.iter().flat_map(|c| [c.r, c.g, c.b]).flat_map(f32::to_le_bytes).collect();
    Ok(std::fs::write(path, bytes)?)
}
