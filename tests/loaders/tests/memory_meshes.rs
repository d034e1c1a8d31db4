//! The memory for loading a mesh is bounded by the file size, whether the file is valid or not.
//!
//! The allocator counts all allocations of the process, so the program has only one test.

use strahl_loader_tests::memory::{Bound, peak_memory};
use strahl_scene::mesh::read;

/// One more than a power of two, so that a growing table has just doubled.
const MANY: usize = (1 << 15) + 1;

fn ply(format: &str, vertices: usize, faces: usize, list: &str, data: &[u8]) -> Vec<u8> {
    let header = format!(
        "ply\nformat {format} 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {faces}\nproperty list {list} vertex_indices\nend_header\n"
    );
    [header.as_bytes(), data].concat()
}

fn files() -> Vec<(&'static str, Vec<u8>)> {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
    let obj = |begin: &str, again: &str| format!("{begin}{}", again.repeat(MANY)).into_bytes();
    let three = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].map(f32::to_le_bytes).concat();
    let gltf = |rest: &str| format!("{{\"asset\":{{\"version\":\"2.0\"}},{rest}}}").into_bytes();
    vec![
        ("obj", obj("", "v 1 1 1\n")),
        ("obj", obj(corners, "f 1 2 3\n")),
        ("obj", obj(corners, "f 1 2 3 1 2 3 1 2 3\n")),
        ("obj", obj(&format!("{corners}f"), " 1 2 3")),
        ("obj", obj(&format!("{corners}f 1//1 2//1 3//1\nf"), " 1 2 3")),
        ("obj", obj(&format!("{corners}f 1//1 2//1 3//1\n"), "f 1 2 3\nf 1 3 2\n")),
        ("obj", obj("", "x")),
        ("obj", obj("", "\\\n")),
        ("obj", (0..MANY).map(|n| format!("b{n}\n")).collect::<String>().into_bytes()),
        (
            "obj",
            (0..MANY)
                .map(|n| format!("v {n} {} 1\nvn 1 1 1\nf -1//-1 1 1//{}\n", n % 7, n + 1))
                .collect::<String>()
                .into_bytes(),
        ),
        ("ply", ply("ascii", 4_000_000_000, 1, "uchar int", b"0 0 0\n")),
        (
            "ply",
            ply(
                "ascii",
                3,
                1,
                "uint int",
                &[b"0 0 0 1 0 0 0 1 0 4294967295".as_slice(), &b" 1".repeat(MANY)].concat(),
            ),
        ),
        ("ply", ply("binary_little_endian", 3, usize::MAX, "uchar int", &three)),
        ("ply", ply("binary_little_endian", 3, 1, "uint int", &[&three[..], &[255; 99]].concat())),
        (
            "ply",
            ply("binary_little_endian", 3, MANY, "uchar uchar", &[&three[..], &[0, 1].repeat(MANY)].concat()),
        ),
        (
            "ply",
            ply(
                "binary_little_endian",
                3,
                1,
                "uint uchar",
                &[&three[..], &(MANY as u32).to_le_bytes(), &[0, 1, 2].repeat(MANY)].concat(),
            ),
        ),
        (
            "ply",
            ply(
                "binary_little_endian",
                3,
                MANY,
                "uchar uchar",
                &[&three[..], &[3, 0, 1, 2].repeat(MANY)].concat(),
            ),
        ),
        ("gltf", gltf(&format!("\"nodes\":[{}{{}}]", "{},".repeat(MANY)))),
        ("gltf", gltf(&format!("\"scenes\":[{{\"nodes\":[{}0]}}]", "0,".repeat(MANY)))),
        ("gltf", gltf(&format!("\"meshes\":[{}{{\"primitives\":[]}}]", "{\"primitives\":[]},".repeat(MANY)))),
        ("gltf", gltf(&format!("\"materials\":[{}{{}}]", "{},".repeat(MANY)))),
        ("gltf", gltf("\"buffers\":[{\"byteLength\":18446744073709551615,\"uri\":\"data:;base64,\"}]")),
        ("gltf", "[".repeat(MANY).into_bytes()),
        ("glb", [b"glTF\x02\0\0\0\xff\xff\xff\xff".as_slice(), &[255; 99]].concat()),
    ]
}

#[test]
fn loading_takes_at_most_a_small_multiple_of_the_file_size() {
    let folder = tempfile::tempdir().unwrap();
    for (extension, bytes) in files() {
        let path = folder.path().join("file").with_extension(extension);
        std::fs::write(&path, &bytes).unwrap();
        let (loaded, most) = peak_memory(|| read(&path));
        let start = String::from_utf8_lossy(&bytes[..bytes.len().min(300)]);
        let bound = Bound::MESH.of(bytes.len());
        assert!(
            most <= bound,
            "{most} bytes for a file of {} ({:?}), which begins with {start}",
            bytes.len(),
            loaded.is_ok()
        );
    }
}
