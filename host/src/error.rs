//! Result of a command, and its exit status.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use strahl_engine::Interrupt;
use strahl_picture::FormatError;
use strahl_scene::{Diagnostics, LoadError};
use strahl_settings::SettingsError;

/// Outcome of a command without an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommandStatus {
    /// Done; a check succeeded, if any.
    Success,
    /// Two pictures differ, or a target error is not reached.
    CheckFailed,
    /// A command without an end, as `watch`, was stopped.
    Stopped(Interrupt),
}

impl CommandStatus {
    /// The exit status.
    pub fn status(self) -> u8 {
        match self {
            CommandStatus::Success => 0,
            CommandStatus::CheckFailed => 1,
            CommandStatus::Stopped(stop) => status(stop),
        }
    }
}

/// Why a command failed.
#[derive(Debug)]
pub enum CommandError {
    /// Invalid command line.
    Usage(String),
    /// Invalid scene or other input.
    InvalidInput {
        /// The file.
        path: PathBuf,
        /// Line, from 1; `None` if the error has none.
        line: Option<usize>,
        /// The error.
        reason: String,
    },
    /// Invalid scene, with all its errors.
    Diagnostics(Box<Diagnostics>),
    /// An input cannot be read.
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The error of the system.
        error: io::Error,
    },
    /// An output cannot be written.
    Unwritable {
        /// The file; `None` for standard output.
        path: Option<PathBuf>,
        /// The error of the system.
        error: io::Error,
    },
    /// Interrupted before anything was written.
    Stopped(Interrupt),
    /// Interrupted after a part of a stream was written.
    StoppedMidStream(Interrupt),
    /// The time limit is too short; the message has one that suffices.
    TimeLimitTooShort(String),
}

impl CommandError {
    /// An invalid input, without a line.
    pub fn input(path: &Path, reason: impl Into<String>) -> Self {
        CommandError::InvalidInput { path: path.to_owned(), line: None, reason: reason.into() }
    }

    /// An invalid input at a line.
    pub fn at(path: &Path, line: usize, reason: impl Into<String>) -> Self {
        CommandError::InvalidInput { path: path.to_owned(), line: Some(line), reason: reason.into() }
    }

    /// The exit status, as in `sysexits.h` if that defines one.
    pub fn status(&self) -> u8 {
        match self {
            CommandError::Usage(_) => 2,
            CommandError::InvalidInput { .. } | CommandError::Diagnostics(_) => 65,
            CommandError::Unreadable { .. } => 66,
            CommandError::Unwritable { .. } => 74,
            CommandError::Stopped(stop) | CommandError::StoppedMidStream(stop) => status(*stop),
            CommandError::TimeLimitTooShort(_) => status(Interrupt::TimeLimit),
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

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CommandError::Usage(reason) | CommandError::TimeLimitTooShort(reason) => write!(f, "{reason}"),
            CommandError::InvalidInput { path, line: Some(line), reason } => {
                write!(f, "{}:{line}: {reason}", path.display())
            }
            CommandError::InvalidInput { path, line: None, reason } => {
                write!(f, "{}: {reason}", path.display())
            }
            CommandError::Diagnostics(diagnostics) => diagnostics.fmt(f),
            CommandError::Unreadable { path, error } => write!(f, "cannot read {}: {error}", path.display()),
            CommandError::Unwritable { path: Some(path), error } => {
                write!(f, "cannot write {}: {error}", path.display())
            }
            CommandError::Unwritable { path: None, error } => {
                write!(f, "cannot write to the standard output: {error}")
            }
            CommandError::Stopped(stop) => write!(f, "{stop}; nothing was written"),
            CommandError::StoppedMidStream(stop) => write!(f, "{stop}; the output is incomplete"),
        }
    }
}

impl std::error::Error for CommandError {}

impl From<LoadError> for CommandError {
    fn from(error: LoadError) -> Self {
        match error {
            LoadError::Unreadable { path, error } => CommandError::Unreadable { path, error },
            LoadError::Invalid { path, line, reason } => CommandError::InvalidInput { path, line, reason },
            LoadError::Diagnostics(diagnostics) => CommandError::Diagnostics(diagnostics),
            error => CommandError::Usage(error.to_string()),
        }
    }
}

impl From<SettingsError> for CommandError {
    fn from(error: SettingsError) -> Self {
        CommandError::Usage(error.to_string())
    }
}

impl From<FormatError> for CommandError {
    fn from(error: FormatError) -> Self {
        CommandError::Usage(error.to_string())
    }
}
