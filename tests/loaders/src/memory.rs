//! A system allocator that records peak memory, and the limit for loading a file.
//!
//! It counts the whole process, so a program must measure one operation at a time.
#![allow(unsafe_code)] // an allocator cannot be written without

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// The memory that loading a file may take, for any contents.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// Bytes for each byte of the file and of the files that it references.
    pub share: usize,
    /// Bytes for a file of any size: its path, a message, initial tables.
    pub base: usize,
}

impl Bound {
    /// Of NFF. Lights take the most: 8 bytes in the file, 40 in a table that doubles when it is
    /// full, so that at times there are three times as many.
    pub const NFF: Bound = Bound { share: 20, base: 4 << 10 };

    /// Of TOML. The most take mistakes of the parser, all of which it keeps: 2 bytes in the file,
    /// 270 in a table that doubles and what belongs to it. Next come materials that say nothing:
    /// 3 bytes in the file, 600 for their keys.
    pub const TOML: Bound = Bound { share: 450, base: 32 << 10 };

    /// Of meshes. The most take materials of glTF: 3 bytes in the file for one that says nothing,
    /// 200 bytes in tables that double when they are full and are then there three times over.
    /// Next come triangles with corners of their own, 2 bytes in an OBJ file and 84 here.
    pub const MESH: Bound = Bound { share: 200, base: 32 << 10 };

    /// For files of so many bytes.
    pub fn of(self, bytes: usize) -> usize {
        self.base + self.share * bytes
    }
}

struct Counting;

static HELD: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: it hands everything on to the system's allocator. The other functions of the trait
// are made of these two, so a growing table is counted twice while it is copied.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let held = HELD.fetch_add(layout.size(), Relaxed) + layout.size();
        MOST.fetch_max(held, Relaxed);
        // SAFETY: the caller keeps the same promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size(), Relaxed);
        // SAFETY: `place` comes from `alloc` above, and with it from the system's allocator.
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// What `work` answers, and the most bytes that are held at once while it is done, beyond those
/// held before.
pub fn most_held<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = HELD.load(Relaxed);
    MOST.store(before, Relaxed);
    let done = work();
    (done, MOST.load(Relaxed) - before)
}
