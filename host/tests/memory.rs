//! A number in a scene file must not fill the memory: what loading a wrong file takes is bounded
//! by the size of the file, whatever stands in it.
//!
//! The allocator of this program counts, so it has one test and no others beside it.
#![allow(unsafe_code)] // an allocator cannot be written without

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use strahl::load::load;
use table::{VIEW, wrong_files};

#[path = "load/table.rs"]
mod table;

/// Bytes for each byte of a file. The most take lights: 8 bytes in the file, 40 in a table that
/// doubles when it is full, so that at times there are three times as many.
const SHARE: usize = 20;

/// Bytes for a file of any size: its name, a message, the first steps of all tables.
const BASE: usize = 4 << 10;

/// The system's allocator, which remembers the most bytes that were held at once.
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

/// The most bytes that are held at once while `work` is done, beyond those held before.
fn most_held<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = HELD.load(Relaxed);
    MOST.store(before, Relaxed);
    let done = work();
    (done, MOST.load(Relaxed) - before)
}

/// Long wrong files, made of one entity over and over.
fn long_files() -> Vec<Vec<u8>> {
    let fill = "f 1 1 1 1 0 0 0 0\n";
    let begin = format!("{VIEW}{fill}");
    // One more than a power of two: a table has just been doubled.
    let long = |begin: &str, again: &str| format!("{begin}{}?", again.repeat((1 << 16) + 1)).into_bytes();
    let surfaces: String = (0..65_536).map(|n| format!("f {} {} 0 0 0 0 0 0\n", n % 256, n / 256)).collect();
    vec![
        long("", "#"),
        long("", "x"),
        long("", "\n"),
        long("", "\0"),
        long("b ", "9"),
        long(VIEW, "l 0 0 0\n"),
        long(VIEW, fill),
        format!("{VIEW}{surfaces}?").into_bytes(),
        long(&begin, "s 0 0 0 1\n"),
        long(&begin, "c 0 0 0 1 0 0 1 0\n"),
        long(&begin, "p 3 0 0 0 1 0 0 0 1 0\n"),
        long(&begin, "p 3 0 0 0 0 0 0 0 0 0\n"),
        long(&begin, "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n"),
        long(&format!("{begin}p 4294967295"), " 0 0 0"),
        long(&format!("{begin}pp 4294967295"), " 0 0 0 0 0 1"),
        [long(&begin, " "), b"\xff".to_vec()].concat(),
    ]
}

#[test]
fn loading_a_wrong_file_takes_no_more_memory_than_a_small_multiple_of_its_size() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wrong.nff");
    let files = wrong_files().into_iter().map(|(bytes, ..)| bytes).chain(long_files());
    for bytes in files {
        std::fs::File::create(&path).unwrap().write_all(&bytes).unwrap();
        let (loaded, most) = most_held(|| load(&path));
        let start = String::from_utf8_lossy(&bytes[..bytes.len().min(200)]);
        assert!(loaded.is_err(), "{start}");
        let bound = BASE + SHARE * bytes.len();
        assert!(most <= bound, "{most} bytes for a file of {}, which begins with {start}", bytes.len());
    }
}
