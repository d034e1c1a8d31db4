//! The options of `bake`.

use std::path::PathBuf;

use clap::Parser;
use strahl_settings::{Accel, AccelKind};

use super::names::name_of;
use super::settings::{OfFrame, SettingArgs};

/// What to bake, and how.
#[derive(Debug, Parser)]
pub struct BakeArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    pub scene: PathBuf,

    /// Where the baked scene goes; with the extension .rs the scene as Rust constants instead,
    /// without an accelerator; `-` is the standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,

    /// How items are found on the device; `auto` is the hierarchy [default: auto].
    #[arg(long, value_name = "KIND", value_parser = name_of::<Accel>())]
    pub accel: Option<Accel>,

    /// The most nodes of the hierarchy or the octree: less flash for larger leaves [default: as
    /// many as make it fast].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), allow_negative_numbers = true)]
    pub nodes: Option<u32>,

    /// What the picture is to be like.
    #[command(flatten)]
    pub settings: SettingArgs<OfFrame>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}

impl BakeArgs {
    /// Whether the scene becomes Rust constants.
    pub fn is_source(&self) -> bool {
        self.output.extension().is_some_and(|extension| extension == "rs")
    }

    /// What is asked for that has no meaning together.
    pub fn misfit(&self) -> Option<String> {
        let is_given = [("accel", self.accel.is_some()), ("nodes", self.nodes.is_some())];
        if self.is_source()
            && let Some((name, _)) = is_given.iter().find(|(_, is_given)| *is_given)
        {
            return Some(format!("--{name} has no meaning for a .rs file: constants have no accelerator"));
        }
        match self.accel.and_then(Accel::explicit_kind) {
            Some(kind @ (AccelKind::List | AccelKind::Grid)) if self.nodes.is_some() => {
                Some(format!("--nodes has no meaning for --accel {kind}"))
            }
            _ => None,
        }
    }
}
