//! Picture files that a command reads.

use std::io::{self, Read};
use std::path::Path;

use strahl_picture::{DecodedPicture, decode};
use strahl_scene::SourceFiles;
use strahl_settings::domain::MAX_PIXELS;

use crate::error::CommandError;

/// Reads the picture at `path` from these files; `-` is the standard input.
pub fn read(files: &SourceFiles, path: &Path) -> Result<DecodedPicture, CommandError> {
    let bytes = if path == Path::new("-") { stdin() } else { files.read(path) };
    let bytes = bytes.map_err(|error| CommandError::Unreadable { path: path.to_owned(), error })?;
    decode(&bytes, MAX_PIXELS).map_err(|error| CommandError::InvalidInput {
        path: path.to_owned(),
        line: None,
        reason: error.to_string(),
    })
}

fn stdin() -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(bytes)
}
