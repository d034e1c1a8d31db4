//! The command `study`: what accuracy costs in time.
//!
//! A scene is rendered over a plan of settings, each held against a reference of high quality.
//! The folder that comes of it has a page to look at (`report.html`), the runs as a table
//! (`study.csv`) and everything as it was measured (`study.json`), of which the page can be made
//! again.
//!
//! | room | what it does |
//! |---|---|
//! | [`record`] | what was found, as `study.json` holds it |
//! | [`mod@file`] | `study.json`, written and read |
//! | [`plan`] | what is measured, and how much time each part may take |
//! | [`options`] | what is turned |
//! | `afford` | how large a picture there is time for |
//! | [`bench`](mod@bench) | one setting is measured |
//! | [`conduct`] | a study from its beginning to its end |
//! | `knobs` | knobs turned one by one |
//! | [`mix`] | which mixtures are worth a measurement |
//! | `mixtures` | they are measured |
//! | `techniques` | techniques on and off |
//! | [`statistics`] | medians and spreads |
//! | [`front`](mod@front) | the Pareto front, and what it recommends |
//! | [`meter`] | how far it is |
//! | [`machine`] | where it was measured |
//! | [`images`] | pictures of it |
//! | [`table`] | `study.csv` |
//! | [`device`] | what firmware has measured |
//! | [`page`] | `report.html` |

use std::collections::HashMap;
use std::ffi::OsStr;
use std::fs;
use std::iter;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use strahl_core::Size;

use crate::args::StudyArgs;
use crate::cost::WEIGHTS;
use crate::description::{Description, Settings};
use crate::engine::session::scene_stats;
use crate::failure::Failure;
use crate::load::{Files, load_from};
use crate::output::{Guard, Output, say, tell};
use crate::plan::Effect;
use crate::signals::Signals;
use crate::stock::single::Stock;
use crate::wanted::{DEFAULT_SIZE, Wanted};
use crate::wrap::{width_of_stderr, wrapped};
use afford::smaller;
use bench::Bench;
use conduct::Conduct;
use device::Device;
use meter::Meter;
use options::Options;
use plan::Plan;
use record::Study;

mod afford;
pub mod bench;
pub mod conduct;
pub mod device;
pub mod file;
pub mod front;
pub mod images;
mod knobs;
pub mod machine;
pub mod meter;
pub mod mix;
mod mixtures;
pub mod options;
pub mod page;
pub mod plan;
pub mod record;
pub mod statistics;
pub mod table;
mod techniques;

/// The time that a quick study takes.
const QUICK: Duration = Duration::from_secs(50);

/// A study is of at most so many pixels where nobody names a size: what a setting costs and what it
/// makes wrong is much the same for a larger picture.
const PIXELS: u32 = 1 << 16;

/// Studies a scene, or makes the page of a study again.
pub fn run(args: &StudyArgs) -> Result<(), Failure> {
    let device = args.device.as_deref().map(Device::read).transpose()?;
    match (&args.scene, &args.from) {
        (_, Some(file)) => {
            let study = Study::read(file)?;
            let place = args.output.clone().unwrap_or_else(|| folder_of(file));
            let guard = Guard::of(iter::once(file).chain(&args.device));
            // The page says that the numbers are beside it. What is there already is not replaced unless that is
            // asked for.
            let copy = place.join("study.json");
            let is_same = fs::canonicalize(&copy).ok() == fs::canonicalize(file).ok();
            let is_copied = !is_same && (args.output.is_some() || !copy.exists());
            let names = ["report.html", "study.csv", "study.json"];
            let mut folder = Folder::prepare(&place, guard, &names[..if is_copied { 3 } else { 2 }])?;
            folder.write("study.json", study.to_json().as_bytes())?;
            folder.write("report.html", page::page(&study, device.as_ref()).as_bytes())?;
            folder.write("study.csv", table::table(&study).as_bytes())?;
            args.tell(&format!("{}\n", folder.path.join("report.html").display()));
            Ok(())
        }
        (Some(path), None) => {
            let signals = Signals::listen()?;
            let begun = Instant::now();
            let files = Files::on_disk();
            let scene = load(&files, path, args)?;
            // Before the work, so that nothing is measured that cannot be kept.
            let guard = Guard::of(files.named().iter().chain(&args.device));
            let folder = args.output.clone().unwrap_or_else(|| folder_for(path));
            let mut folder = Folder::prepare(&folder, guard, &["study.json", "study.csv", "report.html"])?;
            let study = study(path, &scene, args, signals, begun)?;
            folder.write("study.json", study.to_json().as_bytes())?;
            folder.write("study.csv", table::table(&study).as_bytes())?;
            folder.write("report.html", page::page(&study, device.as_ref()).as_bytes())?;
            args.tell(&page::summary(&study, &folder.path.join("report.html")));
            Ok(())
        }
        (None, None) => Err(Failure::Usage("a scene is missing, or --from study.json".into())),
    }
}

/// Loads the scene, and says what its user should know of.
fn load(files: &Files, path: &Path, args: &StudyArgs) -> Result<Description, Failure> {
    let scene = load_from(files, path, args.size.unwrap_or(DEFAULT_SIZE))?;
    for warning in scene.warnings.iter().filter(|_| !args.quiet) {
        say(format_args!("{}: warning: {warning}", path.display()));
    }
    Ok(scene)
}

/// Measures.
fn study(
    path: &Path,
    scene: &Description,
    args: &StudyArgs,
    signals: Signals,
    begun: Instant,
) -> Result<Study, Failure> {
    let (load, date) = (machine::load(), machine::now());
    let facts = {
        let stock = Stock::new(scene);
        scene_stats(scene, &stock.scene().map_err(|error| Failure::input(path, error.to_string()))?)
    };
    let asks: Vec<Effect> = Effect::ALL.into_iter().filter(|effect| effect.is_in(&facts.asks)).collect();

    let plan = if args.full { Plan::FULL } else { Plan::QUICK };
    let limit = args.time_limit.or((!args.full).then_some(QUICK));
    let full = args.size.unwrap_or_else(|| smaller(scene.settings.size.unwrap_or(DEFAULT_SIZE), PIXELS));
    let meter = if args.quiet { Meter::silent() } else { Meter::on_terminal() };
    // What loading takes is taken from the time, too.
    let meter = meter.since(begun);
    let mut bench = Bench::new(path, scene, full, signals, meter, limit);
    let own = own(scene, full, args.threads)?;
    afford::choose(&mut bench, &plan, &own, args.size.is_none()).inspect_err(|_| bench.meter.end())?;
    let size = bench.size;
    let mut conduct = Conduct::new(&bench, &plan);
    let found = conduct.run(&own, &asks).and_then(|truth| {
        let pictures = images::all(&conduct, &truth)?;
        Ok((truth, pictures))
    });
    bench.meter.end();
    let (truth, pictures) = found?;
    let seconds = bench.elapsed();
    let Conduct { taken, knobs, techniques, threads, left_out, beaten, .. } = conduct;
    let method = record::Method {
        program: format!("strahl {}", env!("CARGO_PKG_VERSION")),
        date,
        processor: machine::processor(),
        system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
        cores: machine::cores(),
        load,
        plan: plan.name.into(),
        time_limit: limit.map(|limit| limit.as_secs_f64()),
        size_with_more_time: (size != full).then(|| [full.width(), full.height()]),
        seconds,
        beaten,
        weights: WEIGHTS,
    };
    Ok(Study {
        format: record::FORMAT.into(),
        version: record::VERSION,
        scene: record::Scene {
            name: stem(path),
            file: path.display().to_string(),
            width: size.width(),
            height: size.height(),
            objects: facts.objects,
            triangles: facts.triangles,
            lights: facts.lights,
            effects: asks.iter().map(|effect| effect.name().into()).collect(),
        },
        method,
        reference: truth.reference,
        runs: taken.into_iter().map(|taken| taken.run).collect(),
        knobs,
        techniques,
        threads,
        left_out,
        pictures,
    })
}

/// The scene's own settings, where it has none the defaults.
fn own(scene: &Description, size: Size, threads: Option<usize>) -> Result<Options, Failure> {
    let asked = Settings { size: Some(size), ..Settings::default() };
    let wanted = Wanted::asked(&asked, &scene.settings).map_err(Failure::Usage)?;
    Ok(Options::of(&wanted, threads.unwrap_or_else(machine::cores)))
}

/// Where a study goes. What was made for it goes with this value, unless something is in it.
struct Folder {
    path: PathBuf,
    /// The files that are still to be written there.
    files: HashMap<&'static str, Output>,
    /// Folders that were not there before, the innermost first.
    made: Vec<PathBuf>,
}

impl Folder {
    /// Makes it, if it is not there, and makes sure that these files can be written in it.
    fn prepare(path: &Path, mut guard: Guard, names: &[&'static str]) -> Result<Self, Failure> {
        let unwritable = |error| Failure::Unwritable { path: Some(path.to_owned()), error };
        let is_new = |folder: &&Path| *folder != Path::new("") && !folder.exists();
        let made = path.ancestors().take_while(is_new).map(Path::to_owned).collect();
        let mut folder = Folder { path: path.to_owned(), files: HashMap::new(), made };
        fs::create_dir_all(path).map_err(unwritable)?;
        for name in names {
            folder.files.insert(name, guard.prepare(&path.join(name))?);
        }
        Ok(folder)
    }

    /// Lets one of the files appear.
    fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        self.files.remove(name).map_or(Ok(()), |output| output.commit(bytes))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // What was not written goes first; a folder with something in it is not removed.
        self.files.clear();
        self.made.iter().all(|folder| fs::remove_dir(folder).is_ok());
    }
}

impl StudyArgs {
    /// Tells a person.
    fn tell(&self, text: &str) {
        if !self.quiet {
            tell(wrapped(text, width_of_stderr(), page::INDENT));
        }
    }
}

/// The folder of a file.
fn folder_of(file: &Path) -> PathBuf {
    match file.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// The scene's name with `-study`, in the current folder.
fn folder_for(scene: &Path) -> PathBuf {
    PathBuf::from(format!("{}-study", stem(scene)))
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or(OsStr::new("scene")).to_string_lossy().into_owned()
}
