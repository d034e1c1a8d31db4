//! The options of `render`, which `watch` takes too.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};
use strahl_core::{Pixel, Size, Tile};

use super::finding::FindingArgs;
use super::picture::PictureArgs;
use super::values::threads;
use crate::plan::Effect;
use crate::precision::Precision;
use crate::wanted::Selecting;

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

    /// Which picture.
    #[command(flatten)]
    pub picture: PictureArgs,

    /// Trace one pixel in STEP times STEP, and those between only where these differ more than
    /// THRESHOLD (sRGB, 0 to 1), or with `:items` where they meet different objects; else guess
    /// them. STEP is 2, 4, 8, 16, 32 or 64.
    #[arg(long, value_name = "STEP:THRESHOLD")]
    pub select: Option<Selecting>,

    /// Make only this part of the picture: its upper left pixel, and how large it is.
    #[arg(long, value_name = "X,Y,WxH", value_parser = region, allow_hyphen_values = true)]
    pub region: Option<Tile>,

    /// Trace only the pixels that are white in this picture, of the same size; the others stay
    /// black.
    #[arg(long, value_name = "IMAGE")]
    pub mask: Option<PathBuf>,

    /// Leave out these effects, whatever the scene asks for; the summary says so.
    #[arg(long, value_name = "EFFECT", value_delimiter = ',')]
    pub without: Vec<Effect>,

    /// What is computed with; the numbers of a scene are rounded to single precision either way
    /// [default: the scene's, or single].
    #[arg(long, value_name = "PRECISION")]
    pub precision: Option<Precision>,

    /// How items are found.
    #[command(flatten)]
    pub finding: FindingArgs,

    /// Do not ask first who stood last in the way of a light, which changes the time and nothing
    /// else.
    #[arg(long)]
    pub no_shadow_cache: bool,

    /// Threads [default: one for each core].
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub threads: Option<usize>,

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

fn region(text: &str) -> Result<Tile, String> {
    let wrong = || "X,Y,WxH is expected, as in 100,50,320x200".to_string();
    let mut words = text.splitn(3, ',');
    let mut next = || words.next().ok_or_else(wrong);
    let (x, y, size) = (next()?, next()?, next()?);
    let (width, height) = size.split_once(['x', 'X']).ok_or_else(wrong)?;
    let number = |text: &str| text.parse::<u32>().map_err(|_| wrong());
    let (x, y, width, height) = (number(x)?, number(y)?, number(width)?, number(height)?);
    match Size::new(width, height) {
        Some(_) => Ok(Tile { first: Pixel { x, y }, width, height }),
        None => Err(format!("each side must be between 1 and {}", Size::MOST)),
    }
}
