//! Files that are complete or absent.
//!
//! A file is written to a temporary file in the same folder, and renamed when it is complete. The temporary file is
//! created before the work starts, so that an output that cannot be written is reported at once. [`OutputGuard`]
//! creates it, so that no input is overwritten.

mod guard;
mod screen;

use std::fmt;
use std::fs::{self, Permissions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use crate::error::CommandError;
pub use guard::OutputGuard;

/// Target of one output.
#[derive(Debug)]
pub enum Output {
    /// The standard output.
    Stdout,
    /// A file that is renamed into target when it is complete.
    File {
        /// Path as given.
        name: PathBuf,
        /// Canonical path.
        target: PathBuf,
        /// The temporary file; removed when dropped, unless it was renamed.
        temporary: NamedTempFile,
    },
    /// A device or a pipe, which cannot be replaced.
    Device {
        /// Path as given.
        name: PathBuf,
        /// Opened by the first write, because opening a pipe waits for its reader.
        open: Option<fs::File>,
    },
}

impl Output {
    /// Opens an output at `path`; `-` is standard output.
    fn prepare(path: &Path) -> Result<Self, CommandError> {
        if path == Path::new("-") {
            return Ok(Output::Stdout);
        }
        let unwritable = |error| CommandError::Unwritable { path: Some(path.to_owned()), error };
        let target = canonical_path(path);
        match fs::metadata(&target) {
            Ok(found) if found.is_dir() => {
                return Err(unwritable(io::Error::from(io::ErrorKind::IsADirectory)));
            }
            Ok(found) if !found.is_file() => return Ok(Output::Device { name: path.to_owned(), open: None }),
            Ok(found) if found.permissions().readonly() => {
                return Err(unwritable(io::Error::from(io::ErrorKind::PermissionDenied)));
            }
            _ => {}
        }
        let folder = folder_of(&target);
        if !folder.is_dir() {
            let reason = format!("folder {} does not exist", folder.display());
            return Err(unwritable(io::Error::new(io::ErrorKind::NotFound, reason)));
        }
        let mut builder = Builder::new();
        builder.prefix(".strahl-");
        if let Some(permissions) = permissions(&target) {
            builder.permissions(permissions);
        }
        let temporary = builder.tempfile_in(folder).map_err(unwritable)?;
        Ok(Output::File { name: path.to_owned(), target, temporary })
    }

    /// Writes `bytes` and completes the file.
    pub fn commit(mut self, bytes: &[u8]) -> Result<(), CommandError> {
        self.write_all(bytes).map_err(|error| self.unwritable(error))?;
        self.finish()
    }

    /// The error of a failed write.
    pub fn unwritable(&self, error: io::Error) -> CommandError {
        let path = match self {
            Output::Stdout => None,
            Output::File { name, .. } | Output::Device { name, .. } => Some(name.clone()),
        };
        CommandError::Unwritable { path, error }
    }

    /// Completes the file: it is renamed to its final path.
    pub fn finish(self) -> Result<(), CommandError> {
        match self {
            Output::Stdout | Output::Device { .. } => Ok(()),
            Output::File { name, target, mut temporary } => {
                let renamed =
                    temporary.flush().and_then(|()| temporary.persist(target).map_err(|error| error.error));
                renamed.map(|_| ()).map_err(|error| CommandError::Unwritable { path: Some(name), error })
            }
        }
    }
}

/// Writes to standard output or a device are not buffered.
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
            Output::File { temporary, .. } => temporary.write_all(bytes)?,
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Returns an error if `what`, which is binary, would be written to a terminal.
pub fn refuse_terminal(path: &Path, what: &str) -> Result<(), CommandError> {
    if path == Path::new("-") && io::stdout().is_terminal() {
        return Err(CommandError::Usage(format!(
            "{what} would be written to the terminal; redirect it or name a file"
        )));
    }
    Ok(())
}

/// Prints a message to standard error, after the program's name. A closed standard error is ignored; `eprintln!`
/// would panic.
pub fn print_message(message: impl fmt::Display) {
    print_stderr(format_args!("strahl: {message}\n"));
}

/// Prints text to standard error. Colors are removed if it is not a terminal or `NO_COLOR` is set.
pub fn print_stderr(message: impl fmt::Display) {
    let _ = write!(anstream::stderr(), "{message}");
}

/// Prints the error of a command to standard error; errors of a scene with excerpts of its source.
pub fn print_error(failure: &CommandError) {
    match failure {
        CommandError::Diagnostics(diagnostics) => {
            print_stderr(format_args!("{}\n", diagnostics.render(screen::of_stderr())))
        }
        _ => print_message(failure),
    }
}

/// The canonical path of a file, existing or not; links are followed.
fn canonical_path(path: &Path) -> PathBuf {
    let new = || Some(fs::canonicalize(folder_of(path)).ok()?.join(path.file_name()?));
    fs::canonicalize(path).ok().or_else(new).unwrap_or_else(|| path.to_owned())
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Permissions of the file that is replaced, or those of a new file.
#[cfg(unix)]
fn permissions(target: &Path) -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    let old = fs::metadata(target).ok().map(|found| found.permissions());
    Some(old.unwrap_or_else(|| Permissions::from_mode(0o666)))
}

#[cfg(not(unix))]
fn permissions(_: &Path) -> Option<Permissions> {
    None
}
