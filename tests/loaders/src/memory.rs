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
    /// Of NFF. Lights take the most: 8 bytes in the file, 40 in a table that doubles when it is full, so that at
    /// times there are three times as many.
    pub const NFF: Bound = Bound { share: 20, base: 4 << 10 };

    /// Of TOML. Syntax errors take the most, because the parser collects all of them: 2 bytes in the file, 270
    /// in a table that doubles and in what its entries own. Empty materials come next: 3 bytes in the file, 600
    /// for their keys.
    pub const TOML: Bound = Bound { share: 450, base: 32 << 10 };

    /// Of meshes. Materials of glTF take the most: 3 bytes in the file for an empty one, 200 in tables that
    /// double when they are full, so that at times there are three times as many. Triangles that share no
    /// vertices come next: 2 bytes in an OBJ file, 84 in memory.
    pub const MESH: Bound = Bound { share: 200, base: 32 << 10 };

    /// Bytes that loading `bytes` bytes of files may take.
    pub fn of(self, bytes: usize) -> usize {
        self.base + self.share * bytes
    }
}

/// The system's allocator, which counts the bytes that are allocated.
struct CountingAllocator;

/// Bytes that are allocated now.
static ALLOCATED: AtomicUsize = AtomicUsize::new(0);
/// Most bytes that were allocated at once since `peak_memory` began.
static PEAK: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is forwarded to the system's allocator. The trait's other functions call these two, so a
// growing table is counted twice while it is copied.
unsafe impl GlobalAlloc for CountingAllocator {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let allocated = ALLOCATED.fetch_add(layout.size(), Relaxed) + layout.size();
        PEAK.fetch_max(allocated, Relaxed);
        // SAFETY: the caller of `alloc` meets the requirements of the system's `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        ALLOCATED.fetch_sub(layout.size(), Relaxed);
        // SAFETY: `pointer` comes from `alloc` above, hence from the system's allocator.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator;

/// The result of `work`, and the most bytes that were allocated at once during it, beyond those before.
pub fn peak_memory<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = ALLOCATED.load(Relaxed);
    PEAK.store(before, Relaxed);
    let result = work();
    (result, PEAK.load(Relaxed) - before)
}
