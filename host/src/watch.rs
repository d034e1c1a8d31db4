//! The command `watch`: a picture that follows its scene.
//!
//! The folders of all files that the scene and the mask were loaded from are watched, because editors
//! do not write into a file but put another in its place, and because a file that is missing may come.
//! What happens there only wakes the program: whether the scene has changed is seen from the
//! files themselves, so nothing is done twice, and nothing is missed that happened meanwhile.

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
use crate::failure::Failure;
use crate::output::{complain, say};
use crate::render::Job;
use crate::signals::Signals;

/// How long nothing must happen before files are taken for whole.
const QUIET: Duration = Duration::from_millis(50);
/// After this time they are read although there is no quiet.
const PATIENCE: Duration = Duration::from_secs(2);
/// How often signals are looked for while nothing happens.
const HEARTBEAT: Duration = Duration::from_millis(100);
/// How often files are looked at where the system does not tell of changes.
const POLL: Duration = Duration::from_millis(500);

/// Renders a scene at every change, until a signal comes.
pub fn run(args: &RenderArgs) -> Result<Interrupt, Failure> {
    if args.output.as_deref() == Some(Path::new("-")) {
        return Err(Failure::Usage("a picture that follows its scene needs a file, not `-`".into()));
    }
    if args.mask.as_deref() == Some(Path::new("-")) {
        return Err(Failure::Usage("a mask that is followed needs a file, not `-`".into()));
    }
    // Those that the command line names.
    let named: Vec<&PathBuf> = iter::once(&args.scene).chain(&args.mask).collect();
    for file in &named {
        if std::fs::metadata(file).is_ok_and(|found| !found.is_file()) {
            return Err(Failure::Usage(format!("{} is no file, so it has no changes", file.display())));
        }
    }
    let job = Job::of(args)?;
    let signals = Signals::listen()?;
    let progress = job.progress(signals.clone());
    let mut changes = Changes::new(&signals)?;
    let mut is_first = true;
    loop {
        signals.outdated().store(false, Ordering::Relaxed);
        let files = SourceFiles::tracked();
        let loaded = job.load(&files);
        changes.follow(&files.tracked_paths())?;
        if is_first && !args.quiet {
            say(format_args!("watching {} and what it names; Ctrl-C ends", args.scene.display()));
        }
        let done = loaded.and_then(|scene| {
            job.draft(&scene, &progress)?;
            job.render(&scene, &progress).map(|_| ())
        });
        let is_done = match done {
            Ok(()) => true,
            Err(Failure::Stopped(Interrupt::Outdated)) => false,
            Err(Failure::Stopped(stop)) => return Ok(stop),
            // A name that was never there is a slip of the command line.
            Err(Failure::Unreadable { path, error })
                if is_first && named.contains(&&path) && !path.exists() =>
            {
                return Err(Failure::Unreadable { path, error });
            }
            Err(failure @ (Failure::Input { .. } | Failure::Diagnostics(_) | Failure::Unreadable { .. })) => {
                complain(&failure);
                true
            }
            Err(failure) => return Err(failure),
        };
        is_first = false;
        if !is_done {
            changes.settle();
            continue;
        }
        while files.unchanged() {
            if let Err(stop) = changes.wait(&signals) {
                return Ok(stop);
            }
        }
    }
}

/// News of files.
struct Changes {
    watcher: Box<dyn Watcher>,
    folders: BTreeSet<PathBuf>,
    /// The files, by every name under which the system may tell of them.
    followed: Arc<Mutex<BTreeSet<PathBuf>>>,
    news: Receiver<()>,
}

impl Changes {
    /// Of no file yet; work is told by `signals` that it has become useless.
    fn new(signals: &Signals) -> Result<Self, Failure> {
        let (sender, news) = mpsc::channel();
        let followed = Arc::new(Mutex::new(BTreeSet::<PathBuf>::new()));
        let (outdated, names) = (signals.outdated(), Arc::clone(&followed));
        let tell = move |event: notify::Result<Event>| {
            let is_news = match &event {
                Ok(event) => {
                    let names = names.lock().unwrap_or_else(PoisonError::into_inner);
                    let is_followed = |path: &PathBuf| names.iter().any(|name| name.starts_with(path));
                    changes_content(&event.kind)
                        && (event.paths.is_empty() || event.paths.iter().any(is_followed))
                }
                // Something may have been missed.
                Err(_) => true,
            };
            if is_news {
                outdated.store(true, Ordering::Relaxed);
                // Nobody listens any more when the program ends.
                let _ = sender.send(());
            }
        };
        let watcher: notify::Result<Box<dyn Watcher>> =
            match RecommendedWatcher::new(tell.clone(), Config::default()) {
                Ok(watcher) => Ok(Box::new(watcher)),
                Err(_) => PollWatcher::new(tell, Config::default().with_poll_interval(POLL))
                    .map(|watcher| Box::new(watcher) as Box<dyn Watcher>),
            };
        let watcher = watcher.map_err(|error| Failure::Usage(format!("cannot watch files: {error}")))?;
        Ok(Changes { watcher, folders: BTreeSet::new(), followed, news })
    }

    /// From now on of these.
    fn follow(&mut self, files: &[PathBuf]) -> Result<(), Failure> {
        let mut names = BTreeSet::new();
        for file in files {
            names.extend(std::path::absolute(file));
            names.extend(std::fs::canonicalize(file));
        }
        let folders: BTreeSet<PathBuf> = names.iter().filter_map(|name| folder_of(name)).collect();
        *self.followed.lock().unwrap_or_else(PoisonError::into_inner) = names;
        for old in self.folders.difference(&folders) {
            // It may be gone.
            let _ = self.watcher.unwatch(old);
        }
        for folder in &folders {
            // Each time anew: it may have been replaced by another of the same name.
            self.watcher.watch(folder, RecursiveMode::NonRecursive).map_err(|error| Failure::Unreadable {
                path: folder.clone(),
                error: io::Error::other(error),
            })?;
        }
        self.folders = folders;
        Ok(())
    }

    /// Waits for news and then for quiet; `Err` once a signal has come.
    fn wait(&mut self, signals: &Signals) -> Result<(), Interrupt> {
        loop {
            match signals.check() {
                Ok(()) | Err(Interrupt::Outdated) => {}
                Err(stop) => return Err(stop),
            }
            match self.news.recv_timeout(HEARTBEAT) {
                Ok(()) => break,
                Err(RecvTimeoutError::Timeout) => {}
                // The watcher lives as long as this.
                Err(RecvTimeoutError::Disconnected) => std::thread::sleep(HEARTBEAT),
            }
        }
        self.settle();
        Ok(())
    }

    /// Waits for quiet.
    fn settle(&mut self) {
        let start = Instant::now();
        while self.news.recv_timeout(QUIET).is_ok() && start.elapsed() < PATIENCE {}
    }
}

/// Whether files may have other content after it.
fn changes_content(kind: &EventKind) -> bool {
    match kind {
        EventKind::Access(AccessKind::Close(AccessMode::Write)) => true,
        EventKind::Access(_) | EventKind::Modify(ModifyKind::Metadata(_)) => false,
        _ => true,
    }
}

/// The folder in which a file is, or would come to be by way of other folders.
fn folder_of(file: &Path) -> Option<PathBuf> {
    file.ancestors().skip(1).find(|folder| folder.is_dir()).map(Path::to_owned)
}
