//! Draws the baked scenes and writes each as linear floats, `NAME.f32`. Prints their cost on a Cortex-M4F.
//!
//! The exit code is 0, or 1 after a line with the reason.

#![no_std]
#![no_main]

use semihosting::{fs::File, io::Write, println, process};
use strahl_device::draw::{BLACK_ROW, PixelBytes, PixelRow};
use strahl_firmware::packs::{FirmwareScene, SCENES, SceneSource, picture};
#[cfg(target_arch = "arm")]
use strahl_firmware::{count, packs::STACK};

#[cfg(target_arch = "arm")]
#[cortex_m_rt::entry]
fn main() -> ! {
    static mut ROW: PixelRow = BLACK_ROW;
    draw_all(ROW)
}

#[cfg(target_arch = "riscv32")]
#[riscv_rt::entry]
fn main() -> ! {
    draw_all(&mut BLACK_ROW.clone())
}

fn draw_all(row: &mut PixelRow) -> ! {
    for baked in &SCENES {
        if let Err(reason) = draw_one(baked, row) {
            println!("packs: {:?}: {reason}", baked.name);
            process::exit(1);
        }
    }
    #[cfg(target_arch = "arm")]
    println!("stack {}", STACK.load(core::sync::atomic::Ordering::Relaxed));
    process::exit(0)
}

fn draw_one(baked: &FirmwareScene, row: &mut PixelRow) -> Result<(), &'static str> {
    let mut file = File::create(baked.name).map_err(|_| "its picture cannot be created")?;
    let take = |row: &[PixelBytes]| file.write_all(row.as_flattened().as_flattened()).is_ok();
    let name = baked.name.to_str().unwrap_or_default();
    #[cfg(target_arch = "arm")]
    let clock = count::now;
    #[cfg(not(target_arch = "arm"))]
    let clock = || 0;
    let cost = picture(baked, row, clock, take)?;
    let bytes = match baked.source {
        SceneSource::Bytes(bytes) => bytes.len(),
        SceneSource::Constants => 0,
    };
    println!("{name} {} {} {bytes}", cost.instructions, cost.worker);
    Ok(())
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("packs: {info}");
    process::exit(1)
}
