//! `golden` in double precision, which the chip computes in software. Writes its pictures, rounded to `f32`,
//! to `golden-double.f32`.

#![no_std]
#![no_main]

extern crate strahl_core_double as strahl_core;

#[path = "../accuracy.rs"]
mod accuracy;
#[path = "../draw.rs"]
mod draw;
#[path = "../scene.rs"]
mod scene;
#[path = "../write.rs"]
mod write;

use cortex_m_rt::entry;
use semihosting::{println, process};
use strahl_firmware::{count, stack};

#[entry]
fn main() -> ! {
    static mut BUFFERS: accuracy::ProvidedBuffers = accuracy::ProvidedBuffers::NEW;

    match write::write_all(c"golden-double.f32", BUFFERS) {
        Ok(()) => process::exit(0),
        Err(reason) => {
            println!("double: {reason}");
            process::exit(1)
        }
    }
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("double: {info}");
    process::exit(1)
}
