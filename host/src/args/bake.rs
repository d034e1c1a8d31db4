//! The options of `bake`.

use std::path::PathBuf;

use clap::Parser;
use strahl_settings::{Accel, AccelKind};

use super::names::name_of;
use super::settings::{OfFrame, SettingArgs};

/// Options of `bake`.
#[derive(Debug, Parser)]
pub struct BakeArgs {
    /// Scene (.toml, .nff) or model (.obj, .ply, .gltf, .glb).
    pub scene: PathBuf,

    /// Output; with .rs, the scene as Rust constants without an accelerator; `-` is standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,

    /// Acceleration structure on the device; `auto` is bvh [default: auto].
    #[arg(long, value_name = "KIND", value_parser = name_of::<Accel>())]
    pub accel: Option<Accel>,

    /// Maximum number of nodes of the BVH or octree; fewer nodes take less flash and make larger leaves
    /// [default: enough for full speed].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), allow_negative_numbers = true)]
    pub nodes: Option<u32>,

    /// Size, levels and cutoff.
    #[command(flatten)]
    pub settings: SettingArgs<OfFrame>,

    /// Print errors only.
    #[arg(short, long)]
    pub quiet: bool,
}

impl BakeArgs {
    /// Whether the output is Rust source.
    pub fn is_rust_source(&self) -> bool {
        self.output.extension().is_some_and(|extension| extension == "rs")
    }

    /// Options that cannot be used together; `None` if there are none.
    pub fn conflict(&self) -> Option<String> {
        let is_given = [("accel", self.accel.is_some()), ("nodes", self.nodes.is_some())];
        if self.is_rust_source()
            && let Some((name, _)) = is_given.iter().find(|(_, is_given)| *is_given)
        {
            return Some(format!("--{name} cannot be used with a .rs output: it has no accelerator"));
        }
        match self.accel.and_then(Accel::explicit_kind) {
            Some(kind @ (AccelKind::List | AccelKind::Grid)) if self.nodes.is_some() => {
                Some(format!("--nodes cannot be used with --accel {kind}"))
            }
            _ => None,
        }
    }
}
