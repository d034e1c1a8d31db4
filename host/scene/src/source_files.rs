//! The files that a scene is made of.
//!
//! A scene may name files beside it, which may name others. Whoever wants to know when to load
//! it again, or what must not be written over, asks which they were, whether loading went well or
//! not. And loading can be kept away from the disk altogether: files held in memory are then all
//! that there are.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::io;
use std::path::{Path, PathBuf};

use blake3::Hash;

/// Where files are read, and which were asked for.
#[derive(Debug, Default)]
pub struct SourceFiles {
    /// All that there are; none for those of the disk.
    in_memory: Option<HashMap<PathBuf, Vec<u8>>>,
    /// All that were asked for or named, there or not.
    named: RefCell<BTreeSet<PathBuf>>,
    /// What was found where, if that is kept; nothing where nothing could be read.
    hashes: Option<RefCell<BTreeMap<PathBuf, Option<Hash>>>>,
}

impl SourceFiles {
    /// Those of the disk.
    pub fn on_disk() -> Self {
        SourceFiles::default()
    }

    /// Those of the disk; what is read is kept in mind.
    pub fn tracked() -> Self {
        SourceFiles { hashes: Some(RefCell::default()), ..SourceFiles::default() }
    }

    /// These and no others.
    pub fn from_memory(files: impl IntoIterator<Item = (PathBuf, Vec<u8>)>) -> Self {
        SourceFiles { in_memory: Some(files.into_iter().collect()), ..SourceFiles::default() }
    }

    /// All that were asked for, there or not, if they are remembered.
    pub fn tracked_paths(&self) -> Vec<PathBuf> {
        self.hashes.iter().flat_map(|found| found.borrow().keys().cloned().collect::<Vec<_>>()).collect()
    }

    /// All that were asked for or named, there or not, read or not.
    pub fn named_paths(&self) -> Vec<PathBuf> {
        self.named.borrow().iter().cloned().collect()
    }

    /// A file that is named and not read.
    pub(crate) fn note_path(&self, path: PathBuf) {
        self.named.borrow_mut().insert(path);
    }

    /// Whether all of them still are what they were, if they are remembered.
    pub fn unchanged(&self) -> bool {
        let Some(found) = &self.hashes else { return true };
        found
            .borrow()
            .iter()
            .all(|(path, then)| read_regular_file(path).ok().map(|bytes| blake3::hash(&bytes)) == *then)
    }

    /// Reads a file that the user named: it may be a pipe.
    pub fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let read = || std::fs::read(path);
        self.track(path, self.get_from_memory(path).unwrap_or_else(read))
    }

    /// Reads a file that another one names. What is no plain file is as good as missing: a pipe
    /// or a device may have no end.
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
        Err(io::Error::other("it is no file"))
    }
}
