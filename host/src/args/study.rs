//! The options of `study`.

use std::path::PathBuf;
use std::time::Duration;

use clap::Parser;
use strahl_core::Resolution;
use strahl_settings::{Domain, Value};

use super::settings::{OfWork, SettingArgs};
use super::times::duration;

/// Options of `study`.
#[derive(Debug, Parser)]
pub struct StudyArgs {
    /// Scene (.toml, .nff) or model (.obj, .ply, .gltf, .glb).
    #[arg(required_unless_present = "from")]
    pub scene: Option<PathBuf>,

    /// Output folder [default: the scene's name with -study, in the current folder; with --from, the folder
    /// of that file].
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,

    /// Width and height in pixels [default: the scene's aspect ratio, at most 65536 pixels].
    #[arg(long, value_name = "WxH", value_parser = size, allow_hyphen_values = true)]
    pub size: Option<Resolution>,

    /// Measure more values of every setting, with a finer reference and more repetitions; no time limit by
    /// default.
    #[arg(long)]
    pub full: bool,

    /// Finish within this time, as in 30s, 5m or 1h 30m; settings for which no time is left are skipped and
    /// listed [default: 50s; none with --full].
    #[arg(long, value_name = "TIME", value_parser = duration)]
    pub time_limit: Option<Duration>,

    /// Threads.
    #[command(flatten)]
    pub settings: SettingArgs<OfWork>,

    /// Measure nothing; write report.html and study.csv from this study.json.
    #[arg(long, value_name = "STUDY.JSON", conflicts_with_all = ["scene", "size", "full", "time_limit", "threads"])]
    pub from: Option<PathBuf>,

    /// Add firmware measurements to the report, from a CSV file whose first line is
    /// scene,width,height,precision,levels,cutoff,sampler,instructions,rays,rmse.
    #[arg(long, value_name = "CSV")]
    pub device: Option<PathBuf>,

    /// Print errors only.
    #[arg(short, long)]
    pub quiet: bool,
}

fn size(word: &str) -> Result<Resolution, String> {
    Resolution::parse(word, &Domain::Size)
}
