//! Errors of loading a scene.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use crate::diagnostics::Diagnostics;

/// Why a scene could not be loaded.
#[derive(Debug)]
#[non_exhaustive]
pub enum LoadError {
    /// A file could not be read.
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system error.
        error: io::Error,
    },
    /// A file is invalid.
    Invalid {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1; `None` if the error has no line.
        line: Option<usize>,
        /// The error, as text.
        reason: String,
    },
    /// A file is invalid, with errors at these locations.
    Diagnostics(Box<Diagnostics>),
}

impl LoadError {
    /// An error at a line of a file.
    pub(crate) fn at(path: &Path, line: usize, reason: impl Into<String>) -> Self {
        LoadError::Invalid { path: path.to_owned(), line: Some(line), reason: reason.into() }
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoadError::Unreadable { path, error } => write!(f, "cannot read {}: {error}", path.display()),
            LoadError::Invalid { path, line: Some(line), reason } => {
                write!(f, "{}:{line}: {reason}", path.display())
            }
            LoadError::Invalid { path, line: None, reason } => write!(f, "{}: {reason}", path.display()),
            LoadError::Diagnostics(diagnostics) => diagnostics.fmt(f),
        }
    }
}

impl Error for LoadError {}
