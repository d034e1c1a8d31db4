//! What went wrong, and the exit status that says so.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use strahl_engine::Interrupt;
use strahl_picture::FormatError;
use strahl_scene::{Diagnostics, LoadError};
use strahl_settings::SettingsError;

/// How a command ends in which nothing went wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Or there was no question.
    Yes,
    /// Two pictures differ, a check does not hold.
    No,
    /// It would have gone on without end, and was ended.
    Ended(Interrupt),
}

impl Answer {
    /// The exit status.
    pub fn status(self) -> u8 {
        match self {
            Answer::Yes => 0,
            Answer::No => 1,
            Answer::Ended(stop) => status(stop),
        }
    }
}

/// Why a command did not do what it was asked for.
#[derive(Debug)]
pub enum Failure {
    /// The command line asks for what cannot be.
    Usage(String),
    /// A scene, or another input, is wrong; at which line, when it has one.
    Input {
        /// The file.
        path: PathBuf,
        /// Counted from 1.
        line: Option<usize>,
        /// What is wrong there.
        reason: String,
    },
    /// A scene is wrong, at all of these places.
    Diagnostics(Box<Diagnostics>),
    /// An input cannot be read.
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// An output cannot be written.
    Unwritable {
        /// The file; none is the standard output.
        path: Option<PathBuf>,
        /// What the system says.
        error: io::Error,
    },
    /// Stopped from outside before it was done, with nothing written.
    Stopped(Interrupt),
    /// Stopped from outside in the middle of a stream.
    StoppedAmid(Interrupt),
    /// The time that was given does not suffice, and what would: it may be tried again with that.
    Late(String),
}

impl Failure {
    /// A wrong input as a whole.
    pub fn input(path: &Path, reason: impl Into<String>) -> Self {
        Failure::Input { path: path.to_owned(), line: None, reason: reason.into() }
    }

    /// A wrong input at a line.
    pub fn at(path: &Path, line: usize, reason: impl Into<String>) -> Self {
        Failure::Input { path: path.to_owned(), line: Some(line), reason: reason.into() }
    }

    /// The exit status, after `sysexits.h` where that has one.
    pub fn status(&self) -> u8 {
        match self {
            Failure::Usage(_) => 2,
            Failure::Input { .. } | Failure::Diagnostics(_) => 65,
            Failure::Unreadable { .. } => 66,
            Failure::Unwritable { .. } => 74,
            Failure::Stopped(stop) | Failure::StoppedAmid(stop) => status(*stop),
            Failure::Late(_) => status(Interrupt::TimeLimit),
        }
    }
}

/// The exit status of a command that was stopped.
fn status(interrupt: Interrupt) -> u8 {
    match interrupt {
        Interrupt::Interrupted => 130,
        Interrupt::Terminated | Interrupt::Outdated | Interrupt::TimeLimit => 75,
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Usage(reason) | Failure::Late(reason) => write!(f, "{reason}"),
            Failure::Input { path, line: Some(line), reason } => {
                write!(f, "{}:{line}: {reason}", path.display())
            }
            Failure::Input { path, line: None, reason } => write!(f, "{}: {reason}", path.display()),
            Failure::Diagnostics(diagnostics) => diagnostics.fmt(f),
            Failure::Unreadable { path, error } => write!(f, "cannot read {}: {error}", path.display()),
            Failure::Unwritable { path: Some(path), error } => {
                write!(f, "cannot write {}: {error}", path.display())
            }
            Failure::Unwritable { path: None, error } => {
                write!(f, "cannot write to the standard output: {error}")
            }
            Failure::Stopped(stop) => write!(f, "{stop}; nothing was written"),
            Failure::StoppedAmid(stop) => write!(f, "{stop}; there is more to come"),
        }
    }
}

impl std::error::Error for Failure {}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Self {
        match error {
            LoadError::Unreadable { path, error } => Failure::Unreadable { path, error },
            LoadError::Invalid { path, line, reason } => Failure::Input { path, line, reason },
            LoadError::Diagnostics(diagnostics) => Failure::Diagnostics(diagnostics),
            error => Failure::Usage(error.to_string()),
        }
    }
}

impl From<SettingsError> for Failure {
    fn from(error: SettingsError) -> Self {
        Failure::Usage(error.to_string())
    }
}

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        Failure::Usage(error.to_string())
    }
}
