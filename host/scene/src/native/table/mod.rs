//! Tables of keys.

mod keys;
mod tables;

pub use keys::Keys;
pub(super) use tables::tables;
pub use tables::{Many, One};
