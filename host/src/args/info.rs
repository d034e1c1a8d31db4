//! The options of `info`.

use std::path::PathBuf;

use clap::Parser;

/// Options of `info`.
#[derive(Debug, Parser)]
pub struct InfoArgs {
    /// Scene (.toml, .nff) or model (.obj, .ply, .gltf, .glb).
    pub scene: PathBuf,

    /// Print JSON.
    #[arg(long)]
    pub json: bool,
}
