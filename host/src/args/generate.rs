//! The options of `generate`.

use std::path::PathBuf;

use clap::Parser;
use strahl_scene::procedural::{ProceduralScene, SceneFormat};

use super::names::name_of;

/// Options of `generate`.
#[derive(Debug, Parser)]
pub struct GenerateArgs {
    /// Scene to generate.
    #[arg(value_name = "WHAT", value_parser = name_of::<ProceduralScene>())]
    pub scene: ProceduralScene,

    /// Size: the number of subdivisions, or the minimum number of triangles for knot and stadium [default:
    /// see below].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub size: Option<u32>,

    /// Output; the extension selects the format (.nff .toml .ply); `-` is standard output (NFF) [default:
    /// the scene's name with the extension of --format, or .nff, in the current folder].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Format, overriding the extension.
    #[arg(long, value_name = "FORMAT", value_parser = name_of::<SceneFormat>())]
    pub format: Option<SceneFormat>,

    /// Write objects and materials only, without camera, lights and background, for use in another scene.
    #[arg(long)]
    pub bare: bool,

    /// Print errors only.
    #[arg(short, long)]
    pub quiet: bool,
}
