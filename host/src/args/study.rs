//! The options of `study`.

use std::path::PathBuf;
use std::time::Duration;

use clap::Parser;
use strahl_core::Resolution;
use strahl_settings::{Domain, Value};

use super::settings::{OfWork, SettingArgs};
use super::times::duration;

/// What to study, and how thoroughly.
#[derive(Debug, Parser)]
pub struct StudyArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    #[arg(required_unless_present = "from")]
    pub scene: Option<PathBuf>,

    /// The folder for it [default: the scene's name with -study, in the current folder; with --from the
    /// folder of that file].
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,

    /// Width and height in pixels [default: the scene's shape, with at most 65536 pixels].
    #[arg(long, value_name = "WxH", value_parser = size, allow_hyphen_values = true)]
    pub size: Option<Resolution>,

    /// More notches of every knob, a finer reference, and more repetitions; takes as long as it takes.
    #[arg(long)]
    pub full: bool,

    /// End by then, as in 30s, 5m or 1h 30m; what there is no time for is left out, and told [default: 50s;
    /// with --full none].
    #[arg(long, value_name = "TIME", value_parser = duration)]
    pub time_limit: Option<Duration>,

    /// How the work is divided.
    #[command(flatten)]
    pub settings: SettingArgs<OfWork>,

    /// Measure nothing: make the page and the table of this study.json again.
    #[arg(long, value_name = "STUDY.JSON", conflicts_with_all = ["scene", "size", "full", "time_limit", "threads"])]
    pub from: Option<PathBuf>,

    /// Lay what firmware has measured into the page: a CSV file whose first line is
    /// scene,width,height,precision,levels,cutoff,sampler,instructions,rays,rmse.
    #[arg(long, value_name = "CSV")]
    pub device: Option<PathBuf>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}

fn size(word: &str) -> Result<Resolution, String> {
    Resolution::parse(word, &Domain::Size)
}
