//! Limits for scene files.

/// The maximum number of pixels that a file can request, so that a number in a file cannot exhaust memory.
pub const MAX_PIXELS_IN_FILE: u64 = 1 << 24;
