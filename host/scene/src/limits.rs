//! What a file may ask for.

/// The most pixels that a file may ask for: a number in a file must not fill the memory.
pub const MOST_PIXELS: u64 = 1 << 24;
