//! Files that are complete or absent.
//!
//! A file is written beside its place and renamed when it is whole. It is made before the work
//! begins, so that a place that cannot be written is told at once and not after an hour. It is the
//! [`Guard`] that makes it, so that nothing is replaced that the command reads.

mod guard;
mod screen;

use std::fmt;
use std::fs::{self, Permissions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use crate::failure::Failure;
pub use guard::Guard;

/// A place for one output.
#[derive(Debug)]
pub enum Output {
    /// The standard output.
    Stdout,
    /// A file that appears when it is whole.
    File {
        /// As the user named it.
        name: PathBuf,
        /// Where it will be, links followed.
        place: PathBuf,
        /// Where it is being written. Gone with this value, unless it was kept.
        beside: NamedTempFile,
    },
    /// A device or a pipe, which cannot be replaced.
    Device {
        /// As the user named it.
        name: PathBuf,
        /// Open since the first part was written: to open a pipe waits for its reader.
        open: Option<fs::File>,
    },
}

impl Output {
    /// Makes sure that `path` can be written; `-` is the standard output.
    fn prepare(path: &Path) -> Result<Self, Failure> {
        if path == Path::new("-") {
            return Ok(Output::Stdout);
        }
        let unwritable = |error| Failure::Unwritable { path: Some(path.to_owned()), error };
        let place = place_of(path);
        match fs::metadata(&place) {
            Ok(found) if found.is_dir() => {
                return Err(unwritable(io::Error::from(io::ErrorKind::IsADirectory)));
            }
            Ok(found) if !found.is_file() => return Ok(Output::Device { name: path.to_owned(), open: None }),
            Ok(found) if found.permissions().readonly() => {
                return Err(unwritable(io::Error::from(io::ErrorKind::PermissionDenied)));
            }
            _ => {}
        }
        let folder = folder_of(&place);
        if !folder.is_dir() {
            let reason = format!("there is no folder {}", folder.display());
            return Err(unwritable(io::Error::new(io::ErrorKind::NotFound, reason)));
        }
        let mut builder = Builder::new();
        builder.prefix(".strahl-");
        if let Some(permissions) = permissions(&place) {
            builder.permissions(permissions);
        }
        let beside = builder.tempfile_in(folder).map_err(unwritable)?;
        Ok(Output::File { name: path.to_owned(), place, beside })
    }

    /// Writes everything and lets the file appear.
    pub fn commit(mut self, bytes: &[u8]) -> Result<(), Failure> {
        self.write_all(bytes).map_err(|error| self.unwritable(error))?;
        self.finish()
    }

    /// The failure of a write.
    pub fn unwritable(&self, error: io::Error) -> Failure {
        let path = match self {
            Output::Stdout => None,
            Output::File { name, .. } | Output::Device { name, .. } => Some(name.clone()),
        };
        Failure::Unwritable { path, error }
    }

    /// Everything has been written: the file appears.
    pub fn finish(self) -> Result<(), Failure> {
        match self {
            Output::Stdout | Output::Device { .. } => Ok(()),
            Output::File { name, place, mut beside } => {
                let kept = beside.flush().and_then(|()| beside.persist(place).map_err(|kept| kept.error));
                kept.map(|_| ()).map_err(|error| Failure::Unwritable { path: Some(name), error })
            }
        }
    }
}

/// Bytes for the standard output or a device are written through at once.
impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Output::Stdout => {
                let mut out = io::stdout().lock();
                out.write_all(bytes).and_then(|()| out.flush())?;
            }
            Output::Device { name, open } => {
                let file = match open.take() {
                    Some(file) => file,
                    None => fs::OpenOptions::new().write(true).open(&*name)?,
                };
                open.insert(file).write_all(bytes)?;
            }
            Output::File { beside, .. } => beside.write_all(bytes)?,
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Refuses to write `what`, which is no text, to a terminal: `path` is `-` and the standard output one.
pub fn refuse_terminal(path: &Path, what: &str) -> Result<(), Failure> {
    if path == Path::new("-") && io::stdout().is_terminal() {
        return Err(Failure::Usage(format!("{what} would go to the terminal; pipe it, or name a file")));
    }
    Ok(())
}

/// Says something on the standard error, after the program's name. That nobody can read it is no
/// failure; `eprintln!` would panic.
pub fn say(message: impl fmt::Display) {
    tell(format_args!("strahl: {message}\n"));
}

/// Says something on the standard error as it is. Colours are left out where it is no terminal,
/// and where `NO_COLOR` is set.
pub fn tell(message: impl fmt::Display) {
    let _ = write!(anstream::stderr(), "{message}");
}

/// Says on the standard error why a command failed: what is wrong in a scene as its screen can
/// show it.
pub fn complain(failure: &Failure) {
    match failure {
        Failure::Diagnostics(diagnostics) => {
            tell(format_args!("{}\n", diagnostics.render(screen::of_stderr())))
        }
        _ => say(failure),
    }
}

/// Where a file is, or would be. The file behind a link is meant, not the link.
fn place_of(path: &Path) -> PathBuf {
    let new = || Some(fs::canonicalize(folder_of(path)).ok()?.join(path.file_name()?));
    fs::canonicalize(path).ok().or_else(new).unwrap_or_else(|| path.to_owned())
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Those of the file that is replaced, or what any new file gets here.
#[cfg(unix)]
fn permissions(place: &Path) -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    let old = fs::metadata(place).ok().map(|found| found.permissions());
    Some(old.unwrap_or_else(|| Permissions::from_mode(0o666)))
}

#[cfg(not(unix))]
fn permissions(_: &Path) -> Option<Permissions> {
    None
}
