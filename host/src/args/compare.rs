//! The options of `compare`.

use std::path::PathBuf;

use clap::Parser;
use strahl_settings::domain::parse_fraction;

/// What to compare, and how much it may differ.
#[derive(Debug, Parser)]
pub struct CompareArgs {
    /// A picture (PNG, PPM, QOI, JPEG, TIFF, EXR); `-` is the standard input.
    #[arg(value_name = "A")]
    pub first: PathBuf,

    /// Another of the same size.
    #[arg(value_name = "B")]
    pub second: PathBuf,

    /// How much a channel of a pixel may differ, 0 to 1, as in 0.01 or 1/255; 0: not by one bit.
    #[arg(long, value_name = "X", value_parser = parse_fraction, allow_negative_numbers = true, default_value = "0", hide_default_value = true)]
    pub limit: f64,

    /// The share of all pixels that may differ by more than that, 0 to 1 [default: 0].
    #[arg(long, value_name = "S", value_parser = parse_fraction, allow_negative_numbers = true, default_value = "0", hide_default_value = true)]
    pub limit_share: f64,

    /// For programs: first second width height identical equal limit limit_share
    /// largest{difference x y channel} mean_absolute rmse psnr ssim differing{pixels share}
    /// beyond{pixels share} over_limit{pixels share} largest_linear{difference x y channel}.
    #[arg(long)]
    pub json: bool,

    /// A picture of the largest difference in each pixel: black is none, 1/255 violet, each
    /// doubling as much brighter, pale yellow all.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}
