//! Valid files with random damage load or are rejected; nothing panics.

use std::panic::catch_unwind;

use strahl_scene::LoadError;
use strahl_scene::load;
use strahl_session::tables;

use crate::files::{Folder, SQUARE_OBJ, SQUARE_PLY, floats, glb, gltf_of, gltf_with, square_bytes};
use crate::random::Random;

/// Words that replace others.
const NASTY: &[&str] = &[
    "",
    "\n",
    "\0",
    "\\\n",
    "#",
    "-",
    "/",
    "//",
    "é",
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "4",
    "5",
    "1.5",
    "255",
    "256",
    "65535",
    "65536",
    "2147483648",
    "-2147483648",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551615",
    "1e15",
    "1.1e15",
    "1e-45",
    "1e39",
    "1e400",
    "nan",
    "inf",
    "v",
    "vn",
    "f",
    "usemtl",
    "mtllib a.mtl",
    "property",
    "element",
    "list",
    "float",
    "uchar",
    "int",
    "end_header",
    "null",
    "[]",
    "{}",
    "[0]",
    "true",
    "\"\"",
    "5121",
    "5125",
    "5126",
    "SCALAR",
    "VEC3",
];

/// Damages the file once more; `words` end at any of `ends`.
fn damaged(mut file: Vec<u8>, ends: &[u8], random: &mut Random) -> Vec<u8> {
    if file.is_empty() {
        return file;
    }
    let place = random.below(file.len());
    let piece = place..file.len().min(place + 1 + random.below(40));
    match random.below(9) {
        0 => file[place] ^= 1 << random.below(8),
        1 => file[place] = random.below(256) as u8,
        2 => file.truncate(place),
        3 => drop(file.drain(piece)),
        4 => {
            let copy = file[piece].to_vec();
            let to = random.below(file.len());
            file.splice(to..to, copy);
        }
        5 if place + 4 <= file.len() => {
            let number =
                [0, 1, 0x7FFF_FFFF, 0x8000_0000, 0xFFFF_FFFF, 0x7FC0_0000, 0x7F80_0000][random.below(7)];
            file[place..place + 4].copy_from_slice(&u32::to_le_bytes(number));
        }
        _ => {
            let start = file[..place].iter().rposition(|byte| ends.contains(byte)).map_or(0, |end| end + 1);
            let end =
                file[place..].iter().position(|byte| ends.contains(byte)).map_or(file.len(), |n| place + n);
            let word = NASTY[random.below(NASTY.len())];
            file.splice(start..end.max(start), word.bytes());
        }
    }
    file
}

/// Damages the file `rounds` times, starting from the original each time.
fn survive(name: &str, whole: &[u8], ends: &[u8], rounds: usize) {
    let library = b"newmtl a\nKd 1 0.5 0\nKs 1 1 1\nNs 9\nd 0.5\nNi 1.5\nillum 7\n";
    let folder = Folder::of(&[("a.mtl", library), ("a.bin", &square_bytes())]);
    let path = folder.path(name);
    std::fs::write(&path, whole).unwrap();
    load(&path).unwrap_or_else(|failure| panic!("{failure}"));
    let (mut good, mut refused) = (0, 0);
    let mut random = Random(name.len() as u64 + whole.len() as u64);
    for _ in 0..rounds {
        let mut file = whole.to_vec();
        for _ in 0..=random.below(3) {
            file = damaged(file, ends, &mut random);
        }
        std::fs::write(&path, &file).unwrap();
        let text = String::from_utf8_lossy(&file);
        match catch_unwind(|| load(&path)).unwrap_or_else(|_| panic!("a panic\n{text}\n{file:?}")) {
            Ok(it) => {
                let single = tables::single::scene_tables(&it);
                assert_eq!(single.scene().err(), None, "{text}");
                assert!(tables::double::scene_tables(&it).scene().is_ok(), "{text}");
                assert!(it.normals.is_empty() || it.normals.len() == it.vertices.len(), "{text}");
                assert!(!it.normals.contains(&[0.0; 3]), "{text}");
                good += 1;
            }
            Err(LoadError::Invalid { line, reason, .. }) => {
                let lines = file.split_inclusive(|byte| *byte == b'\n').count();
                assert!(line.is_none_or(|line| line >= 1 && line <= lines + 1), "{line:?}: {reason}\n{text}");
                assert!(!reason.contains(|c: char| c.is_control()), "{reason:?}");
                assert!(reason.chars().count() < 300, "{reason}");
                refused += 1;
            }
            Err(LoadError::Unreadable { .. }) => refused += 1,
            Err(other) => panic!("{other}\n{text}"),
        }
    }
    // Both occur often enough for the test to be meaningful.
    assert!(good > rounds / 100 && refused > rounds / 20, "{name}: {good} good, {refused} refused");
}

#[test]
fn damaged_obj_files_load_or_are_rejected() {
    let text = format!(
        "# all\nmtllib a.mtl\n{SQUARE_OBJ}vn 0 0 1\nvn 1 0 0\nvt 0 1\nusemtl a\nf 1/1/1 2//2 -2//-1\ng x\n\
         v 2 0 0 1\nv 3 3 0\nv 1 2 \\\n 0\nf 1 5 6 3 7 4\nl 1 2\n"
    );
    survive("f.obj", text.as_bytes(), b" \n", 6_000);
}

#[test]
fn damaged_material_libraries_load_or_are_rejected() {
    let folder = Folder::of(&[("f.obj", format!("mtllib a.mtl\nusemtl a\n{SQUARE_OBJ}").as_bytes())]);
    let whole = b"newmtl a\nKd 1 0.5 0\nKs 1 1 1\nTf 1 1 1\nNs 9\nd -halo 0.5\nNi 1.5\nillum 7\nmap_Kd a b\nnewmtl b\nTr 1\n";
    let mut random = Random(5);
    for _ in 0..4_000 {
        let mut file = whole.to_vec();
        for _ in 0..=random.below(3) {
            file = damaged(file, b" \n", &mut random);
        }
        std::fs::write(folder.path("a.mtl"), &file).unwrap();
        let loaded = catch_unwind(|| load(&folder.path("f.obj")));
        match loaded.unwrap_or_else(|_| panic!("a panic\n{}", String::from_utf8_lossy(&file))) {
            Ok(it) => assert_eq!(tables::single::scene_tables(&it).scene().err(), None),
            Err(failure) => assert!(matches!(failure, LoadError::Invalid { .. } | LoadError::Diagnostics(_))),
        }
    }
}

#[test]
fn damaged_ascii_ply_files_load_or_are_rejected() {
    survive("f.ply", SQUARE_PLY.as_bytes(), b" \n", 6_000);
}

#[test]
fn damaged_binary_ply_files_load_or_are_rejected() {
    let header = SQUARE_PLY
        .replace("float z\n", "float z\nproperty float nx\nproperty float ny\nproperty double nz\n");
    for (order, is_big) in [("binary_little_endian", false), ("binary_big_endian", true)] {
        let header = header.replace("ascii", order);
        let mut file = header.as_bytes()[..header.find("end_header").unwrap() + 11].to_vec();
        let order = |mut bytes: Vec<u8>| {
            if is_big {
                bytes.reverse();
            }
            bytes
        };
        for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0_f32]] {
            [x, y, 0.0, 0.0, 1.0].iter().for_each(|x| file.extend(order(floats(&[*x]))));
            file.extend(order(1.0_f64.to_le_bytes().to_vec()));
        }
        file.push(4);
        (0..4_i32).for_each(|i| file.extend(order(i.to_le_bytes().to_vec())));
        survive("f.ply", &file, b" \n", 4_000);
    }
}

const MOVED: &str = r#""scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"scale":[2,1,-1]},{"children":[2]},
{"mesh":0,"rotation":[0,0,0.6,0.8],"translation":[1,2,3]}],"materials":[{"name":"a"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2,"material":0},
{"attributes":{"POSITION":0},"mode":5}]}]"#;

#[test]
fn damaged_gltf_files_load_or_are_rejected() {
    survive("f.gltf", gltf_with(r#""uri":"a.bin","#, MOVED).as_bytes(), b" \n:,[]{}\"", 6_000);
    survive("f.gltf", gltf_of(MOVED).as_bytes(), b" \n:,[]{}\"", 2_000);
}

#[test]
fn damaged_glb_files_load_or_are_rejected() {
    let file = glb(&gltf_with("", MOVED), Some(&square_bytes()));
    survive("f.glb", &file, b" \n:,[]{}\"", 6_000);
}
