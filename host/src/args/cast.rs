//! The options of `cast`.

use std::path::PathBuf;

use clap::Parser;

use super::finding::FindingArgs;
use super::values::threads;
use crate::precision::Precision;

/// What to cast, and how.
#[derive(Debug, Parser)]
pub struct CastArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    pub scene: PathBuf,

    /// The rays; `-` is the standard input.
    #[arg(long, value_name = "FILE", default_value = "-")]
    pub rays: PathBuf,

    /// Where the hits go; `-` is the standard output.
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,

    /// What is computed with, and what rays are read and hits are written in; the numbers of a scene
    /// are rounded to single precision either way [default: the scene's, or single].
    #[arg(long, value_name = "PRECISION")]
    pub precision: Option<Precision>,

    /// How items are found.
    #[command(flatten)]
    pub finding: FindingArgs,

    /// Threads [default: one for each core].
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub threads: Option<usize>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}
