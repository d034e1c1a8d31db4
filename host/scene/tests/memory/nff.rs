//! A number in a scene file must not fill the memory: what loading a wrong file takes is bounded
//! by the size of the file, whatever stands in it.
//!
//! The allocator of this program counts, so it has one test and no others beside it.

use std::io::Write;

use strahl_scene::load;

use counting::{Bound, most_held};
use table::{VIEW, wrong_files};

mod counting;
#[path = "../load/table.rs"]
mod table;

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
        let bound = Bound::NFF.of(bytes.len());
        assert!(most <= bound, "{most} bytes for a file of {}, which begins with {start}", bytes.len());
    }
}
