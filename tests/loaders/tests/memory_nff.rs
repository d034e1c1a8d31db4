//! The memory for loading an invalid NFF file is bounded by the file size.
//!
//! The allocator counts all allocations of the process, so the program has only one test.

use std::io::Write;

use strahl_loader_tests::invalid_nff::{VIEW, invalid_files};
use strahl_loader_tests::memory::{Bound, peak_memory};
use strahl_scene::load;

/// Long invalid files that repeat one entity.
fn long_files() -> Vec<Vec<u8>> {
    let fill = "f 1 1 1 1 0 0 0 0\n";
    let begin = format!("{VIEW}{fill}");
    // One more than a power of two, so that a growing table has just doubled.
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
fn loading_an_invalid_file_takes_at_most_a_small_multiple_of_its_size() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wrong.nff");
    let files = invalid_files().into_iter().map(|(bytes, ..)| bytes).chain(long_files());
    for bytes in files {
        std::fs::File::create(&path).unwrap().write_all(&bytes).unwrap();
        let (loaded, most) = peak_memory(|| load(&path));
        let start = String::from_utf8_lossy(&bytes[..bytes.len().min(200)]);
        assert!(loaded.is_err(), "{start}");
        let bound = Bound::NFF.of(bytes.len());
        assert!(most <= bound, "{most} bytes for a file of {}, which begins with {start}", bytes.len());
    }
}
