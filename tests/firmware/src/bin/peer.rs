//! Draws the peer scene row by row, writes it as `peer.ppm` and prints its cost, including camera rays and
//! quantization.
//!
//! The exit code is 0, or 1 after a line with the reason.

#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use semihosting::{fs::File, io::Write, println, process};
use strahl_core::scene::Effects;
use strahl_core::{Camera, CenterSampler, ListWithoutBounds, Scene, World};
use strahl_device::draw::{DrawSettings, draw};
use strahl_firmware::peer::{ITEMS, LEVELS, LIMITS, PARTS, PeerEffects, SIZE, VIEW, quantized};
use strahl_firmware::{count, stack};

const WIDTH: usize = SIZE.width() as usize;

#[entry]
fn main() -> ! {
    static mut ROW: [[u8; 3]; WIDTH] = [[0; 3]; WIDTH];

    match picture(ROW) {
        Ok(()) => process::exit(0),
        Err(reason) => {
            println!("peer: {reason}");
            process::exit(1)
        }
    }
}

fn picture(row: &mut [[u8; 3]; WIDTH]) -> Result<(), &'static str> {
    // Opaque to the optimizer: no constant of the scene is folded into the code.
    let scene = Scene::new(black_box(PARTS)).map_err(|_| "invalid scene")?;
    if scene.required_effects() != PeerEffects::SET {
        return Err("the scene does not require exactly the effects of the tracer");
    }
    let world = World::new(scene, ListWithoutBounds(ITEMS as u32));
    let camera = Camera::new(&VIEW, SIZE).map_err(|_| "invalid camera")?;
    let mut file = File::create(c"peer.ppm").map_err(|_| "peer.ppm cannot be created")?;
    file.write_all(b"P6\n160 120\n255\n").map_err(|_| "peer.ppm cannot be written")?;

    let settings = DrawSettings { size: SIZE, camera, limits: LIMITS };
    let take = |row: &[[u8; 3]]| file.write_all(row.as_flattened()).is_ok();
    let cost = draw::<_, PeerEffects, _, _, _, LEVELS>(
        &world,
        settings,
        &mut CenterSampler,
        (),
        row,
        count::now,
        quantized,
        take,
    )?;
    // Before printing, which uses stack as well.
    let stack = stack::used();
    println!("pixels {}", SIZE.width() * SIZE.height());
    println!("instructions {}", cost.instructions);
    println!("stack {stack}");
    println!("worker {}", cost.worker);
    Ok(())
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("peer: {info}");
    process::exit(1)
}
