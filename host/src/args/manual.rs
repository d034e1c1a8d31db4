//! The options of `man` and `schema`.

use clap::{Parser, ValueEnum};

/// Options of `man`.
#[derive(Debug, Parser)]
pub struct ManArgs {
    /// Command [default: the program itself].
    pub command: Option<String>,
}

/// File format with a JSON Schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Schema {
    /// Scenes in TOML.
    Scene,
    /// Study results: study.json.
    Study,
}
