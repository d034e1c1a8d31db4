//! Draws the baked scenes and writes each as linear floats, `NAME.f32`; on a Cortex-M4F it tells
//! what they took.
//!
//! Exit code 0, or 1 and a line that says why.

#![no_std]
#![no_main]

use semihosting::{fs::File, io::Write, println, process};
#[cfg(target_arch = "arm")]
use strahl_firmware::{count, packs::STACK};
use strahl_firmware::{
    draw::{Bytes, DARK, Row},
    packs::{BakedFixture, SCENES, Written, picture},
};

#[cfg(target_arch = "arm")]
#[cortex_m_rt::entry]
fn main() -> ! {
    static mut ROW: Row = DARK;
    all(ROW)
}

#[cfg(target_arch = "riscv32")]
#[riscv_rt::entry]
fn main() -> ! {
    all(&mut DARK.clone())
}

fn all(row: &mut Row) -> ! {
    for baked in &SCENES {
        if let Err(why) = one(baked, row) {
            println!("packs: {:?}: {why}", baked.name);
            process::exit(1);
        }
    }
    #[cfg(target_arch = "arm")]
    println!("stack {}", STACK.load(core::sync::atomic::Ordering::Relaxed));
    process::exit(0)
}

fn one(baked: &BakedFixture, row: &mut Row) -> Result<(), &'static str> {
    let mut file = File::create(baked.name).map_err(|_| "its picture cannot be created")?;
    let take = |row: &[Bytes]| file.write_all(row.as_flattened().as_flattened()).is_ok();
    let name = baked.name.to_str().unwrap_or_default();
    #[cfg(target_arch = "arm")]
    let clock = count::now;
    #[cfg(not(target_arch = "arm"))]
    let clock = || 0;
    let took = picture(baked, row, clock, take)?;
    let bytes = match baked.written {
        Written::Bytes(bytes) => bytes.len(),
        Written::Constants => 0,
    };
    println!("{name} {} {} {bytes}", took.instructions, took.worker);
    Ok(())
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("packs: {info}");
    process::exit(1)
}
