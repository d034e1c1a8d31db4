//! The options of `cast`.

use std::path::PathBuf;

use clap::Parser;

use super::settings::{OfRays, SettingArgs};

/// Options of `cast`.
#[derive(Debug, Parser)]
pub struct CastArgs {
    /// Scene (.toml, .nff) or model (.obj, .ply, .gltf, .glb).
    pub scene: PathBuf,

    /// Rays (CSV); `-` is standard input.
    #[arg(long, value_name = "FILE", default_value = "-")]
    pub rays: PathBuf,

    /// Hits (CSV); `-` is standard output.
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,

    /// Precision, accelerator and threads.
    #[command(flatten)]
    pub settings: SettingArgs<OfRays>,

    /// Print errors only.
    #[arg(short, long)]
    pub quiet: bool,
}
