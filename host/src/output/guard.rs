//! Nothing that was read is written over.
//!
//! Every output is opened by the guard of its command, and there is no other way to open one. The
//! guard knows all files that the command has read or that were named to be read, those that a
//! scene names among them, and all outputs so far. It goes by the files and not by their names:
//! through links of either kind, and by every way round.

use std::fs;
use std::path::{Path, PathBuf};

use super::{Output, place_of};
use crate::failure::Failure;

/// The files of a command that no further output may replace.
#[derive(Debug, Default)]
pub struct Guard {
    inputs: Vec<Known>,
    outputs: Vec<Known>,
}

/// A file, there or not.
#[derive(Debug)]
struct Known {
    /// As it was named.
    name: PathBuf,
    /// Where it is or would be, links followed.
    place: PathBuf,
    /// Its number in the file system, if it is there: the same under all of its names.
    node: Option<(u64, u64)>,
}

impl Guard {
    /// Of these inputs; `-` is the standard input, which may be a file.
    pub fn of(inputs: impl IntoIterator<Item = impl AsRef<Path>>) -> Self {
        let inputs = inputs.into_iter().filter_map(|path| Known::of(path.as_ref()));
        Guard { inputs: inputs.collect(), outputs: Vec::new() }
    }

    /// Makes sure that `path` can be written, and that nothing is lost by it that is read or
    /// written elsewhere; `-` is the standard output.
    pub fn prepare(&mut self, path: &Path) -> Result<Output, Failure> {
        let output = Output::prepare(path)?;
        if let Output::File { .. } = output
            && let Some(new) = Known::of(path)
        {
            let told = |old: &Known, what: &str| {
                let (new, old) = (path.display(), old.name.display());
                Failure::Usage(format!("{new} would replace {old}, {what}: name another file to be written"))
            };
            if let Some(input) = self.inputs.iter().find(|input| input.is(&new)) {
                return Err(told(input, "which is read or named as an input"));
            }
            if let Some(output) = self.outputs.iter().find(|output| output.is(&new)) {
                return Err(told(output, "which is an output too"));
            }
            self.outputs.push(new);
        }
        Ok(output)
    }
}

impl Known {
    /// The file at `path`. What is there and no file, a pipe or a device, cannot be replaced.
    fn of(path: &Path) -> Option<Self> {
        let (name, path) =
            if path == Path::new("-") { ("<stdin>".as_ref(), "/dev/stdin".as_ref()) } else { (path, path) };
        let there = fs::metadata(path).ok();
        if there.as_ref().is_some_and(|there| !there.is_file()) {
            return None;
        }
        Some(Known { name: name.to_owned(), place: place_of(path), node: there.as_ref().and_then(node) })
    }

    fn is(&self, other: &Known) -> bool {
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
