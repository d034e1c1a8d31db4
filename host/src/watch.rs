//! The command `watch`: renders a scene again whenever one of its files changes.
//!
//! The folders of all files of the scene and of the mask are watched, because editors replace a file instead of
//! writing into it, and because a missing file may be created. An event only wakes the program: whether the
//! scene has changed is decided from the contents of the files, so no change is rendered twice or missed.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use std::{io, iter};

use notify::event::{AccessKind, AccessMode, EventKind, ModifyKind};
use notify::{Config, Event, PollWatcher, RecommendedWatcher, RecursiveMode, Watcher};
use strahl_engine::{Interrupt, Progress as _};
use strahl_scene::SourceFiles;

use crate::args::RenderArgs;
use crate::error::CommandError;
use crate::output::{print_error, print_message};
use crate::render::RenderJob;
use crate::signals::Signals;

/// Time without events after which files are read.
const DEBOUNCE: Duration = Duration::from_millis(50);
/// Time after which files are read although events continue.
const MAX_DEBOUNCE: Duration = Duration::from_secs(2);
/// Interval of signal checks.
const SIGNAL_POLL_INTERVAL: Duration = Duration::from_millis(100);
/// Interval of file checks if the system does not report changes.
const FILE_POLL_INTERVAL: Duration = Duration::from_millis(500);

/// Renders a scene at every change until a signal arrives, which is returned.
pub fn run(args: &RenderArgs) -> Result<Interrupt, CommandError> {
    if args.output.as_deref() == Some(Path::new("-")) {
        return Err(CommandError::Usage("watch needs an output file, not `-`".into()));
    }
    if args.mask.as_deref() == Some(Path::new("-")) {
        return Err(CommandError::Usage("watch needs a mask file, not `-`".into()));
    }
    // Files named on the command line.
    let named: Vec<&PathBuf> = iter::once(&args.scene).chain(&args.mask).collect();
    for file in &named {
        if std::fs::metadata(file).is_ok_and(|found| !found.is_file()) {
            return Err(CommandError::Usage(format!(
                "{} is not a regular file and cannot be watched",
                file.display()
            )));
        }
    }
    let job = RenderJob::new(args)?;
    let signals = Signals::register()?;
    let progress = job.progress(signals.clone());
    let mut changes = SceneWatcher::new(&signals)?;
    let mut is_first = true;
    loop {
        signals.scene_changed().store(false, Ordering::Relaxed);
        let files = SourceFiles::tracked();
        let loaded = job.load(&files);
        changes.set_paths(&files.tracked_paths())?;
        if is_first && !args.quiet {
            print_message(format_args!(
                "watching {} and the files it references; press Ctrl-C to stop",
                args.scene.display()
            ));
        }
        let done = loaded.and_then(|scene| {
            job.write_preview(&scene, &progress)?;
            job.render_and_write(&scene, &progress).map(|_| ())
        });
        let is_done = match done {
            Ok(()) => true,
            Err(CommandError::Stopped(Interrupt::Outdated)) => false,
            Err(CommandError::Stopped(stop)) => return Ok(stop),
            // A file that is missing at the start is a usage error.
            Err(CommandError::Unreadable { path, error })
                if is_first && named.contains(&&path) && !path.exists() =>
            {
                return Err(CommandError::Unreadable { path, error });
            }
            Err(
                failure @ (CommandError::InvalidInput { .. }
                | CommandError::Diagnostics(_)
                | CommandError::Unreadable { .. }),
            ) => {
                print_error(&failure);
                true
            }
            Err(failure) => return Err(failure),
        };
        is_first = false;
        if !is_done {
            changes.debounce();
            continue;
        }
        while files.unchanged() {
            if let Err(stop) = changes.wait(&signals) {
                return Ok(stop);
            }
        }
    }
}

/// Watches the files of a scene.
struct SceneWatcher {
    watcher: Box<dyn Watcher>,
    folders: BTreeSet<PathBuf>,
    /// The files, by every path that the system may report.
    paths: Arc<Mutex<BTreeSet<PathBuf>>>,
    events: Receiver<()>,
}

impl SceneWatcher {
    /// Watches no file yet. A change sets the flag `scene_changed` of `signals`.
    fn new(signals: &Signals) -> Result<Self, CommandError> {
        let (sender, events) = mpsc::channel();
        let paths = Arc::new(Mutex::new(BTreeSet::<PathBuf>::new()));
        let (scene_changed, names) = (signals.scene_changed(), Arc::clone(&paths));
        let on_event = move |event: notify::Result<Event>| {
            let is_change = match &event {
                Ok(event) => {
                    let names = names.lock().unwrap_or_else(PoisonError::into_inner);
                    let is_watched = |path: &PathBuf| names.iter().any(|name| name.starts_with(path));
                    changes_content(&event.kind)
                        && (event.paths.is_empty() || event.paths.iter().any(is_watched))
                }
                // An event may have been lost.
                Err(_) => true,
            };
            if is_change {
                scene_changed.store(true, Ordering::Relaxed);
                // The receiver is dropped on exit.
                let _ = sender.send(());
            }
        };
        let watcher: notify::Result<Box<dyn Watcher>> =
            match RecommendedWatcher::new(on_event.clone(), Config::default()) {
                Ok(watcher) => Ok(Box::new(watcher)),
                Err(_) => {
                    PollWatcher::new(on_event, Config::default().with_poll_interval(FILE_POLL_INTERVAL))
                        .map(|watcher| Box::new(watcher) as Box<dyn Watcher>)
                }
            };
        let watcher = watcher.map_err(|error| CommandError::Usage(format!("cannot watch files: {error}")))?;
        Ok(SceneWatcher { watcher, folders: BTreeSet::new(), paths, events })
    }

    /// Watches these files instead.
    fn set_paths(&mut self, files: &[PathBuf]) -> Result<(), CommandError> {
        let mut names = BTreeSet::new();
        for file in files {
            names.extend(std::path::absolute(file));
            names.extend(std::fs::canonicalize(file));
        }
        let folders: BTreeSet<PathBuf> = names.iter().filter_map(|name| folder_of(name)).collect();
        *self.paths.lock().unwrap_or_else(PoisonError::into_inner) = names;
        for old in self.folders.difference(&folders) {
            // The folder may have been removed.
            let _ = self.watcher.unwatch(old);
        }
        for folder in &folders {
            // Every time: the folder may have been replaced by another of the same name.
            self.watcher.watch(folder, RecursiveMode::NonRecursive).map_err(|error| {
                CommandError::Unreadable { path: folder.clone(), error: io::Error::other(error) }
            })?;
        }
        self.folders = folders;
        Ok(())
    }

    /// Waits for events until they stop; `Err` once a signal has arrived.
    fn wait(&mut self, signals: &Signals) -> Result<(), Interrupt> {
        loop {
            match signals.check() {
                Ok(()) | Err(Interrupt::Outdated) => {}
                Err(stop) => return Err(stop),
            }
            match self.events.recv_timeout(SIGNAL_POLL_INTERVAL) {
                Ok(()) => break,
                Err(RecvTimeoutError::Timeout) => {}
                // Cannot happen: the watcher holds the sender.
                Err(RecvTimeoutError::Disconnected) => std::thread::sleep(SIGNAL_POLL_INTERVAL),
            }
        }
        self.debounce();
        Ok(())
    }

    /// Waits until no event arrives for [`DEBOUNCE`].
    fn debounce(&mut self) {
        let start = Instant::now();
        while self.events.recv_timeout(DEBOUNCE).is_ok() && start.elapsed() < MAX_DEBOUNCE {}
    }
}

/// Whether the contents of files may have changed.
fn changes_content(kind: &EventKind) -> bool {
    match kind {
        EventKind::Access(AccessKind::Close(AccessMode::Write)) => true,
        EventKind::Access(_) | EventKind::Modify(ModifyKind::Metadata(_)) => false,
        _ => true,
    }
}

/// The innermost existing folder on the path of a file.
fn folder_of(file: &Path) -> Option<PathBuf> {
    file.ancestors().skip(1).find(|folder| folder.is_dir()).map(Path::to_owned)
}
