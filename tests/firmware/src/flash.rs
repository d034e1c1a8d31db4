//! The smallest firmware that draws a picture and transmits it: the floats of
//! [`strahl_device::flash::picture`] are sent through the serial port as they are computed.

use strahl_device::flash::{FlashVariant, picture};

use crate::stack;

/// The data register of the serial port USART1 of an STM32F405, whose clock and pins a product
/// would set up first; QEMU's needs none.
const SERIAL: *mut u32 = 0x4001_1004 as *mut u32;

/// The whole firmware of a variant.
pub fn run<S: FlashVariant>() -> ! {
    let draw_result = picture::<S>(|bytes| {
        for byte in bytes {
            // SAFETY: a 32-bit peripheral register of this machine.
            unsafe { SERIAL.write_volatile(u32::from(byte)) };
        }
    });
    for byte in stack::used().to_le_bytes() {
        // SAFETY: as above.
        unsafe { SERIAL.write_volatile(u32::from(byte)) };
    }
    semihosting::process::exit(i32::from(draw_result.is_none()))
}
