//! See `strahl_firmware::flash`.

#![no_std]
#![no_main]

use strahl_firmware::flash::{FlashMirrors, run};

#[cortex_m_rt::entry]
fn main() -> ! {
    run::<FlashMirrors>()
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
