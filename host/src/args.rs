//! The command line.

use std::path::PathBuf;
use std::str::FromStr;

use clap::{Parser, Subcommand, ValueEnum};
use strahl_core::{Regular, Size};

use crate::workers::{LEVELS, Sampling};

/// The most pixels of a picture: its linear colours take 12 bytes each.
const MOST_PIXELS: u64 = 1 << 28;

/// A Whitted ray tracer: the same picture, bit for bit, on a workstation and on a
/// microcontroller.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 100, disable_help_subcommand = true)]
pub struct Args {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Render a scene into a picture.
    Render(RenderArgs),
    /// Tell what is in a scene, what it asks for and why, and what it takes.
    Info(InfoArgs),
}

/// What to render, and how.
#[derive(Debug, Parser)]
pub struct RenderArgs {
    /// The scene: an NFF file.
    pub scene: PathBuf,

    /// Where the picture goes; the extension names the format (.png .ppm), `-` is the standard
    /// output (PNG) [default: the scene's name with .png, in the current folder].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Width and height in pixels [default: the scene's, or 640x480].
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<Size>,

    /// Levels of rays; 1 sends no ray from a surface, mirrors stay black [default: the scene's,
    /// or 5].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=LEVELS as i64))]
    pub levels: Option<u8>,

    /// A ray is sent when more than this share of what it finds counts in the pixel, 0 to 1
    /// [default: the scene's, or 1/512].
    #[arg(long, value_name = "W", value_parser = cutoff)]
    pub cutoff: Option<f32>,

    /// Rays in each pixel: `single` through the middle, `regular:N` N times N, `adaptive:0:0`
    /// through the corners, which neighbours share [default: the scene's, or single].
    #[arg(long, value_name = "SAMPLER")]
    pub sampler: Option<Sampling>,

    /// Threads [default: one for each core].
    #[arg(long, value_name = "N", value_parser = threads)]
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

/// What to tell about.
#[derive(Debug, Parser)]
pub struct InfoArgs {
    /// The scene.
    pub scene: PathBuf,

    /// For programs.
    #[arg(long)]
    pub json: bool,
}

/// How a report is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StatsForm {
    /// For people.
    Text,
    /// For programs.
    Json,
}

fn size(text: &str) -> Result<Size, String> {
    let parts = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let Some((width, height)) = parts else {
        return Err("two whole numbers with an x between them are expected, as in 640x480".into());
    };
    match Size::new(width, height) {
        Some(size) if u64::from(width) * u64::from(height) <= MOST_PIXELS => Ok(size),
        Some(_) => Err(format!("a picture has at most {MOST_PIXELS} pixels")),
        None => Err(format!("each side must be between 1 and {}", Size::MOST)),
    }
}

fn cutoff(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(cutoff) if cutoff >= 0.0 && cutoff <= 1.0 => Ok(cutoff),
        _ => Err("a number between 0 and 1 is expected".into()),
    }
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(threads) if (1..=1024).contains(&threads) => Ok(threads),
        _ => Err("a whole number between 1 and 1024 is expected".into()),
    }
}

impl FromStr for Sampling {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut words = text.split(':');
        let (kind, numbers): (_, Vec<_>) = (words.next().unwrap_or_default(), words.collect());
        match (kind, numbers.as_slice()) {
            ("single", []) => Ok(Sampling::Single),
            ("regular", [n]) => match n.parse::<u16>() {
                Ok(n) if Regular::new(n).is_some() => Ok(Sampling::Regular(n)),
                _ => Err(format!("in regular:N, N must be between 1 and {}", Regular::MOST)),
            },
            ("adaptive", [depth, threshold]) => match (depth.parse::<u32>(), threshold.parse::<f32>()) {
                (Ok(0), Ok(0.0)) => Ok(Sampling::Corners),
                (Ok(_), Ok(_)) => Err("of adaptive:DEPTH:THRESHOLD only adaptive:0:0 is there yet".into()),
                _ => Err("in adaptive:DEPTH:THRESHOLD two numbers are expected".into()),
            },
            _ => Err("single, regular:N or adaptive:0:0 is expected".into()),
        }
    }
}
