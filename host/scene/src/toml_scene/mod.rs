//! Scenes in TOML: one array of tables for each kind of object, light and material.
//!
//! | module | contents |
//! |---|---|
//! | `read` | reading of a file |
//! | `build` | conversion of the tables to a loaded scene |
//! | `format` | the tables and their keys, with the texts that editors show |
//! | `table` | reading of tables |
//! | `value` | reading of values |
//! | `syntax` | TOML syntax errors |
//!
//! A file is read in two steps: `format` checks every key separately, then `build` checks combinations of keys. All
//! errors of both steps are reported together.

mod build;
mod format;
mod read;
mod syntax;
mod table;
mod value;

pub(crate) use read::read;
pub use read::schema;
