//! The options of `explain`.

use std::path::PathBuf;

use clap::Parser;
use strahl_core::image::Pixel;

use super::settings::{OfPixel, SettingArgs};

/// How `explain` is called.
pub(super) const EXAMPLES: &str = "\
Examples:
  strahl explain glass.toml 320,240                 why this pixel has its colour
  strahl explain glass.toml 320,240 --svg tree.svg  the tree as a picture
  strahl explain glass.toml 320,240 --sampler regular:3 --sample 5
  strahl explain glass.toml 320,240 --json | jq '.samples[].rays[] | select(.level == 2)'";

/// Which pixel to explain, and how.
#[derive(Debug, Parser)]
pub struct ExplainArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    pub scene: PathBuf,

    /// Column and row of the pixel, counted from 0 at the upper left.
    #[arg(value_name = "X,Y", value_parser = pixel, allow_hyphen_values = true)]
    pub pixel: Pixel,

    /// Which picture it is of.
    #[command(flatten)]
    pub settings: SettingArgs<OfPixel>,

    /// Show the tree of this sample only, counted from 1; --json tells them all, --svg draws one
    /// [default of --svg: 1].
    #[arg(long, value_name = "K", value_parser = sample, allow_negative_numbers = true)]
    pub sample: Option<usize>,

    /// For programs: all numbers in the shortest form that reads back exactly.
    #[arg(long)]
    pub json: bool,

    /// A picture of the tree as SVG; `-` is the standard output, and then no text goes there.
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,

    /// Say nothing but errors; with --svg no text either.
    #[arg(short, long)]
    pub quiet: bool,
}

fn pixel(text: &str) -> Result<Pixel, String> {
    let parts = text.split_once(',').and_then(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?)));
    let Some((x, y)) = parts else {
        return Err("two integers from 0 with a comma between them are expected, as in 320,240".into());
    };
    Ok(Pixel { x, y })
}

fn sample(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|number| *number >= 1).ok_or_else(|| "an integer from 1 is expected".into())
}
