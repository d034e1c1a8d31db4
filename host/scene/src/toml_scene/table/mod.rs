//! Tables of keys.

mod keys;
mod tables;

pub use keys::KeyReader;
pub(super) use tables::tables;
pub use tables::{SingleTable, TableArray};
