//! Why a scene could not be loaded.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use crate::diagnostics::Diagnostics;

/// Why a scene could not be loaded.
#[derive(Debug)]
#[non_exhaustive]
pub enum LoadError {
    /// A file cannot be read.
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A file is wrong; at which line, when it has one.
    Invalid {
        /// The file.
        path: PathBuf,
        /// Counted from 1.
        line: Option<usize>,
        /// What is wrong there.
        reason: String,
    },
    /// A file is wrong, at all of these places.
    Diagnostics(Box<Diagnostics>),
}

impl LoadError {
    /// A file is wrong at a line.
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
