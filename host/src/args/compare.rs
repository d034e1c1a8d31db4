//! The options of `compare`.

use std::path::PathBuf;

use clap::Parser;
use strahl_settings::domain::parse_fraction;

/// Options of `compare`.
#[derive(Debug, Parser)]
pub struct CompareArgs {
    /// First picture (PNG, PPM, QOI, JPEG, TIFF, EXR); `-` is standard input.
    #[arg(value_name = "A")]
    pub first: PathBuf,

    /// Second picture, of the same resolution.
    #[arg(value_name = "B")]
    pub second: PathBuf,

    /// Largest allowed difference of a channel, 0 to 1, as in 0.01 or 1/255; 0 means bit-identical.
    #[arg(long, value_name = "X", value_parser = parse_fraction, allow_negative_numbers = true, default_value = "0", hide_default_value = true)]
    pub limit: f64,

    /// Share of pixels that may exceed --limit, 0 to 1 [default: 0].
    #[arg(long, value_name = "S", value_parser = parse_fraction, allow_negative_numbers = true, default_value = "0", hide_default_value = true)]
    pub limit_share: f64,

    /// Print JSON with the keys first second width height identical equal limit limit_share
    /// largest{difference x y channel} mean_absolute rmse psnr ssim differing{pixels share} beyond{pixels
    /// share} over_limit{pixels share} largest_linear{difference x y channel}.
    #[arg(long)]
    pub json: bool,

    /// Write a difference map: the largest channel difference of each pixel on a logarithmic color scale
    /// (black 0, violet 1/255, pale yellow 1).
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Print errors only.
    #[arg(short, long)]
    pub quiet: bool,
}
