//! Protects inputs from being overwritten.
//!
//! Every output is opened by the guard of its command. The guard tracks all files that the command has read or
//! that are referenced, including those of a scene, and all outputs. Files are identified by their canonical path
//! and inode, so links are followed.

use std::fs;
use std::path::{Path, PathBuf};

use super::{Output, canonical_path};
use crate::error::CommandError;

/// The files of a command that no other output may overwrite.
#[derive(Debug, Default)]
pub struct OutputGuard {
    inputs: Vec<FileIdentity>,
    outputs: Vec<FileIdentity>,
}

/// Identifies a file, existing or not, by its canonical path and its inode.
#[derive(Debug)]
struct FileIdentity {
    /// Path as given.
    name: PathBuf,
    /// Canonical path.
    canonical: PathBuf,
    /// Device and inode, if the file exists: the same for all hard links.
    node: Option<(u64, u64)>,
}

impl OutputGuard {
    /// A guard of these inputs; `-` is standard input, which may be a file.
    pub fn of(inputs: impl IntoIterator<Item = impl AsRef<Path>>) -> Self {
        let inputs = inputs.into_iter().filter_map(|path| FileIdentity::of(path.as_ref()));
        OutputGuard { inputs: inputs.collect(), outputs: Vec::new() }
    }

    /// Opens an output at `path`, unless it would overwrite an input or another output; `-` is standard output.
    pub fn prepare(&mut self, path: &Path) -> Result<Output, CommandError> {
        let output = Output::prepare(path)?;
        if let Output::File { .. } = output
            && let Some(new) = FileIdentity::of(path)
        {
            let conflict = |old: &FileIdentity, kind: &str| {
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

impl FileIdentity {
    /// The file at `path`; `None` for a pipe or a device, which are not replaced.
    fn of(path: &Path) -> Option<Self> {
        let (name, path) =
            if path == Path::new("-") { ("<stdin>".as_ref(), "/dev/stdin".as_ref()) } else { (path, path) };
        let metadata = fs::metadata(path).ok();
        if metadata.as_ref().is_some_and(|metadata| !metadata.is_file()) {
            return None;
        }
        Some(FileIdentity {
            name: name.to_owned(),
            canonical: canonical_path(path),
            node: metadata.as_ref().and_then(node),
        })
    }

    fn is(&self, other: &FileIdentity) -> bool {
        self.canonical == other.canonical || (self.node.is_some() && self.node == other.node)
    }
}

#[cfg(unix)]
fn node(metadata: &fs::Metadata) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt;
    Some((metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
fn node(_: &fs::Metadata) -> Option<(u64, u64)> {
    None
}
