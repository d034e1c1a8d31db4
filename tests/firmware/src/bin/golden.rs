//! Traces the golden scene row by row, without a frame buffer, and writes its linear colours into
//! `golden.f32` (red, green, blue as little-endian `f32`, row by row), and after them those of the
//! same scene with other levels, cutoffs and samplers. It tells what each took.
//!
//! Exit code 0, or 1 and a line that says why.

#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::{println, process};
use strahl_core::accel::List;
use strahl_core::scene::Effects;
use strahl_core::{Scene, World};
use strahl_firmware::accuracy::Lent;
use strahl_firmware::scene::{Golden, parts};
use strahl_firmware::write::write_all;

#[entry]
fn main() -> ! {
    static mut LENT: Lent = Lent::NEW;

    if Scene::new(parts()).is_ok_and(|scene| scene.required_effects() != Golden::SET) {
        println!("golden: the scene does not ask for exactly what the tracer can do");
        process::exit(1);
    }
    println!("world {}", size_of::<World<'_, List<'_>>>());
    match write_all(c"golden.f32", LENT) {
        Ok(()) => process::exit(0),
        Err(why) => {
            println!("golden: {why}");
            process::exit(1)
        }
    }
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("golden: {info}");
    process::exit(1)
}
