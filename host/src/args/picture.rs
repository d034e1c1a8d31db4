//! Which picture is wanted: options that `render`, `watch` and `explain` share, and `bake` in part.

use strahl_core::Size;

use super::values::{cutoff, levels, size};
use crate::description::Settings;
use crate::wanted::{Filter, Sampling};

/// How large it is, and how deep its rays go: what holds whoever traces it.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct FrameArgs {
    /// Width and height in pixels [default: the scene's, or 640x480].
    #[arg(long, value_name = "WxH", value_parser = size, allow_hyphen_values = true)]
    pub size: Option<Size>,

    /// Levels of rays; 1 sends no ray from a surface, mirrors stay black [default: the scene's,
    /// or 5].
    #[arg(long, value_name = "N", value_parser = levels(), allow_negative_numbers = true)]
    pub levels: Option<u8>,

    /// A ray is sent when more than this share of what it finds counts in the pixel, 0 to 1
    /// [default: the scene's, or 1/512].
    #[arg(long, value_name = "W", value_parser = cutoff, allow_negative_numbers = true)]
    pub cutoff: Option<f32>,
}

/// Which picture is wanted.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct PictureArgs {
    /// Its frame.
    #[command(flatten)]
    pub frame: FrameArgs,

    /// Rays in each pixel: `single` through the middle; `regular:N` N times N;
    /// `adaptive:DEPTH:THRESHOLD` through the corners, and again through those of its quarters where
    /// they differ more than THRESHOLD (sRGB, 0 to 1), up to DEPTH times, with `:items` also where
    /// they meet different objects; `stochastic:N` through places without a raster;
    /// `stochastic:MIN..MAX:CONFIDENCE` until with this confidence (0 to 1) the mean is at most
    /// 1/128 off (or what follows a last `:`) [default: the scene's, or single].
    #[arg(long, value_name = "SAMPLER")]
    pub sampler: Option<Sampling>,

    /// How much of its surroundings counts in a pixel; not with `adaptive`, which fills the pixel
    /// [default: the scene's, or box].
    #[arg(long, value_name = "FILTER")]
    pub filter: Option<Filter>,

    /// Another seed, other numbers in place of chance [default: the scene's, or 0].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub seed: Option<u32>,
}

impl PictureArgs {
    /// What the command line asks for.
    pub fn asked(&self) -> Settings {
        let PictureArgs { frame, sampler: sampling, filter, seed } = *self;
        let FrameArgs { size, levels, cutoff } = frame;
        Settings { size, levels, cutoff, sampling, filter, seed, ..Settings::default() }
    }
}
