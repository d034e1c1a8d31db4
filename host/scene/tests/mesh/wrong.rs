//! Errors of invalid files.

use strahl_scene::LoadError;

use crate::files::{
    Folder, PLAIN, SQUARE_OBJ, SQUARE_PLY, failure, glb, gltf_of, gltf_with, is_named, refused, square_bytes,
};

#[test]
fn a_missing_file_and_an_unknown_extension_are_different_errors() {
    let folder = Folder::of(&[("file.stl", b"solid")]);
    let missing = strahl_scene::mesh::read(&folder.path("none.obj")).unwrap_err();
    assert!(matches!(&missing, LoadError::Unreadable { path, .. } if is_named(path, "none.obj")));
    assert!(matches!(missing, LoadError::Unreadable { .. }));
    for failure in [
        strahl_scene::mesh::read(&folder.path("file.stl")).unwrap_err(),
        strahl_scene::load(&folder.path("file.stl")).unwrap_err(),
    ] {
        assert!(matches!(failure, LoadError::Invalid { .. } | LoadError::Diagnostics(_)));
        let text = failure.to_string();
        assert!([".obj", ".ply", ".gltf", ".glb"].iter().all(|name| text.contains(name)), "{text}");
    }
}

#[test]
fn an_invalid_obj_file_is_rejected_with_its_line_and_the_reason() {
    for (text, line, expected) in [
        ("", None, "contains no triangles"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\n", None, "contains no triangles"),
        ("# a\nv 0 0 0\n\0", Some(3), "not a text file"),
        ("v 0 0", Some(1), "a vertex needs 3 numbers"),
        ("\nv 0 0 x", Some(2), "a vertex must be a number, not `x`"),
        ("v 0 nan 0", Some(1), "a coordinate must be finite, not NaN"),
        ("v 0 -inf 0", Some(1), "a coordinate must be finite, not -inf"),
        ("v 0 1e16 0", Some(1), "a coordinate must be between -1000000000000000 and 1000000000000000"),
        ("v 1e400 0 0", Some(1), "a coordinate must be finite, not inf"),
        ("vn 0 0", Some(1), "a normal needs 3 numbers"),
        (
            "v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0",
            Some(3),
            "vertex 3 does not exist; 2 are defined above this line",
        ),
        ("v 0 0 0\nf 1 0 1", Some(2), "vertex 0 does not exist; 1 are defined above this line"),
        ("v 0 0 0\nf 1 -2 1", Some(2), "vertex -2 does not exist; 1 are defined above this line"),
        ("v 0 0 0\nf 1//1 1 1", Some(2), "normal 1 does not exist; 0 are defined above this line"),
        (
            "v 0 0 0\nf 1 1 \\\n\\\n 99999999999999999999",
            Some(2),
            "`99999999999999999999` is not a face vertex",
        ),
        ("v 0 0 0\nf 1 9223372036854775807 1", Some(2), "vertex 9223372036854775807 does not exist"),
        ("v 0 0 0\nf -9223372036854775808 1 1", Some(2), "vertex -9223372036854775808"),
        ("v 0 0 0\nf 1/1/1/1 1 1", Some(2), "`1/1/1/1` is not a face vertex"),
        ("v 0 0 0\nf 1/a 1 1", Some(2), "`1/a` is not a face vertex"),
        ("v 0 0 0\nf 1.0 1 1", Some(2), "`1.0` is not a face vertex"),
        ("v 0 0 0\nf / 1 1", Some(2), "`/` is not a face vertex"),
    ] {
        let (found, reason) = refused("obj", text);
        assert_eq!(found, line, "{reason}\n{text}");
        assert!(reason.contains(expected), "`{expected}` is not in `{reason}`\n{text}");
    }
}

/// The square in PLY, with a part of its text replaced.
fn ply(from: &str, to: &str) -> Vec<u8> {
    assert!(SQUARE_PLY.contains(from), "{from}");
    SQUARE_PLY.replacen(from, to, 1).into_bytes()
}

#[test]
fn an_invalid_ply_file_is_rejected_with_its_line_and_the_reason() {
    for (bytes, line, expected) in [
        (Vec::new(), Some(1), "does not begin with `ply`"),
        (b"plyx\n".to_vec(), Some(1), "does not begin with `ply`"),
        (b"ply\nformat ascii 1.0\n".to_vec(), Some(3), "the file ends inside its header"),
        (b"ply\nend_header\n".to_vec(), Some(2), "the header has no `format`"),
        (ply("ascii", "text"), Some(2), "the format `text` is not ascii"),
        (
            ply("element vertex", "property int a\nelement vertex"),
            Some(3),
            "a property before the first element",
        ),
        (ply("vertex 4", "vertex -4"), Some(3), "invalid count `-4` of element `vertex`"),
        (ply("vertex 4", "vertex 99999999999999999999"), Some(3), "invalid count `99999999999999999999`"),
        (ply("vertex 4", "vertex 4000000000"), Some(3), "take at least 6 bytes each, but 34 bytes are left"),
        (ply("vertex 4", "vertex 18446744073709551615"), Some(3), "take at least 6 bytes each"),
        (ply("face 1", "face 40"), Some(7), "40 elements `face` take at least 2 bytes each, but 11 bytes"),
        (ply("face 1", "vertex 1"), Some(7), "duplicate element `vertex`"),
        (ply("float x", "real x"), Some(4), "unknown type `real`"),
        (ply("float x", "float y"), Some(5), "missing or duplicate property name `y`"),
        (ply("float x", "float"), Some(4), "missing or duplicate property name ``"),
        (ply("float x", "float w"), Some(3), "needs the properties x, y and z"),
        (ply("float x", "list int float x"), Some(3), "needs the properties x, y and z"),
        (ply("uchar int", "float int"), Some(8), "the count type of a list must be an integer type"),
        (ply("uchar int", "uchar float"), Some(7), "needs an integer list `vertex_indices`"),
        (ply("vertex_indices", "corners"), Some(7), "needs an integer list `vertex_indices`"),
        (ply("element vertex 4", "element point 4"), Some(7), "faces come before the vertices"),
        (ply("end_header", "end"), Some(9), "unknown header line `end`"),
        (ply("1 1 0", "1 x 0"), Some(12), "`vertex` 2 of 4: `x` is not a number"),
        (ply("1 1 0", "1 nan 0"), Some(12), "a coordinate must be finite, not NaN"),
        (ply("1 1 0", "1 1e16 0"), Some(12), "a coordinate must be between"),
        (ply("4 0 1 2 3", "4 0 1 2 4"), Some(14), "`face` 0 of 1: vertex 4 does not exist"),
        (ply("4 0 1 2 3", "4 0 1 2 -1"), Some(14), "vertex -1 does not exist"),
        (ply("4 0 1 2 3", "4 0 1 2 1.5"), Some(14), "vertex 1.5 does not exist"),
        (ply("4 0 1 2 3", "4 0 1 2"), Some(14), "unexpected end of file"),
        (ply("4 0 1 2 3", "-3 0 1 2"), Some(14), "invalid list length -3"),
        (ply("4 0 1 2 3", "1e9 0 1 2"), Some(14), "invalid list length 1000000000"),
        (ply("4 0 1 2 3", "nan 0 1 2"), Some(14), "invalid list length NaN"),
        (ply("face 1", "face 0"), None, "contains no triangles"),
    ] {
        let text = String::from_utf8_lossy(&bytes);
        let (found, reason) = refused("ply", &bytes);
        assert!(reason.contains(expected), "`{expected}` is not in `{reason}`\n{text}");
        assert_eq!(found, line, "{reason}\n{text}");
    }
}

#[test]
fn a_truncated_binary_ply_file_is_rejected_with_its_byte() {
    let header = SQUARE_PLY.replace("ascii", "binary_little_endian");
    let header = &header[..header.find("end_header").unwrap() + 11];
    let mut file = header.as_bytes().to_vec();
    file.extend(crate::files::floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]));
    file.push(4);
    file.extend([0, 1, 2, 3].iter().flat_map(|i: &i32| i.to_le_bytes()));
    assert_eq!(crate::files::mesh("ply", &file), crate::files::square());
    for end in header.len()..file.len() {
        let (line, reason) = refused("ply", &file[..end]);
        let is_promise = reason.contains("bytes are left in the file");
        assert!(line.is_some() == is_promise, "{reason}");
        assert!(is_promise || reason.contains("before byte "), "{reason}");
    }
    let mut wrong = file.clone();
    let place = wrong.len() - 4;
    wrong[place] = 9;
    let expected = format!("`face` 0 of 1 before byte {}: vertex 9 does not exist", file.len());
    assert_eq!(refused("ply", wrong), (None, expected));
}

#[test]
fn an_invalid_gltf_file_is_rejected_with_the_location_and_the_reason() {
    let plain = gltf_of(PLAIN);
    let with = |from: &str, to: &str| {
        assert!(plain.contains(from), "{from}");
        plain.replacen(from, to, 1)
    };
    for (text, line, expected) in [
        (String::new(), Some(1), "EOF while parsing a value"),
        ("{\n\"nodes\":[}".into(), Some(2), "expected value"),
        ("[]".into(), None, "contains no triangles"),
        ("{}".into(), None, "contains no triangles"),
        (
            with("\"asset\"", r#""extensionsRequired":["KHR_draco"],"asset""#),
            None,
            "requires the unsupported extension `KHR_draco`",
        ),
        (with("\"scene\":0", "\"scene\":1"), None, "scenes[1] does not exist"),
        (with("\"nodes\":[0]", "\"nodes\":[7]"), None, "nodes[7] does not exist"),
        (with("\"nodes\":[0]", "\"nodes\":[0,0]"), None, "nodes[0] has two parents"),
        (with("{\"mesh\":0}", r#"{"mesh":0,"children":[0]}"#), None, "nodes[0] has two parents"),
        (with("{\"mesh\":0}", r#"{"mesh":3}"#), None, "nodes[0]: meshes[3] does not exist"),
        (with("{\"mesh\":0}", r#"{"mesh":0,"rotation":[0,0,0,0]}"#), None, "the transform is not finite"),
        (
            with("{\"mesh\":0}", r#"{"mesh":0,"scale":[1e300,1,1]}"#),
            None,
            "a coordinate must be finite, not inf",
        ),
        (
            with("{\"mesh\":0}", r#"{"mesh":0,"translation":[2e15,0,0]}"#),
            None,
            "a coordinate must be between",
        ),
        (with("{\"mesh\":0}", r#"{"mesh":0,"matrix":[1,2]}"#), Some(1), "invalid length 2"),
        (
            with("\"POSITION\":0", "\"POSITION\":9"),
            None,
            "meshes[0].primitives[0]: accessors[9] does not exist",
        ),
        (
            with("\"POSITION\":0", "\"POSITION\":2"),
            None,
            "accessors[2]: has type `SCALAR` and component type 5123",
        ),
        (with("\"POSITION\":0", "\"NORMAL\":1"), None, "has no POSITION"),
        (with("\"indices\":2", "\"indices\":0"), None, "accessors[0]: has type `VEC3`"),
        (with("\"indices\":2", "\"indices\":2,\"mode\":9"), None, "`mode` is 9"),
        (with("\"indices\":2", "\"indices\":2,\"material\":0"), None, "materials[0] does not exist"),
        (with("\"count\":6", "\"count\":5"), None, "5 vertices are not a multiple of 3"),
        (with("\"count\":6", "\"count\":9"), None, "accessors[2]: extends beyond bufferViews[2]"),
        (with("\"count\":6", "\"count\":18446744073709551615"), None, "extends beyond bufferViews[2]"),
        (with("\"count\":4", "\"count\":3"), None, "index 5 refers to vertex 3, but there are 3"),
        (with("\"bufferView\":0", "\"bufferView\":7"), None, "bufferViews[7] does not exist"),
        (with("\"bufferView\":0,", ""), None, "accessors[0]: has no `bufferView`"),
        (
            with("\"bufferView\":0", "\"sparse\":{},\"bufferView\":0"),
            None,
            "sparse accessors are not supported",
        ),
        (with("\"byteLength\":48", "\"byteLength\":480"), None, "bufferViews[0] extends beyond its buffer"),
        (
            with("\"byteLength\":48", "\"byteOffset\":18446744073709551615,\"byteLength\":48"),
            None,
            "extends beyond",
        ),
        (
            with("\"byteLength\":48", "\"byteLength\":48,\"byteStride\":4"),
            None,
            "extends beyond bufferViews[0]",
        ),
        (
            with("\"byteLength\":48", "\"byteLength\":48,\"byteStride\":18446744073709551615"),
            None,
            "extends beyond",
        ),
        (
            with("\"byteLength\":108", "\"byteLength\":109"),
            None,
            "buffers[0]: has 108 bytes; `byteLength` says 109",
        ),
        (with(";base64", ""), None, "buffers[0]: the data URI is not base64"),
        (with(";base64,", ";base64,*"), None, "buffers[0]: invalid base64 in the data URI"),
        (gltf_with("", PLAIN), None, "buffers[0]: has no `uri`, and the file has no binary chunk"),
        (gltf_with(r#""uri":"web://host/a.bin","#, PLAIN), None, "only local files are read"),
        (
            gltf_of(&format!(r#"{PLAIN},"materials":[{{"pbrMetallicRoughness":{{"metallicFactor":2}}}}]"#)),
            None,
            "materials[0]: a factor",
        ),
    ] {
        let (found, reason) = refused("gltf", &text);
        assert!(reason.contains(expected), "`{expected}` is not in `{reason}`\n{text}");
        assert_eq!(found, line, "{reason}\n{text}");
    }
}

#[test]
fn a_missing_buffer_is_named() {
    let text = gltf_with(r#""uri":"none.bin","#, PLAIN);
    let (failure, _) = failure("file.gltf", text.as_bytes(), &[]);
    assert!(
        matches!(&failure, LoadError::Unreadable { path, .. } if is_named(path, "none.bin")),
        "{failure}"
    );
    assert!(matches!(failure, LoadError::Unreadable { .. }));
}

#[test]
fn a_truncated_glb_file_is_rejected() {
    let file = glb(&gltf_with("", PLAIN), Some(&square_bytes()));
    for end in 0..file.len() {
        refused("glb", &file[..end]);
        // The same, with the length in the header adapted.
        let mut cut = file[..end].to_vec();
        if end >= 12 {
            cut[8..12].copy_from_slice(&(end as u32).to_le_bytes());
        }
        refused("glb", cut);
    }
}

#[test]
fn too_many_instances_are_rejected() {
    // 100,000 nodes of a mesh of 200 parts: 40 million triangles out of two megabytes.
    let part = r#"{"attributes":{"POSITION":0},"indices":2},"#.repeat(200);
    let nodes = r#"{"mesh":0},"#.repeat(100_000);
    let text = gltf_of(&format!(
        r#""nodes":[{}],"meshes":[{{"primitives":[{}]}}]"#,
        nodes.trim_end_matches(','),
        part.trim_end_matches(',')
    ));
    let (_, reason) = refused("gltf", text);
    assert!(reason.contains("more than 16777216 vertices, triangles or primitives"), "{reason}");
}

#[test]
fn error_messages_are_one_short_line() {
    for bytes in
        [format!("v {}\u{7}\u{7}", "9".repeat(500)), format!("{SQUARE_OBJ}f {}\u{1b}[3m", "x".repeat(900))]
    {
        let (_, reason) = refused("obj", bytes);
        assert!(!reason.contains(|c: char| c.is_control()) && reason.chars().count() < 200, "{reason:?}");
    }
}
