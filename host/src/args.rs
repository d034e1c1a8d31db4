//! The command line.

use std::path::PathBuf;
use std::time::Duration;

use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use strahl_core::{Pixel, Size, Tile};

use crate::failure::Failure;
use crate::finding::{Accel, Bounds, Finding, HEAPS, MAILBOXES, Walk};
use crate::generate::{Form, What};
use crate::plan::Effect;
use crate::wanted::{Filter, LEVELS, Precision, Sampling, Selecting};

/// The most pixels of a picture: its linear colours take 12 bytes each.
pub const MOST_PIXELS: u64 = 1 << 28;

/// What the exit status says.
const STATUS: &str = "\
Exit status: 0 done; 1 the answer is no (pictures differ, an error is not kept); 2 wrong usage; 65 the scene or another input is \
wrong; 66 it cannot be read; 74 the output cannot be written; 75 stopped by SIGTERM, may be tried again; \
130 interrupted.";

/// How `render` is called.
const RENDER: &str = "\
Examples:
  strahl render glass.toml                           writes glass.png
  strahl render glass.toml --size 1280x960 --sampler regular:3 -o large.exr
  strahl render glass.toml --cost cost.png           where the work goes, as a picture
  strahl render glass.toml --target-error 0.01       the cheapest settings that are as good as that
  strahl render glass.toml --target-error 0.01 --verify
  strahl render glass.toml --time-limit 2s           the best picture in two seconds";

/// How `explain` is called.
const EXPLAIN: &str = "\
Examples:
  strahl explain glass.toml 320,240                 why this pixel has its colour
  strahl explain glass.toml 320,240 --svg tree.svg  the tree as a picture
  strahl explain glass.toml 320,240 --sampler regular:3 --sample 5
  strahl explain glass.toml 320,240 --json | jq '.samples[].rays[] | select(.level == 2)'";

/// A Whitted ray tracer: the same picture, bit for bit, on a workstation and on a
/// microcontroller.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 100, disable_help_subcommand = true, after_long_help = STATUS)]
pub struct Args {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Render a scene into a picture.
    #[command(after_long_help = RENDER)]
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
    /// direction. The first line may name the fields instead; then the first row names those of the
    /// hits, so that rows and lines always stand side by side.
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
    /// the last picture stays until it is mended. Takes the options of `render`.
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
    #[command(after_long_help = EXPLAIN)]
    Explain(ExplainArgs),
    /// Bake a scene with its accelerator into bytes that a device traces from flash.
    ///
    /// The firmware opens them where they lie (`Pack::open` of the core): nothing is copied and
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

/// What to render, and how.
#[derive(Debug, Parser)]
pub struct RenderArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    pub scene: PathBuf,

    /// Where the picture goes; the extension names the format (.png .ppm .qoi .jpg .tif .exr), `-`
    /// is the standard output (PNG) [default: the scene's name with .png, in the current folder].
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

    /// Rays in each pixel: `single` through the middle; `regular:N` N times N;
    /// `adaptive:DEPTH:THRESHOLD` through the corners, and again through those of its quarters where
    /// they differ more than THRESHOLD (sRGB, 0 to 1), up to DEPTH times, with `:items` also where
    /// they meet different objects; `stochastic:N` through places without a raster;
    /// `stochastic:MIN..MAX:CONFIDENCE` until with this confidence (0 to 1) the mean is at most
    /// 1/128 off (or what follows a last `:`) [default: the scene's, or single].
    #[arg(long, value_name = "SAMPLER")]
    pub sampler: Option<Sampling>,

    /// How much of its surroundings counts in a pixel; not with `adaptive`, which fills the pixel
    /// [default: the scene's, or box].
    #[arg(long, value_name = "FILTER")]
    pub filter: Option<Filter>,

    /// Another seed, other numbers in place of chance [default: the scene's, or 0].
    #[arg(long, value_name = "N")]
    pub seed: Option<u32>,

    /// Trace one pixel in STEP times STEP, and those between only where these differ more than
    /// THRESHOLD (sRGB, 0 to 1), or with `:items` where they meet different objects; else guess
    /// them. STEP is 2, 4, 8, 16, 32 or 64.
    #[arg(long, value_name = "STEP:THRESHOLD")]
    pub select: Option<Selecting>,

    /// Make only this part of the picture: its upper left pixel, and how large it is.
    #[arg(long, value_name = "X,Y,WxH", value_parser = region)]
    pub region: Option<Tile>,

    /// Trace only the pixels that are white in this picture, of the same size; the others stay
    /// black.
    #[arg(long, value_name = "IMAGE")]
    pub mask: Option<PathBuf>,

    /// Leave out these effects, whatever the scene asks for; the summary says so.
    #[arg(long, value_name = "EFFECT", value_delimiter = ',')]
    pub without: Vec<Effect>,

    /// What is computed with; the numbers of a scene are rounded to single precision either way
    /// [default: the scene's, or single].
    #[arg(long, value_name = "PRECISION")]
    pub precision: Option<Precision>,

    /// How items are found.
    #[command(flatten)]
    pub finding: FindingArgs,

    /// Do not ask first who stood last in the way of a light, which changes the time and nothing
    /// else.
    #[arg(long)]
    pub no_shadow_cache: bool,

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

/// What settings are to keep, and what is told of the work.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct AimArgs {
    /// Show what each pixel costs: rays, tests and levels, as a picture with a legend, or with the
    /// extension .exr as channels of numbers.
    #[arg(long, value_name = "FILE")]
    pub cost: Option<PathBuf>,

    /// Take the cheapest levels, cutoff, sampler and selection whose error is estimated below E: the root
    /// of the mean square of sRGB-encoded differences (0 to 1, as in 0.01 or 2/255) to a picture of high
    /// quality. The estimate is made on a sparse sample of pixels. What the command line sets stays as it
    /// is; what the scene sets does not. The exit status is 1 when no setting is good enough.
    #[arg(long, value_name = "E", value_parser = error)]
    pub target_error: Option<f64>,

    /// Trace the picture of high quality too, with other random numbers, and tell the true error; the
    /// exit status is 1 when it is more than E. Takes long.
    #[arg(long, requires = "target_error")]
    pub verify: bool,

    /// Make the best picture that is written when this time is over, as in 2s or 1m 30s, counted from the
    /// start of the program: a coarse raster of pixels first, then all of them, then more samples where
    /// the error is estimated largest. What is written is always complete. Levels and cutoff stay as
    /// they are.
    #[arg(long, value_name = "T", value_parser = duration,
        conflicts_with_all = ["target_error", "select", "sampler", "cost"])]
    pub time_limit: Option<Duration>,
}

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
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}

/// How items are found.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct FindingArgs {
    /// How items are found, which changes the time and nothing else: `auto` takes what suits the
    /// scene [default: the scene's, or auto].
    #[arg(long, value_name = "KIND")]
    pub accel: Option<Accel>,

    /// How a hierarchy (bvh) is walked [default: the scene's, or stack].
    #[arg(long)]
    pub walk: Option<Walk>,

    /// Places in the heap of that walk: 0, 1, 4 or 64; with fewer it takes longer [default: the
    /// scene's, or 64].
    #[arg(long, value_name = "N", value_parser = heap)]
    pub heap: Option<usize>,

    /// What the list puts round items and groups of them [default: the scene's, or box].
    #[arg(long, value_name = "VOLUME")]
    pub bounds: Option<Bounds>,

    /// Slots of the mailbox, which remembers the items of grid and octree that a ray has met: 0, 8 or 64
    /// [default: the scene's, or 64].
    #[arg(long, value_name = "SLOTS", value_parser = mailbox)]
    pub mailbox: Option<usize>,
}

impl FindingArgs {
    /// What the command line asks for, where it fits together.
    pub fn asked(&self) -> Result<Finding, Failure> {
        let FindingArgs { accel, walk, heap, bounds, mailbox } = *self;
        let asked = Finding { accel, walk, heap, bounds, mailbox };
        match asked.misfit() {
            Some(misfit) => Err(Failure::Usage(misfit)),
            None => Ok(asked),
        }
    }

    /// What the command line asks for, else the scene.
    pub fn over(&self, scene: Finding) -> Result<Finding, Failure> {
        Ok(self.asked()?.or(scene))
    }
}

/// What to bake, and how.
#[derive(Debug, Parser)]
pub struct BakeArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    pub scene: PathBuf,

    /// Where the baked scene goes; with the extension .rs the scene as Rust constants instead,
    /// without an accelerator; `-` is the standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,

    /// How items are found on the device; `auto` is the hierarchy.
    #[arg(long, value_name = "KIND", default_value = "auto")]
    pub accel: Accel,

    /// The most nodes of the hierarchy or the octree: less flash for larger leaves [default: as
    /// many as make it fast].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub nodes: Option<u32>,

    /// Width and height in pixels [default: the scene's, or 640x480].
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<Size>,

    /// Levels of rays [default: the scene's, or 5].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=LEVELS as i64))]
    pub levels: Option<u8>,

    /// A ray is sent when more than this share of what it finds counts in the pixel, 0 to 1
    /// [default: the scene's, or 1/512].
    #[arg(long, value_name = "W", value_parser = cutoff)]
    pub cutoff: Option<f32>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}

/// Which pixel to explain, and how.
#[derive(Debug, Parser)]
pub struct ExplainArgs {
    /// The scene: .toml, .nff, or a model: .obj, .ply, .gltf, .glb.
    pub scene: PathBuf,

    /// Column and row of the pixel, counted from 0 at the upper left.
    #[arg(value_name = "X,Y", value_parser = pixel)]
    pub pixel: Pixel,

    /// Width and height of the picture [default: the scene's, or 640x480].
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<Size>,

    /// Levels of rays [default: the scene's, or 5].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=LEVELS as i64))]
    pub levels: Option<u8>,

    /// A ray is sent when more than this share of what it finds counts in the pixel, 0 to 1
    /// [default: the scene's, or 1/512].
    #[arg(long, value_name = "W", value_parser = cutoff)]
    pub cutoff: Option<f32>,

    /// Rays in each pixel, as `render` takes them [default: the scene's, or single].
    #[arg(long, value_name = "SAMPLER")]
    pub sampler: Option<Sampling>,

    /// How much of its surroundings counts in a pixel [default: the scene's, or box].
    #[arg(long, value_name = "FILTER")]
    pub filter: Option<Filter>,

    /// The seed of chance [default: the scene's, or 0].
    #[arg(long, value_name = "N")]
    pub seed: Option<u32>,

    /// Leave out these effects, whatever the scene asks for.
    #[arg(long, value_name = "EFFECT", value_delimiter = ',')]
    pub without: Vec<Effect>,

    /// Show the tree of this sample only, counted from 1; --json tells them all, --svg draws one
    /// [default of --svg: 1].
    #[arg(long, value_name = "K", value_parser = sample)]
    pub sample: Option<usize>,

    /// For programs: all numbers in the shortest form that reads back exactly.
    #[arg(long)]
    pub json: bool,

    /// A picture of the tree as SVG; `-` is the standard output, and then no text goes there.
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,

    /// Say nothing but errors; with --svg no text either.
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

/// What to compare, and how much it may differ.
#[derive(Debug, Parser)]
pub struct CompareArgs {
    /// A picture (PNG, PPM, QOI, JPEG, TIFF, EXR); `-` is the standard input.
    #[arg(value_name = "A")]
    pub first: PathBuf,

    /// Another of the same size.
    #[arg(value_name = "B")]
    pub second: PathBuf,

    /// How much a channel of a pixel may differ, 0 to 1, as in 0.01 or 1/255; 0: not by one bit.
    #[arg(long, value_name = "X", value_parser = share, default_value = "0", hide_default_value = true)]
    pub limit: f64,

    /// The share of all pixels that may differ by more than that, 0 to 1 [default: 0].
    #[arg(long, value_name = "S", value_parser = share, default_value = "0", hide_default_value = true)]
    pub limit_share: f64,

    /// For programs: first second width height identical equal limit limit_share
    /// largest{difference x y channel} mean_absolute rmse psnr ssim differing{pixels share}
    /// beyond{pixels share} over_limit{pixels share} largest_linear{difference x y channel}.
    #[arg(long)]
    pub json: bool,

    /// A picture of the largest difference in each pixel: black is none, 1/255 violet, each
    /// doubling as much brighter, pale yellow all.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}

/// Which scene to make, and where it goes.
#[derive(Debug, Parser)]
pub struct GenerateArgs {
    /// What to make.
    #[arg(value_name = "WHAT")]
    pub what: What,

    /// How large: how often it is divided, or for knot and stadium, how many triangles at least
    /// [default: as below].
    #[arg(long, value_name = "N")]
    pub size: Option<u32>,

    /// Where it goes; the extension names the format (.nff .toml .ply), `-` is the standard output
    /// (NFF) [default: WHAT.nff, in the current folder].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// How it is written, whatever the extension is.
    #[arg(long, value_name = "FORMAT")]
    pub format: Option<Form>,

    /// The objects with their materials only, without view, lights and background, to go into a
    /// scene of one's own.
    #[arg(long)]
    pub bare: bool,

    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
}

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
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<Size>,

    /// More notches of every knob, a finer reference, and more repetitions; takes as long as it takes.
    #[arg(long)]
    pub full: bool,

    /// End by then, as in 30s, 5m or 1h 30m; what there is no time for is left out, and told [default: 50s;
    /// with --full none].
    #[arg(long, value_name = "TIME", value_parser = humantime::parse_duration)]
    pub time_limit: Option<Duration>,

    /// Threads [default: one for each core].
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,

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

/// Of what there is a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Schema {
    /// Scenes in TOML.
    Scene,
    /// What a study has found: study.json.
    Study,
}

/// Which page.
#[derive(Debug, Parser)]
pub struct ManArgs {
    /// Of this command, with its options [default: of the program].
    pub command: Option<String>,
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

fn pixel(text: &str) -> Result<Pixel, String> {
    let parts = text.split_once(',').and_then(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?)));
    let Some((x, y)) = parts else {
        return Err("two whole numbers with a comma between them are expected, as in 320,240".into());
    };
    Ok(Pixel { x, y })
}

fn sample(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|number| *number >= 1).ok_or_else(|| "a whole number from 1 is expected".into())
}

fn region(text: &str) -> Result<Tile, String> {
    let wrong = || "X,Y,WxH is expected, as in 100,50,320x200".to_string();
    let mut words = text.splitn(3, ',');
    let mut next = || words.next().ok_or_else(wrong);
    let (x, y, size) = (next()?, next()?, next()?);
    let (width, height) = size.split_once(['x', 'X']).ok_or_else(wrong)?;
    let number = |text: &str| text.parse::<u32>().map_err(|_| wrong());
    let (x, y, width, height) = (number(x)?, number(y)?, number(width)?, number(height)?);
    match Size::new(width, height) {
        Some(_) => Ok(Tile { first: Pixel { x, y }, width, height }),
        None => Err(format!("each side must be between 1 and {}", Size::MOST)),
    }
}

fn heap(text: &str) -> Result<usize, String> {
    one_of(&HEAPS, text)
}

fn mailbox(text: &str) -> Result<usize, String> {
    one_of(&MAILBOXES, text)
}

/// One of some sizes for which the program was built.
fn one_of(sizes: &[usize], text: &str) -> Result<usize, String> {
    let is_text = |size: &&usize| text.parse() == Ok(**size);
    sizes.iter().find(is_text).copied().ok_or_else(|| {
        let names: Vec<_> = sizes.iter().map(usize::to_string).collect();
        let (last, others) =
            names.split_last().map_or(("", &[][..]), |(last, others)| (last.as_str(), others));
        format!("{} or {last} is expected", others.join(", "))
    })
}

fn cutoff(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(cutoff) if cutoff >= 0.0 && cutoff <= 1.0 => Ok(cutoff),
        _ => share(text).map(|share| share as f32),
    }
}

fn share(text: &str) -> Result<f64, String> {
    let value = match text.split_once('/') {
        Some((part, whole)) => part.parse::<f64>().and_then(|part| Ok(part / whole.parse::<f64>()?)),
        None => text.parse::<f64>(),
    };
    match value {
        Ok(share) if share >= 0.0 && share <= 1.0 => Ok(share),
        _ => Err("a number between 0 and 1 is expected, as in 0.01 or 1/255".into()),
    }
}

fn error(text: &str) -> Result<f64, String> {
    share(text)
        .ok()
        .filter(|error| *error > 0.0)
        .ok_or_else(|| "a number more than 0 and at most 1 is expected, as in 0.01 or 2/255".into())
}

fn duration(text: &str) -> Result<Duration, String> {
    // A number alone is one of seconds.
    let seconds = text.parse::<f64>().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    let time = seconds.or_else(|| humantime::parse_duration(text).ok()).filter(|time| !time.is_zero());
    time.ok_or_else(|| "a time is expected, as in 2s, 500ms or 1m 30s".into())
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(threads) if (1..=1024).contains(&threads) => Ok(threads),
        _ => Err("a whole number between 1 and 1024 is expected".into()),
    }
}
