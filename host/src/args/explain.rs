//! The options of `explain`.

use std::path::PathBuf;

use clap::Parser;
use strahl_core::image::Pixel;

use super::settings::{OfPixel, SettingArgs};

/// Examples in the help of `explain`.
pub(super) const EXAMPLES: &str = "\
Examples:
  strahl explain glass.toml 320,240                 why this pixel has its color
  strahl explain glass.toml 320,240 --svg tree.svg  the ray tree as SVG
  strahl explain glass.toml 320,240 --sampler regular:3 --sample 5
  strahl explain glass.toml 320,240 --json | jq '.samples[].rays[] | select(.level == 2)'";

/// Options of `explain`.
#[derive(Debug, Parser)]
pub struct ExplainArgs {
    /// Scene (.toml, .nff) or model (.obj, .ply, .gltf, .glb).
    pub scene: PathBuf,

    /// Column and row of the pixel, from 0 at the upper left.
    #[arg(value_name = "X,Y", value_parser = pixel, allow_hyphen_values = true)]
    pub pixel: Pixel,

    /// Settings of the picture.
    #[command(flatten)]
    pub settings: SettingArgs<OfPixel>,

    /// Print the tree of this sample only, from 1; --json prints all, --svg draws one [default for --svg:
    /// 1].
    #[arg(long, value_name = "K", value_parser = sample, allow_negative_numbers = true)]
    pub sample: Option<usize>,

    /// Print JSON; numbers have the shortest form that reads back exactly.
    #[arg(long)]
    pub json: bool,

    /// Write the tree as SVG; with `-` to standard output, instead of the text.
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,

    /// Print errors only; with --svg also no text.
    #[arg(short, long)]
    pub quiet: bool,
}

fn pixel(text: &str) -> Result<Pixel, String> {
    let parts = text.split_once(',').and_then(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?)));
    let Some((x, y)) = parts else {
        return Err("must be X,Y, two integers from 0, as in 320,240".into());
    };
    Ok(Pixel { x, y })
}

fn sample(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|number| *number >= 1).ok_or_else(|| "must be an integer from 1".into())
}
