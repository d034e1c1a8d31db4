//! Draws the baked scenes in WebAssembly, into memory that the engine reads.

use std::cell::RefCell;

use strahl_device::draw::{BLACK_ROW, PixelBytes};
use strahl_firmware::packs::{SCENES, picture};

thread_local! {
    static FLOATS: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Draws the scene with this index. Returns the size of its linear floats in bytes, 0 on failure.
#[unsafe(no_mangle)]
pub extern "C" fn draw(number: usize) -> usize {
    FLOATS.with_borrow_mut(|floats| {
        floats.clear();
        let Some(baked) = SCENES.get(number) else { return 0 };
        let take = |row: &[PixelBytes]| {
            floats.extend_from_slice(row.as_flattened().as_flattened());
            true
        };
        match picture(baked, &mut BLACK_ROW.clone(), || 0, take) {
            Ok(_) => floats.len(),
            Err(_) => 0,
        }
    })
}

/// Address of the floats.
#[unsafe(no_mangle)]
pub extern "C" fn floats() -> *const u8 {
    FLOATS.with_borrow(|floats| floats.as_ptr())
}
