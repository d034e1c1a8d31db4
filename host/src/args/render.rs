//! The options of `render` and `watch`.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};

use super::settings::{EverySetting, SettingArgs};

/// Examples in the help of `render`.
pub(super) const EXAMPLES: &str = "\
Examples:
  strahl render glass.toml                           writes glass.png
  strahl render glass.toml --size 1280x960 --sampler regular:3 -o large.exr
  strahl render glass.toml --cost cost.png           cost of each pixel as a heat map
  strahl render glass.toml --target-error 0.01       the cheapest settings within this error
  strahl render glass.toml --target-error 0.01 --verify
  strahl render glass.toml --time-limit 2s           the best picture in two seconds";

/// Options of `render` and `watch`.
#[derive(Debug, Parser)]
pub struct RenderArgs {
    /// Scene (.toml, .nff) or model (.obj, .ply, .gltf, .glb).
    pub scene: PathBuf,

    /// Output picture; the extension selects the format (.png .ppm .qoi .jpg .tif .exr); `-` writes PNG to
    /// standard output [default: the scene's name with .png, in the current folder].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Render only the pixels that are white in this picture, which must have the same resolution; the
    /// others are black.
    #[arg(long, value_name = "IMAGE")]
    pub mask: Option<PathBuf>,

    /// Settings of the picture and of the computation.
    #[command(flatten)]
    pub settings: SettingArgs<EverySetting>,

    /// Write statistics to standard output or to --stats-file.
    #[arg(long, value_name = "FORM")]
    pub stats: Option<StatsFormat>,

    /// File for the statistics; implies --stats json unless --stats is given.
    #[arg(long, value_name = "FILE")]
    pub stats_file: Option<PathBuf>,

    /// Print errors only.
    #[arg(short, long)]
    pub quiet: bool,
}

/// Format of the statistics.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StatsFormat {
    /// Text.
    Text,
    /// JSON.
    Json,
}
