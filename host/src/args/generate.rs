//! The options of `generate`.

use std::path::PathBuf;

use clap::Parser;
use strahl_scene::procedural::{ProceduralScene, SceneFormat};

use super::names::name_of;

/// Which scene to make, and where it goes.
#[derive(Debug, Parser)]
pub struct GenerateArgs {
    /// ProceduralScene to make.
    #[arg(value_name = "WHAT", value_parser = name_of::<ProceduralScene>())]
    pub what: ProceduralScene,

    /// How large: how often it is divided, or for knot and stadium, how many triangles at least
    /// [default: as below].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub size: Option<u32>,

    /// Where it goes; the extension names the format (.nff .toml .ply), `-` is the standard output
    /// (NFF) [default: WHAT with the extension of the --format or .nff, in the current folder].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// How it is written, whatever the extension is.
    #[arg(long, value_name = "FORMAT", value_parser = name_of::<SceneFormat>())]
    pub format: Option<SceneFormat>,

    /// The objects with their materials only, without view, lights and background, to go into a
    /// scene of one's own.
    #[arg(long)]
    pub bare: bool,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}
