//! The options of `render`, which `watch` takes too.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};

use super::settings::{EverySetting, SettingArgs};

/// How `render` is called.
pub(super) const EXAMPLES: &str = "\
Examples:
  strahl render glass.toml                           writes glass.png
  strahl render glass.toml --size 1280x960 --sampler regular:3 -o large.exr
  strahl render glass.toml --cost cost.png           where the work goes, as a picture
  strahl render glass.toml --target-error 0.01       the cheapest settings that are as good as that
  strahl render glass.toml --target-error 0.01 --verify
  strahl render glass.toml --time-limit 2s           the best picture in two seconds";

/// What to render, and how.
#[derive(Debug, Parser)]
pub struct RenderArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    pub scene: PathBuf,

    /// Where the picture goes; the extension names the format (.png .ppm .qoi .jpg .tif .exr), `-`
    /// is the standard output (PNG) [default: the scene's name with .png, in the current folder].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Trace only the pixels that are white in this picture, of the same size; the others stay
    /// black.
    #[arg(long, value_name = "IMAGE")]
    pub mask: Option<PathBuf>,

    /// Which picture, and how the work is done.
    #[command(flatten)]
    pub settings: SettingArgs<EverySetting>,

    /// Report what was counted and measured, on the standard output or in --stats-file.
    #[arg(long, value_name = "FORM")]
    pub stats: Option<StatsForm>,

    /// Where the report goes [default form: json].
    #[arg(long, value_name = "FILE")]
    pub stats_file: Option<PathBuf>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}

/// How a report is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StatsForm {
    /// For people.
    Text,
    /// For programs.
    Json,
}
