//! Reading of tables.

mod keys;
mod tables;

pub use keys::{Entry, KeyReader, Keys, add_aliases};
pub(super) use tables::tables;
pub use tables::{SingleTable, TableArray};
