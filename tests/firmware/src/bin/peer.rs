//! Draws the peer scene row by row, writes it as `peer.ppm` and tells what it took: camera rays
//! and quantisation included.
//!
//! Exit code 0, or 1 and a line that says why.

#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use semihosting::{fs::File, io::Write, println, process};
use strahl_core::scene::Effects;
use strahl_core::{BareList, Camera, CenterSampler, Scene, World};
use strahl_firmware::draw::{Wanted, draw};
use strahl_firmware::peer::{ITEMS, LEVELS, LIMITS, PARTS, Peer, SIZE, VIEW, quantised};
use strahl_firmware::{count, stack};

const WIDTH: usize = SIZE.width() as usize;

#[entry]
fn main() -> ! {
    static mut ROW: [[u8; 3]; WIDTH] = [[0; 3]; WIDTH];

    match picture(ROW) {
        Ok(()) => process::exit(0),
        Err(why) => {
            println!("peer: {why}");
            process::exit(1)
        }
    }
}

fn picture(row: &mut [[u8; 3]; WIDTH]) -> Result<(), &'static str> {
    // As if it came from elsewhere: no number of the scene is folded into the code.
    let scene = Scene::new(black_box(PARTS)).map_err(|_| "its parts make no scene")?;
    if scene.required_effects() != Peer::SET {
        return Err("the scene does not ask for exactly what the tracer can do");
    }
    let world = World::new(scene, BareList(ITEMS as u32));
    let camera = Camera::new(&VIEW, SIZE).map_err(|_| "the view shows nothing")?;
    let mut file = File::create(c"peer.ppm").map_err(|_| "peer.ppm cannot be created")?;
    file.write_all(b"P6\n160 120\n255\n").map_err(|_| "peer.ppm cannot be written")?;

    let wanted = Wanted { size: SIZE, camera, limits: LIMITS };
    let take = |row: &[[u8; 3]]| file.write_all(row.as_flattened()).is_ok();
    let took = draw::<_, Peer, _, _, _, LEVELS>(
        &world,
        wanted,
        &mut CenterSampler,
        (),
        row,
        count::now,
        quantised,
        take,
    )?;
    // Before anything is printed, which takes stack as well.
    let stack = stack::used();
    println!("pixels {}", SIZE.width() * SIZE.height());
    println!("instructions {}", took.instructions);
    println!("stack {stack}");
    println!("worker {}", took.worker);
    Ok(())
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("peer: {info}");
    process::exit(1)
}
