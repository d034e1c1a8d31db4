//! The options of the commands that tell of the program itself: `man` and `schema`.

use clap::{Parser, ValueEnum};

/// Which page.
#[derive(Debug, Parser)]
pub struct ManArgs {
    /// Of this command, with its options [default: of the program].
    pub command: Option<String>,
}

/// Of what there is a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Schema {
    /// Scenes in TOML.
    Scene,
    /// What a study has found: study.json.
    Study,
}
