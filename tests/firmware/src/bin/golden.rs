//! Traces the golden scene row by row, without a frame buffer, writes its linear colours into
//! `golden.f32` (red, green, blue as little-endian `f32`, row by row) and tells what it took.
//!
//! Exit code 0, or 1 and a line that says why.

#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::{fs::File, io::Write, println, process};
use strahl_core::{
    Aabb, Camera, Effects, List, Pixel, Rgb, Scene, Single, Tile, Tracer, Worker, World, groups_of, render,
};
use strahl_firmware::scene::{Golden, ITEMS, LEVELS, LIMITS, SIZE, VIEW, parts};
use strahl_firmware::{count, stack};

/// Boxes round the items and round groups of them: static RAM that is lent to the list.
struct Boxes {
    items: [Aabb; ITEMS],
    groups: [Aabb; groups_of(ITEMS)],
}

const CHANNELS: usize = 3;
const WIDTH: usize = SIZE.width() as usize;

/// The bytes of one row: all of the picture that there ever is in memory.
type Row = [[[u8; size_of::<f32>()]; CHANNELS]; WIDTH];

#[entry]
fn main() -> ! {
    static mut BOXES: Boxes = Boxes { items: [Aabb::EMPTY; ITEMS], groups: [Aabb::EMPTY; groups_of(ITEMS)] };
    static mut ROW: Row = [[[0; size_of::<f32>()]; CHANNELS]; WIDTH];

    match picture(BOXES, ROW) {
        Ok(()) => process::exit(0),
        Err(why) => {
            println!("golden: {why}");
            process::exit(1)
        }
    }
}

fn picture(boxes: &'static mut Boxes, row: &mut Row) -> Result<(), &'static str> {
    let scene = Scene::new(parts()).map_err(|_| "its parts make no scene")?;
    if scene.effects() != Golden::SET {
        return Err("the scene does not ask for exactly what the tracer can do");
    }
    for (place, item) in boxes.items.iter_mut().zip(parts().geometry.all_bounds()) {
        *place = item;
    }
    let list = List::boxed(&boxes.items, &mut boxes.groups).map_err(|_| "too few boxes")?;
    let world = World::new(scene, list);
    let camera = Camera::new(&VIEW, SIZE).map_err(|_| "the view shows nothing")?;
    let tracer = Tracer::<_, Golden, LEVELS>::new(&world, camera, LIMITS).map_err(|_| "no tracer")?;
    let mut worker = Worker::new(());
    let mut file = File::create(c"golden.f32").map_err(|_| "golden.f32 cannot be created")?;

    let nothing = count::of(|| ()).1;
    let mut instructions = 0;
    for y in 0..SIZE.height() {
        let pixels = Tile { first: Pixel { x: 0, y }, width: SIZE.width(), height: 1 };
        let mut slots = row.iter_mut();
        let mut sink = |_: Pixel, color: Rgb| {
            if let Some(slot) = slots.next() {
                *slot = [color.r, color.g, color.b].map(f32::to_le_bytes);
            }
        };
        let (Ok(()), taken) =
            count::of(|| render(&tracer, &mut Single, &mut worker, pixels.pixels(), &mut sink));
        instructions += u64::from(taken - nothing);
        file.write_all(row.as_flattened().as_flattened()).map_err(|_| "golden.f32 cannot be written")?;
    }

    // Before anything is printed, which takes stack as well.
    let stack = stack::used();
    println!("pixels {}", SIZE.width() * SIZE.height());
    println!("instructions {instructions}");
    println!("stack {stack}");
    println!("worker {}", size_of_val(&worker));
    println!("tracer {}", size_of_val(&tracer));
    println!("world {}", size_of_val(&world));
    Ok(())
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("golden: {info}");
    process::exit(1)
}
