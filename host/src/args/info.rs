//! The options of `info`.

use std::path::PathBuf;

use clap::Parser;

/// What to tell about.
#[derive(Debug, Parser)]
pub struct InfoArgs {
    /// The scene.
    pub scene: PathBuf,

    /// For programs.
    #[arg(long)]
    pub json: bool,
}
