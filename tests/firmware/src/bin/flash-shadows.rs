//! See `strahl_firmware::flash`.

#![no_std]
#![no_main]

use strahl_device::flash::FlashShadows;
use strahl_firmware::flash::run;

#[cortex_m_rt::entry]
fn main() -> ! {
    run::<FlashShadows>()
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
