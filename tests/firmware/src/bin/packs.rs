//! Draws the baked scenes and writes each as linear floats, `NAME.f32`; on a Cortex-M4F it tells
//! what they took.
//!
//! Exit code 0, or 1 and a line that says why.

#![no_std]
#![no_main]

use semihosting::{fs::File, io::Write, println, process};
#[cfg(target_arch = "arm")]
use strahl_firmware::{count, stack};
use strahl_firmware::{
    draw::{DARK, Row},
    packs::{Baked, SCENES, picture},
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
    println!("stack {}", stack::used());
    process::exit(0)
}

fn one(baked: &Baked, row: &mut Row) -> Result<(), &'static str> {
    let mut file = File::create(baked.name).map_err(|_| "its picture cannot be created")?;
    let take = |bytes: &[u8]| file.write_all(bytes).is_ok();
    let name = baked.name.to_str().unwrap_or_default();
    #[cfg(target_arch = "arm")]
    {
        let nothing = count::of(|| ()).1;
        let mut instructions = 0_u64;
        let measure = |work: &mut dyn FnMut()| instructions += u64::from(count::of(work).1 - nothing);
        let worker = picture(baked, row, measure, take)?;
        println!("{name} {instructions} {worker} {}", baked.bytes.len());
    }
    #[cfg(not(target_arch = "arm"))]
    {
        let worker = picture(baked, row, |work| work(), take)?;
        println!("{name} 0 {worker} {}", baked.bytes.len());
    }
    Ok(())
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("packs: {info}");
    process::exit(1)
}
