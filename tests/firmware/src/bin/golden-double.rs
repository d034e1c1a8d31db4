//! The same as `golden`, in double precision: the core's twin, on a chip that has to compute it in
//! software. Its pictures go into `golden-double.f32`, rounded.

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
    static mut LENT: accuracy::Lent = accuracy::Lent::NEW;

    match write::write_all(c"golden-double.f32", LENT) {
        Ok(()) => process::exit(0),
        Err(why) => {
            println!("double: {why}");
            process::exit(1)
        }
    }
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("double: {info}");
    process::exit(1)
}
