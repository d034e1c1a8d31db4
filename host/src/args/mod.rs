//! The command line: its commands, and the options of each.
//!
//! | module | contents |
//! |---|---|
//! | `render` | options of `render` and `watch` |
//! | `aim` | options of `render` only: target error, time limit, cost map |
//! | `cast`, `info`, `study`, `explain`, `bake`, `compare`, `generate` | options of the command of this name |
//! | `manual` | options of `man` and `schema` |
//! | `settings` | options of settings, shared by several commands |
//! | `names` | options with named values |
//! | `times` | options with durations |

mod aim;
mod bake;
mod cast;
mod compare;
mod explain;
mod generate;
mod info;
mod manual;
mod names;
mod render;
mod settings;
mod study;
mod times;

use clap::{Parser, Subcommand};
use clap_complete::Shell;

pub use aim::AimArgs;
pub use bake::BakeArgs;
pub use cast::CastArgs;
pub use compare::CompareArgs;
pub use explain::ExplainArgs;
pub use generate::GenerateArgs;
pub use info::InfoArgs;
pub use manual::{ManArgs, Schema};
pub use render::{RenderArgs, StatsFormat};
pub use settings::{Groups, OfPixel, SettingArgs};
pub use study::StudyArgs;

/// Help text of the exit status.
const EXIT_STATUS_HELP: &str = "\
Exit status: 0 success; 1 check failed (pictures differ, target error not reached); 2 usage error; \
65 invalid scene or input; 66 input not readable; 74 output not writable; 75 stopped by SIGTERM or out of \
time, can be retried; 130 interrupted.";

/// A Whitted ray tracer: the same picture, bit for bit, on a workstation and on a
/// microcontroller.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 100, after_long_help = EXIT_STATUS_HELP)]
pub struct Args {
    /// Command.
    #[command(subcommand)]
    pub command: Command,
}

/// Commands and their options.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Render a scene to a picture file.
    #[command(after_long_help = render::EXAMPLES)]
    Render {
        /// Options that `watch` has too.
        #[command(flatten)]
        args: RenderArgs,

        /// Target error, time limit and cost map.
        #[command(flatten)]
        aim: AimArgs,

        /// Print the effective settings and the source of each, as TOML for a scene and as a command line;
        /// render nothing.
        #[arg(long, conflicts_with_all = ["cost", "target_error", "time_limit"])]
        print_settings: bool,
    },
    /// Intersect rays with a scene: rays in as CSV, hits out as CSV.
    ///
    /// A ray is a line ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax: origin, direction (length from 1e-30 to
    /// 1e30) and largest t. The first line may be a header with these names in this order; then the first
    /// output row is a header too, so that line N of the output always answers line N of the input.
    ///
    /// A row is hit,t,object,px,py,pz,nx,ny,nz: 1 or 0; t with 0 < t <= tmax, in units of the given
    /// direction; the index of the object in the order of the scene file, from 0, where every triangle of a
    /// mesh counts as one; the hit point; and the geometric unit normal, which is not flipped towards the
    /// ray: outward for solids, away from the axis for open cylinders and cones, by the right-hand rule
    /// around the vertices of triangles and polygons. Surfaces are hit from both sides. For a miss, all
    /// fields after 0 are empty. Numbers are printed in the shortest form that reads back exactly.
    ///
    /// NaN, infinite and out-of-range numbers (beyond the precision, or beyond 1e15 for an origin) are
    /// accepted: such a ray is a miss, as is a ray with a zero direction. -0 is 0. A tmax of inf means no
    /// limit; with a tmax of nan, 0 or less the ray is a miss. A line with a wrong number of fields, or
    /// with a field that is not a number, is an error (status 65) that names the line; rows of earlier
    /// lines are kept.
    ///
    /// Rows are written as soon as their lines are read, so that a program can write a ray and wait for its
    /// hit.
    Cast(CastArgs),
    /// Render a scene again whenever it, or a file that it references, is saved; Ctrl-C ends it.
    ///
    /// A coarse preview is written first, then the full picture. Errors in the scene are reported, and the
    /// last picture is kept until they are fixed. Takes the options of `render` except --target-error,
    /// --verify, --time-limit, --cost and --print-settings; watches the mask too. The output must be a
    /// file.
    Watch(RenderArgs),
    /// Show the contents of a scene, the effects it requires and why, and the memory of each accelerator.
    Info(InfoArgs),
    /// Measure accuracy against rendering time for many settings, and write a report.
    ///
    /// The scene is rendered with many settings, and each picture is compared with a high-quality
    /// reference. The output folder has a report (report.html, no network needed), the runs as a table
    /// (study.csv) and all measurements (study.json; `strahl schema study` prints its schema), from which
    /// --from makes the report again.
    Study(StudyArgs),
    /// Show the ray tree of one pixel: what each ray hits, which lights are visible, and what contributes
    /// how much.
    ///
    /// For every ray: its level and weight (its share of the pixel), what it hits and where that is in the
    /// scene file, the distance, which lights are visible or what occludes them, and which secondary rays
    /// were not traced and why. The contributions of the rays add up to the pixel, bit for bit. For a pixel
    /// with several samples, one tree is printed for each, and how the pixel is computed from them.
    #[command(after_long_help = explain::EXAMPLES)]
    Explain(ExplainArgs),
    /// Bake a scene and its accelerator into a binary that a device renders from flash.
    ///
    /// Firmware opens it in place (`BakedScene::open` of strahl-core): nothing is copied or built on the
    /// device. Prints the flash, RAM and stack that the scene needs.
    Bake(BakeArgs),
    /// Compare two pictures; the exit status is 0 if they are equal, 1 if they differ.
    ///
    /// All differences are of sRGB-encoded values, 0 to 1, also for two EXR files, whose largest linear
    /// difference is printed in addition. An EXR file that is compared with another format is first rounded
    /// to that format's bit depth.
    Compare(CompareArgs),
    /// Generate a procedural scene of any size, to measure how time and memory scale.
    ///
    /// Names, views, lights, materials and sizes are those of the Standard Procedural Databases (Eric
    /// Haines, 1987) where these have such a scene. The same command writes the same bytes on every
    /// machine.
    Generate(GenerateArgs),
    /// Print shell completions.
    Completions {
        /// Shell.
        shell: Shell,
    },
    /// Print the manual page.
    Man(ManArgs),
    /// Print the JSON Schema of TOML scenes (for editors) or of study.json.
    Schema {
        /// File format.
        #[arg(value_name = "WHAT", default_value = "scene")]
        format: Schema,
    },
}
