//! Errors in mesh files.

use std::path::Path;

use crate::error::LoadError;

/// The line of an error, if the format has lines, and its text.
pub type LineError = (Option<usize>, String);

/// An error in the file at `path`.
pub fn invalid(path: &Path, (line, reason): LineError) -> LoadError {
    LoadError::Invalid { path: path.to_owned(), line, reason }
}
