//! The proof that no panic is reachable in the core: this program links only if no path leads to a panic.
//!
//! The panic handler calls an undefined function. If the optimizer could not remove every path to it, the
//! linker reports `a_panic_is_reachable`. Only functions that are called are proven, so that every public
//! function of the core is called here, with values that are opaque to the optimizer. The program is linked
//! and never run.
//!
//! If it does not link: replace the handler by a loop, link, and search the output of `objdump -d -C` for
//! callers of `core::panicking`.
//!
//! The functions of a module of the core are called in the module of the same name: in its `entry_points`,
//! or, if they need a tracer, in functions that `trace` calls. Baked scenes are in `pack`; `any` and `text`
//! are shared.
//!
//! Functions are called by their path, `Type::function(value)`: a test (`tests/tests/layers/proof.rs`) checks
//! that none is missing, and a method call does not name the type.

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
    // SAFETY: never called, because a program that calls it does not link.
    unsafe { a_panic_is_reachable() }
}

#[entry]
fn main() -> ! {
    loop {
        math::entry_points();
        set::entry_points();
        geometry::entry_points();
        tally::entry_points();
        accel::entry_points();
        scene::entry_points();
        pack::entry_points();
        shade::entry_points();
        image::entry_points();
        trace::entry_points();
        #[cfg(feature = "canary")]
        canary();
    }
}

/// A reachable panic, which shows that the proof can fail.
#[cfg(feature = "canary")]
fn canary() {
    any::used(any::slice(&[1, 2, 3])[any::any(0)]);
}
