//! The command line: its commands, and the options of each.
//!
//! | room | what it does |
//! |---|---|
//! | `render` | the options of `render`, which `watch` takes too |
//! | `aim` | those of `render` alone: what settings are to keep |
//! | `cast`, `info`, `study`, `explain`, `bake`, `compare`, `generate` | those of the command of this name |
//! | `manual` | those of `man` and `schema` |
//! | `settings` | the options of settings, which several commands share |
//! | `names` | options whose values have names |
//! | `times` | options whose values are times |

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
pub use render::{RenderArgs, StatsForm};
pub use settings::{Groups, OfPixel, SettingArgs};
pub use study::StudyArgs;

/// What the exit status says.
const STATUS: &str = "\
Exit status: 0 done; 1 the answer is no (pictures differ, an error is not kept); 2 wrong usage; 65 the scene or another input is \
wrong; 66 it cannot be read; 74 the output cannot be written; 75 stopped by SIGTERM, may be tried again; \
130 interrupted.";

/// A Whitted ray tracer: the same picture, bit for bit, on a workstation and on a
/// microcontroller.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 100, after_long_help = STATUS)]
pub struct Args {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Render a scene into a picture.
    #[command(after_long_help = render::EXAMPLES)]
    Render {
        /// What, and how.
        #[command(flatten)]
        args: RenderArgs,

        /// What is aimed at.
        #[command(flatten)]
        aim: AimArgs,

        /// Print the settings in force and where each comes from, ready to be put into a scene or
        /// behind a command, and make no picture.
        #[arg(long, conflicts_with_all = ["cost", "target_error", "time_limit"])]
        print_settings: bool,
    },
    /// Tell what rays hit: rays in as CSV, hits out as CSV.
    ///
    /// A ray is a line ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax: where it starts, where it goes
    /// (a direction of any length from 1e-30 to 1e30), and how far a hit may be, in lengths of that
    /// direction. The first line may name the fields instead, by these names in this order; then the
    /// first row names those of the hits, so that rows and lines always stand side by side.
    ///
    /// The row of a ray is hit,t,object,px,py,pz,nx,ny,nz: 1 or 0; how far, 0 < t <= tmax, in lengths
    /// of the direction; the number of the object in the order of the scene file, from 0, where every
    /// triangle of a mesh counts as one; the point; and the geometric normal, of length one, which is
    /// not turned towards the ray: outward for solids, away from the axis for open cylinders and
    /// cones, by the right hand round the corners for triangles and polygons. Both sides of every
    /// surface count. After the 0 of a miss everything is empty. Numbers have the shortest form that
    /// is read back exactly.
    ///
    /// Numbers may be nan, inf, or out of range (that of the precision; 1e15 for where a ray starts):
    /// such a ray is a miss, as is one without direction. -0 is 0. A tmax of inf is no limit; one that is nan, 0
    /// or negative lets nothing be hit. A line with another number of fields, or with a word that is no
    /// number, is an error (status 65) that names it; the rows of the lines before it stay.
    ///
    /// Rows come as soon as lines do, so a pipe may ask and wait for the answer.
    Cast(CastArgs),
    /// Render a scene again at every save of it and of the files that it names, until Ctrl-C.
    ///
    /// A coarse picture comes first, then the full one. What is wrong in the scene is told, and
    /// the last picture stays until it is mended. Takes the options of `render`, and follows the mask
    /// too; but not what is aimed at (--target-error, --time-limit), and no --cost. The picture goes
    /// into a file, never to the standard output.
    Watch(RenderArgs),
    /// Tell what is in a scene, what it asks for and why, and what it takes.
    Info(InfoArgs),
    /// Measure what accuracy costs in time, setting by setting, and show it.
    ///
    /// The scene is rendered over a plan of settings, each held against a reference of high quality.
    /// The folder that comes of it has a page to look at (report.html, which needs no network), the
    /// runs as a table (study.csv), and everything as it was measured (study.json, whose schema
    /// `strahl schema study` prints), of which --from makes the page again.
    Study(StudyArgs),
    /// Show the tree of rays of one pixel: what each meets, which lights are seen, what counts how much.
    ///
    /// Every ray is told with its level and its weight (the share of what it finds that counts), what
    /// it meets where in the scene file, how far away, which lights are seen from there or what
    /// stands in their way, what was cut and why. The sum of what the rays add is the pixel, bit for
    /// bit. A pixel of several samples prints a tree for each, and how the pixel comes of them.
    #[command(after_long_help = explain::EXAMPLES)]
    Explain(ExplainArgs),
    /// Bake a scene with its accelerator into bytes that a device traces from flash.
    ///
    /// The firmware opens them where they lie (`BakedScene::open` of the core): nothing is copied and
    /// nothing is built. Tells what a device must have for it.
    Bake(BakeArgs),
    /// Tell how two pictures differ; the exit status is 0 when they do not, 1 when they do.
    ///
    /// All differences are of sRGB-encoded values, 0 to 1; of two EXR files too, whose largest
    /// linear difference is told besides. An EXR file beside another format is rounded to the bits
    /// of that one.
    Compare(CompareArgs),
    /// Make a scene by a formula, of any size, for measuring how time and memory grow.
    ///
    /// Names, views, lights and surfaces are those of the Standard Procedural Databases (Eric Haines,
    /// 1987) where they have such a scene, at the same sizes. The same command makes the same file on
    /// every machine.
    Generate(GenerateArgs),
    /// Print the completions for a shell.
    Completions {
        /// Which.
        shell: Shell,
    },
    /// Print the manual page.
    Man(ManArgs),
    /// Print the JSON Schema of scenes in TOML, for editors, or that of study.json.
    Schema {
        /// Of which file.
        #[arg(default_value = "scene")]
        what: Schema,
    },
}
