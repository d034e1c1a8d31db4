//! The options of `cast`.

use std::path::PathBuf;

use clap::Parser;

use super::settings::{OfRays, SettingArgs};

/// What to cast, and how.
#[derive(Debug, Parser)]
pub struct CastArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    pub scene: PathBuf,

    /// The rays; `-` is the standard input.
    #[arg(long, value_name = "FILE", default_value = "-")]
    pub rays: PathBuf,

    /// Where the hits go; `-` is the standard output.
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,

    /// What rays are computed with, which they are read and hits are written in too, and how items are found.
    #[command(flatten)]
    pub settings: SettingArgs<OfRays>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}
