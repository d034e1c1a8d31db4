//! See `strahl_firmware::flash`.

#![no_std]
#![no_main]

use strahl_device::flash::FlashDistributed;
use strahl_firmware::flash::run;

#[cortex_m_rt::entry]
fn main() -> ! {
    run::<FlashDistributed>()
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
