//! Source files of a scene.
//!
//! A scene may reference files, which may reference others. All paths that were read or referenced are recorded, also
//! when loading fails: `watch` reloads the scene when one of them changes, and outputs must not overwrite them. With
//! [`SourceFiles::from_memory`] the disk is not used: only the given files exist.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::io;
use std::path::{Path, PathBuf};

use blake3::Hash;

/// Reads the files of a scene, on disk or in memory, and records their paths.
#[derive(Debug, Default)]
pub struct SourceFiles {
    /// The files in memory; `None` to read from disk.
    in_memory: Option<HashMap<PathBuf, Vec<u8>>>,
    /// The paths that were read or referenced, whether they exist or not.
    named: RefCell<BTreeSet<PathBuf>>,
    /// The hash of each file that was read, if tracked; `None` for an unreadable file.
    hashes: Option<RefCell<BTreeMap<PathBuf, Option<Hash>>>>,
}

impl SourceFiles {
    /// The files on disk.
    pub fn on_disk() -> Self {
        SourceFiles::default()
    }

    /// The files on disk; those that are read are tracked for changes.
    pub fn tracked() -> Self {
        SourceFiles { hashes: Some(RefCell::default()), ..SourceFiles::default() }
    }

    /// Only these files.
    pub fn from_memory(files: impl IntoIterator<Item = (PathBuf, Vec<u8>)>) -> Self {
        SourceFiles { in_memory: Some(files.into_iter().collect()), ..SourceFiles::default() }
    }

    /// The paths that were read, whether they exist or not; empty unless tracked.
    pub fn tracked_paths(&self) -> Vec<PathBuf> {
        self.hashes.iter().flat_map(|found| found.borrow().keys().cloned().collect::<Vec<_>>()).collect()
    }

    /// The paths that were read or referenced, whether they exist or not.
    pub fn named_paths(&self) -> Vec<PathBuf> {
        self.named.borrow().iter().cloned().collect()
    }

    /// Records a file that is referenced but not read.
    pub(crate) fn note_path(&self, path: PathBuf) {
        self.named.borrow_mut().insert(path);
    }

    /// Whether all tracked files still have the same contents; true unless tracked.
    pub fn unchanged(&self) -> bool {
        let Some(found) = &self.hashes else { return true };
        found
            .borrow()
            .iter()
            .all(|(path, then)| read_regular_file(path).ok().map(|bytes| blake3::hash(&bytes)) == *then)
    }

    /// Reads a file named by the user, which may be a pipe.
    pub fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let read = || std::fs::read(path);
        self.track(path, self.get_from_memory(path).unwrap_or_else(read))
    }

    /// Reads a file that another one references. It must be a regular file: a pipe or a device may have no end.
    pub(crate) fn read_referenced(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.track(path, self.get_from_memory(path).unwrap_or_else(|| read_regular_file(path)))
    }

    fn get_from_memory(&self, path: &Path) -> Option<io::Result<Vec<u8>>> {
        let held = self.in_memory.as_ref()?;
        Some(held.get(path).cloned().ok_or_else(|| io::ErrorKind::NotFound.into()))
    }

    fn track(&self, path: &Path, read: io::Result<Vec<u8>>) -> io::Result<Vec<u8>> {
        self.note_path(path.to_owned());
        if let Some(found) = &self.hashes {
            let hash = read.as_ref().ok().map(|bytes| blake3::hash(bytes));
            found.borrow_mut().insert(path.to_owned(), hash);
        }
        read
    }
}

fn read_regular_file(path: &Path) -> io::Result<Vec<u8>> {
    if std::fs::metadata(path)?.is_file() {
        std::fs::read(path)
    } else {
        Err(io::Error::other("not a regular file"))
    }
}
