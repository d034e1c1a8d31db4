//! The command `study`: accuracy against rendering time.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fs, io, iter};

use indicatif::{ProgressBar, ProgressStyle};
use strahl_engine::{Interrupt, Progress, RenderError};
use strahl_scene::description::LoadedScene;
use strahl_scene::{SourceFiles, load_from};
use strahl_settings::DEFAULT_SIZE;
use strahl_study::device::DeviceMeasurements;
use strahl_study::error::{ParseError, StudyError};
use strahl_study::measure::benchmark::StudyProgress;
use strahl_study::page;
use strahl_study::record::{Study, table};
use strahl_study::study::{StudySettings, stem, study};

use crate::args::StudyArgs;
use crate::error::CommandError;
use crate::output::{Output, OutputGuard, print_message, print_stderr};
use crate::signals::Signals;
use crate::word_wrap::{stderr_width, wrapped};

/// Runs a study, or writes the report of an existing one.
pub fn run(args: &StudyArgs) -> Result<(), CommandError> {
    let device = args
        .device
        .as_deref()
        .map(|path| read(path, |bytes| DeviceMeasurements::parse(&name_of(path), bytes)))
        .transpose()?;
    match (&args.scene, &args.from) {
        (_, Some(file)) => {
            let study = read(file, Study::parse)?;
            let place = args.output.clone().unwrap_or_else(|| folder_of(file));
            let guard = OutputGuard::of(iter::once(file).chain(&args.device));
            // The page links to study.json next to it. An existing file is replaced only with an explicit output folder.
            let copy = place.join("study.json");
            let is_same = fs::canonicalize(&copy).ok() == fs::canonicalize(file).ok();
            let is_copied = !is_same && (args.output.is_some() || !copy.exists());
            let names = ["report.html", "study.csv", "study.json"];
            let mut folder = Folder::prepare(&place, guard, &names[..if is_copied { 3 } else { 2 }])?;
            folder.write("study.json", study.to_json().as_bytes())?;
            folder.write("report.html", page::page(&study, device.as_ref()).as_bytes())?;
            folder.write("study.csv", table::to_csv(&study).as_bytes())?;
            args.print_stderr(&format!("{}\n", folder.path.join("report.html").display()));
            Ok(())
        }
        (Some(path), None) => {
            let signals = Signals::register()?;
            let begun = Instant::now();
            let files = SourceFiles::on_disk();
            let scene = load(&files, path, args)?;
            // Outputs are opened before measuring starts.
            let guard = OutputGuard::of(files.named_paths().iter().chain(&args.device));
            let folder = args.output.clone().unwrap_or_else(|| folder_for(path));
            let mut folder = Folder::prepare(&folder, guard, &["study.json", "study.csv", "report.html"])?;
            let meter = if args.quiet { Meter::silent(signals) } else { Meter::on_terminal(signals) };
            let settings = StudySettings {
                size: args.size,
                full: args.full,
                time_limit: args.time_limit,
                threads: args.settings.given.threads,
                start: begun,
            };
            let study = study(path, &scene, &settings, &meter);
            meter.end();
            let study = study.map_err(|error| failure(path, error))?;
            folder.write("study.json", study.to_json().as_bytes())?;
            folder.write("study.csv", table::to_csv(&study).as_bytes())?;
            folder.write("report.html", page::page(&study, device.as_ref()).as_bytes())?;
            args.print_stderr(&page::summary(&study, &folder.path.join("report.html")));
            Ok(())
        }
        (None, None) => Err(CommandError::Usage("a scene or --from is required".into())),
    }
}

/// Loads the scene and prints its warnings.
fn load(files: &SourceFiles, path: &Path, args: &StudyArgs) -> Result<LoadedScene, CommandError> {
    let scene = load_from(files, path, args.size.unwrap_or(DEFAULT_SIZE))?;
    for warning in scene.warnings.iter().filter(|_| !args.quiet) {
        print_message(format_args!("{}: warning: {warning}", path.display()));
    }
    Ok(scene)
}

/// Reads and parses a file.
fn read<T>(path: &Path, parse: impl FnOnce(&[u8]) -> Result<T, ParseError>) -> Result<T, CommandError> {
    let bytes = fs::read(path).map_err(|error| CommandError::Unreadable { path: path.to_owned(), error })?;
    parse(&bytes).map_err(|ParseError { line, reason }| CommandError::InvalidInput {
        path: path.to_owned(),
        line,
        reason,
    })
}

/// Why the scene at `path` could not be studied.
fn failure(path: &Path, error: StudyError) -> CommandError {
    match error {
        StudyError::Settings(error) => error.into(),
        StudyError::Render(RenderError::Interrupted(interrupt)) => CommandError::Stopped(interrupt),
        StudyError::TooShort(reason) => {
            CommandError::TimeLimitTooShort(format!("{}: {reason}", path.display()))
        }
        StudyError::Picture(error) => CommandError::Unwritable { path: None, error: io::Error::other(error) },
        error => CommandError::input(path, error.to_string()),
    }
}

/// A bar over the time that a study is expected to take.
struct Meter {
    signals: Signals,
    bar: ProgressBar,
    /// Width of the message after the bar.
    room: usize,
}

/// Parts of the bar.
const PARTS: u64 = 1000;

impl Meter {
    /// Shows nothing, and stops only for `signals`.
    fn silent(signals: Signals) -> Self {
        Meter { signals, bar: ProgressBar::hidden(), room: 0 }
    }

    /// Shows a bar on the standard error, if that is a terminal.
    fn on_terminal(signals: Signals) -> Self {
        let bar = ProgressBar::new(PARTS);
        let width = stderr_width();
        let length = width.saturating_sub(70).clamp(8, 32);
        let template = format!("{{bar:{length}}} {{percent:>3}} %  {{prefix}}  {{msg}}");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style.progress_chars("━━─"));
        }
        bar.enable_steady_tick(Duration::from_millis(200));
        Meter { signals, bar, room: width.saturating_sub(length + 24) }
    }

    /// Removes the bar.
    fn end(&self) {
        self.bar.disable_steady_tick();
        self.bar.finish_and_clear();
    }
}

impl Progress for Meter {
    fn check(&self) -> Result<(), Interrupt> {
        self.signals.check()
    }
}

impl StudyProgress for Meter {
    fn measuring(&self, setting: &str) {
        let short: String = setting.replace("--", "").chars().take(self.room).collect();
        self.bar.set_message(short);
    }

    fn time(&self, elapsed: f64, left: f64) {
        let whole = elapsed + left.max(0.0);
        self.bar.set_position((PARTS as f64 * elapsed / whole.max(1e-9)) as u64);
        self.bar.set_prefix(if left < 100.0 {
            format!("{:.0} s left", left.max(0.0))
        } else {
            format!("{:.0} min left", (left / 60.0).ceil())
        });
    }
}

/// Output folder of a study. Folders created for it are removed on drop if they are empty.
struct Folder {
    path: PathBuf,
    /// The files that are still to be written there.
    files: HashMap<&'static str, Output>,
    /// Created folders, the innermost first.
    made: Vec<PathBuf>,
}

impl Folder {
    /// Creates the folder if it is missing, and opens these files in it.
    fn prepare(path: &Path, mut guard: OutputGuard, names: &[&'static str]) -> Result<Self, CommandError> {
        let unwritable = |error| CommandError::Unwritable { path: Some(path.to_owned()), error };
        let is_new = |folder: &&Path| *folder != Path::new("") && !folder.exists();
        let made = path.ancestors().take_while(is_new).map(Path::to_owned).collect();
        let mut folder = Folder { path: path.to_owned(), files: HashMap::new(), made };
        fs::create_dir_all(path).map_err(unwritable)?;
        for name in names {
            folder.files.insert(name, guard.prepare(&path.join(name))?);
        }
        Ok(folder)
    }

    /// Writes one of the files.
    fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), CommandError> {
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
    /// Prints text to standard error, unless `--quiet` is given.
    fn print_stderr(&self, text: &str) {
        if !self.quiet {
            print_stderr(wrapped(text, stderr_width(), page::INDENT));
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

fn name_of(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}
