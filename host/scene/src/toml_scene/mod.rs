//! Scenes in TOML: one array of tables for each kind of thing, materials by name.
//!
//! | module | what it does |
//! |---|---|
//! | `read` | a file in TOML becomes a description |
//! | `build` | what has been read becomes a description |
//! | `format` | the tables and their keys, as users and editors see them |
//! | `table` | tables of keys become values of types |
//! | `value` | what keys can hold |
//! | `syntax` | what is wrong with a text that is no TOML |
//!
//! A file is read in two steps, and whatever is wrong in either of them is told at once: first
//! every key by itself, then what only several keys together can get wrong.

mod build;
mod format;
mod read;
mod syntax;
mod table;
mod value;

pub(crate) use read::read;
pub use read::schema;
