//! What a file may ask for.

/// The most pixels that a file may ask for: a number in a file must not fill the memory.
pub const MAX_PIXELS_IN_FILE: u64 = 1 << 24;
