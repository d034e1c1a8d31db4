//! Traces the golden scene row by row, without a frame buffer, and writes its linear colors to `golden.f32`
//! (red, green, blue as little-endian `f32`, row by row), followed by those of the scene with other levels,
//! cutoffs and samplers. Prints the cost of each.
//!
//! The exit code is 0, or 1 after a line with the reason.

#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::{println, process};
use strahl_core::accel::List;
use strahl_core::scene::Effects;
use strahl_core::{Scene, World};
use strahl_device::accuracy::ProvidedBuffers;
use strahl_device::scene::{GoldenEffects, parts};
use strahl_firmware::write::write_all;

#[entry]
fn main() -> ! {
    static mut BUFFERS: ProvidedBuffers = ProvidedBuffers::NEW;

    if Scene::new(parts()).is_ok_and(|scene| scene.required_effects() != GoldenEffects::SET) {
        println!("golden: the scene does not require exactly the effects of the tracer");
        process::exit(1);
    }
    println!("world {}", size_of::<World<'_, List<'_>>>());
    match write_all(BUFFERS) {
        Ok(()) => process::exit(0),
        Err(reason) => {
            println!("golden: {reason}");
            process::exit(1)
        }
    }
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("golden: {info}");
    process::exit(1)
}
