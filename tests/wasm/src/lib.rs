//! The baked scenes, drawn in WebAssembly into memory that the engine reads.

use std::cell::RefCell;

use strahl_firmware::draw::{Bytes, DARK};
use strahl_firmware::packs::{SCENES, picture};

thread_local! {
    static FLOATS: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Draws a scene by its number: how many bytes of linear floats there are now, 0 when there is no
/// picture.
#[unsafe(no_mangle)]
pub extern "C" fn draw(number: usize) -> usize {
    FLOATS.with_borrow_mut(|floats| {
        floats.clear();
        let Some(baked) = SCENES.get(number) else { return 0 };
        let take = |row: &[Bytes]| {
            floats.extend_from_slice(row.as_flattened().as_flattened());
            true
        };
        match picture(baked, &mut DARK.clone(), || 0, take) {
            Ok(_) => floats.len(),
            Err(_) => 0,
        }
    })
}

/// Where they are.
#[unsafe(no_mangle)]
pub extern "C" fn floats() -> *const u8 {
    FLOATS.with_borrow(|floats| floats.as_ptr())
}
