//! A valid file with random damage loads, or is rejected with an existing line.

use std::panic::catch_unwind;

use strahl_scene::LoadError;
use strahl_scene::load;
use strahl_session::tables;

use crate::text::ALL;

/// Words that replace others.
const NASTY: &[&str] = &[
    "v",
    "b",
    "l",
    "f",
    "s",
    "c",
    "p",
    "pp",
    "from",
    "resolution",
    "#",
    "x",
    "",
    "\n",
    "\r",
    "\0",
    "\u{feff}",
    "é",
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "1.5",
    "65536",
    "65537",
    "4294967295",
    "4294967296",
    "-9223372036854775808",
    "1e15",
    "-1e15",
    "1.1e15",
    "1e16",
    "1e-45",
    "1e-60",
    "1e38",
    "1e39",
    "1e400",
    "nan",
    "inf",
    "-inf",
    "+",
    "-",
    ".",
    "e5",
    "0.02",
    "1e6",
    "1000001",
];

/// Pseudo-random numbers with a fixed seed (SplitMix64, "Fast Splittable Pseudorandom Number Generators", OOPSLA
/// 2014).
struct Random(u64);

impl Random {
    /// A number less than `end`; 0 if `end` is 0.
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % end.max(1) as u64) as usize
    }

    /// A random range of at most 40 in `0..length`.
    fn piece(&mut self, length: usize) -> std::ops::Range<usize> {
        let start = self.below(length);
        start..length.min(start + 1 + self.below(40))
    }
}

/// Damages the file once more.
fn damaged(mut file: Vec<u8>, random: &mut Random) -> Vec<u8> {
    if file.is_empty() {
        return file;
    }
    let place = random.below(file.len());
    match random.below(8) {
        0 => file[place] ^= 1 << random.below(8),
        1 => file[place] = random.below(256) as u8,
        2 => file.truncate(place),
        3 => {
            let piece = random.piece(file.len());
            file.drain(piece);
        }
        4 => {
            let copy = file[random.piece(file.len())].to_vec();
            file.splice(place..place, copy);
        }
        _ => {
            let is_space = |byte: &u8| byte.is_ascii_whitespace();
            let start = file[..place].iter().rposition(is_space).map_or(0, |space| space + 1);
            let end = file[place..].iter().position(is_space).map_or(file.len(), |space| place + space);
            let word = NASTY[random.below(NASTY.len())];
            file.splice(start..end.max(start), word.bytes());
        }
    }
    file
}

#[test]
fn a_damaged_file_loads_or_is_rejected_at_one_of_its_lines() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("damaged.nff");
    let (mut good, mut refused) = (0, 0);
    let mut random = Random(1986);
    for _ in 0..6_000 {
        let mut file = ALL.as_bytes().to_vec();
        for _ in 0..=random.below(3) {
            file = damaged(file, &mut random);
        }
        std::fs::write(&path, &file).unwrap();
        let text = String::from_utf8_lossy(&file);
        let lines = file.split_inclusive(|byte| *byte == b'\n').count().max(1);
        match catch_unwind(|| load(&path)).unwrap_or_else(|_| panic!("a panic\n{text}")) {
            Ok(it) => {
                let single = tables::single::scene_tables(&it).scene().err();
                assert_eq!(single, None, "{text}");
                assert!(tables::double::scene_tables(&it).scene().is_ok(), "{text}");
                good += 1;
            }
            Err(LoadError::Invalid { line: Some(line), reason, .. }) => {
                assert!(line >= 1 && line <= lines, "{line}: {reason}\n{text}");
                refused += 1;
            }
            Err(other) => panic!("{other}\n{text}"),
        }
    }
    // Both occur often enough for the test to be meaningful.
    assert!(good > 500 && refused > 500, "{good} good, {refused} refused");
}
