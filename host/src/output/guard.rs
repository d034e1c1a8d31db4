//! Protects inputs from being overwritten.
//!
//! Every output is opened by the guard of its command. The guard tracks all files that the command has read or
//! that are referenced, including those of a scene, and all outputs. Files are identified by their canonical path
//! and inode, so links are followed.

use std::fs;
use std::path::{Path, PathBuf};

use super::{Output, place_of};
use crate::error::CommandError;

/// The files of a command that no other output may overwrite.
#[derive(Debug, Default)]
pub struct OutputGuard {
    inputs: Vec<GuardedFile>,
    outputs: Vec<GuardedFile>,
}

/// A file, existing or not.
#[derive(Debug)]
struct GuardedFile {
    /// Path as given.
    name: PathBuf,
    /// Canonical path.
    place: PathBuf,
    /// Device and inode, if the file exists: the same for all hard links.
    node: Option<(u64, u64)>,
}

impl OutputGuard {
    /// A guard of these inputs; `-` is standard input, which may be a file.
    pub fn of(inputs: impl IntoIterator<Item = impl AsRef<Path>>) -> Self {
        let inputs = inputs.into_iter().filter_map(|path| GuardedFile::of(path.as_ref()));
        OutputGuard { inputs: inputs.collect(), outputs: Vec::new() }
    }

    /// Opens an output at `path`, unless it would overwrite an input or another output; `-` is standard output.
    pub fn prepare(&mut self, path: &Path) -> Result<Output, CommandError> {
        let output = Output::prepare(path)?;
        if let Output::File { .. } = output
            && let Some(new) = GuardedFile::of(path)
        {
            let conflict = |old: &GuardedFile, kind: &str| {
                let (new, old) = (path.display(), old.name.display());
                CommandError::Usage(format!("{new} would overwrite the {kind} {old}; choose another output"))
            };
            if let Some(input) = self.inputs.iter().find(|input| input.is(&new)) {
                return Err(conflict(input, "input"));
            }
            if let Some(output) = self.outputs.iter().find(|output| output.is(&new)) {
                return Err(conflict(output, "output"));
            }
            self.outputs.push(new);
        }
        Ok(output)
    }
}

impl GuardedFile {
    /// The file at `path`; `None` for a pipe or a device, which are not replaced.
    fn of(path: &Path) -> Option<Self> {
        let (name, path) =
            if path == Path::new("-") { ("<stdin>".as_ref(), "/dev/stdin".as_ref()) } else { (path, path) };
        let there = fs::metadata(path).ok();
        if there.as_ref().is_some_and(|there| !there.is_file()) {
            return None;
        }
        Some(GuardedFile {
            name: name.to_owned(),
            place: place_of(path),
            node: there.as_ref().and_then(node),
        })
    }

    fn is(&self, other: &GuardedFile) -> bool {
        self.place == other.place || (self.node.is_some() && self.node == other.node)
    }
}

#[cfg(unix)]
fn node(there: &fs::Metadata) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt;
    Some((there.dev(), there.ino()))
}

#[cfg(not(unix))]
fn node(_: &fs::Metadata) -> Option<(u64, u64)> {
    None
}
