//! `golden` in double precision, which the chip computes in software. Writes its pictures, rounded to `f32`,
//! to `golden-double.f32`.

#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::{println, process};
use strahl_device_double::accuracy::{ProvidedBuffers, all};
use strahl_firmware::count;
use strahl_firmware::write::{CostReport, PictureFile};

#[entry]
fn main() -> ! {
    static mut BUFFERS: ProvidedBuffers = ProvidedBuffers::NEW;

    match write_all(BUFFERS) {
        Ok(()) => process::exit(0),
        Err(reason) => {
            println!("double: {reason}");
            process::exit(1)
        }
    }
}

/// Writes all pictures to one file, and prints their cost.
fn write_all(buffers: &mut ProvidedBuffers) -> Result<(), &'static str> {
    let (mut file, mut report) = (PictureFile::create(c"golden-double.f32")?, CostReport::default());
    all(
        buffers,
        count::now,
        |row| file.write(row),
        |run, cost| report.print(run, cost.instructions, cost.worker),
        |rays| println!("{rays}"),
    )
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("double: {info}");
    process::exit(1)
}
