//! Scene files become descriptions.

mod nff;

use std::path::Path;

use crate::description::Description;
use crate::failure::Failure;

/// Loads the scene file at `path`; its extension names the format.
pub fn load(path: &Path) -> Result<Description, Failure> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    // A file that is not there is told first, whatever its name.
    let bytes = std::fs::read(path).map_err(|error| Failure::Unreadable { path: path.to_owned(), error })?;
    match extension.as_str() {
        "nff" => nff::read(path, &bytes),
        _ => Err(Failure::Input {
            path: path.to_owned(),
            line: None,
            reason: "not a scene that strahl reads; the extension must be .nff".into(),
        }),
    }
}
