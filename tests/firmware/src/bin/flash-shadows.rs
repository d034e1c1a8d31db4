//! See `strahl_firmware::flash`.

#![no_std]
#![no_main]

use strahl_firmware::flash::{Shadows, run};

#[cortex_m_rt::entry]
fn main() -> ! {
    run::<Shadows>()
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
