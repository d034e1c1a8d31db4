//! What is wrong in a file of triangles.

use std::path::Path;

use crate::error::LoadError;

/// The line, where there are lines, and what is wrong there.
pub type LineError = (Option<usize>, String);

/// That something is wrong in the file at `path`.
pub fn invalid(path: &Path, (line, reason): LineError) -> LoadError {
    LoadError::Invalid { path: path.to_owned(), line, reason }
}
