//! The proof that nothing in the core can panic: it links only without a way to a panic.
//!
//! The panic handler calls a function that nobody defines. Where the optimiser could not remove
//! every path to it, the linker asks for `a_panic_is_reachable`. What is not called is not
//! proven, so every public function of the core is called here, with numbers of which the optimiser
//! knows nothing. To be linked, never to be run.
//!
//! When it does not link: let the handler loop, link, and look in `objdump -d -C` for who calls
//! `core::panicking`.
//!
//! The functions of a module of the core are called in the module of the same name here: in its `doors`, or, where
//! they need a tracer, in what `trace` calls. Baked scenes have a module of their own, `pack`; what all modules need
//! is in `any` and `text`.
//!
//! Functions are called by their path, `Type::function(value)`: a test (`tests/tests/layers/proof.rs`) checks that none
//! is missing, and a method call does not say whose method it is.

#![no_std]
#![no_main]

mod accel;
mod any;
mod geometry;
mod image;
mod math;
mod pack;
mod render;
mod scene;
mod set;
mod shade;
mod tally;
mod text;
mod trace;

use cortex_m_rt::entry;

unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: it is never called, for it does not exist.
    unsafe { a_panic_is_reachable() }
}

#[entry]
fn main() -> ! {
    loop {
        math::doors();
        set::doors();
        geometry::doors();
        tally::doors();
        accel::doors();
        scene::doors();
        pack::doors();
        shade::doors();
        image::doors();
        trace::doors();
        #[cfg(feature = "canary")]
        canary();
    }
}

/// The panic that shows that the proof can fail.
#[cfg(feature = "canary")]
fn canary() {
    any::used(any::slice(&[1, 2, 3])[any::any(0)]);
}
