//! Contents of PLY files in every encoding.

use strahl_scene::mesh::TriangleMesh;

use crate::files::{SQUARE_PLY, groups, mesh, square};

#[test]
fn a_quadrilateral_is_two_triangles() {
    assert_eq!(mesh("ply", SQUARE_PLY), square());
}

#[test]
fn line_ends_comments_and_aliases_of_keywords_change_nothing() {
    let (header, data) = SQUARE_PLY.split_once("end_header\n").unwrap();
    for text in [
        SQUARE_PLY.replace('\n', "\r\n"),
        SQUARE_PLY.replace("vertex_indices", "vertex_index"),
        SQUARE_PLY.replace("float", "double").replace("uchar int", "uint8 uint16"),
        SQUARE_PLY.replace("float x", "float32 x").replace("uchar int", "int uint32"),
        header.replace("ascii 1.0\n", "ascii 1.0\ncomment end_header\nobj_info a b\n")
            + "end_header\n"
            + data,
        format!("{header}end_header\n{}", data.replace(' ', "\n")),
        format!("{header}end_header\n{}", data.replace('\n', "  ")),
        format!("{header}end_header\n{}", data.replace("1 1 0", "1. +1e0 .0").replace('4', "04")),
    ] {
        assert_eq!(mesh("ply", &text), square(), "{text}");
    }
    let latin = SQUARE_PLY.replace("ascii 1.0\n", "ascii 1.0\ncomment caf?\n");
    let latin: Vec<u8> = latin.bytes().map(|byte| if byte == b'?' { 0xe9 } else { byte }).collect();
    assert_eq!(mesh("ply", latin), square());
}

/// A number of each type, in either byte order.
fn number(kind: &str, x: f64, big: bool) -> Vec<u8> {
    macro_rules! bytes {
        ($type:ty) => {
            if big { (x as $type).to_be_bytes().to_vec() } else { (x as $type).to_le_bytes().to_vec() }
        };
    }
    match kind {
        "char" => bytes!(i8),
        "uchar" => bytes!(u8),
        "short" => bytes!(i16),
        "ushort" => bytes!(u16),
        "int" => bytes!(i32),
        "uint" => bytes!(u32),
        "float" => bytes!(f32),
        _ => bytes!(f64),
    }
}

const WHOLE: [&str; 6] = ["char", "uchar", "short", "ushort", "int", "uint"];

#[test]
fn every_type_of_number_is_read_in_either_byte_order() {
    let corners = [[-5.0, 0.0, 1.0], [100.0, 2.0, -3.0], [7.0, 8.0, 9.0]];
    for big in [false, true] {
        let order = if big { "big" } else { "little" };
        for coordinate in ["char", "short", "int", "float", "double"] {
            for (length, index) in WHOLE.iter().flat_map(|l| WHOLE.iter().map(move |i| (*l, *i))) {
                // Unused properties around the used ones, and an unused element between.
                let mut file = format!(
                    "ply\nformat binary_{order}_endian 1.0\nelement vertex 3\nproperty double before\n\
                     property {coordinate} x\nproperty list uchar short many\nproperty {coordinate} y\n\
                     property {coordinate} z\nelement edge 2\nproperty uchar a\nelement void 4000000000\n\
                     element face 2\nproperty list {length} {index} vertex_indices\nproperty uchar after\nend_header\n"
                )
                .into_bytes();
                for corner in corners {
                    file.extend(number("double", f64::NAN, big));
                    file.extend(number(coordinate, corner[0], big));
                    file.extend([2, 9, 9, 9, 9]);
                    file.extend(number(coordinate, corner[1], big));
                    file.extend(number(coordinate, corner[2], big));
                }
                file.extend([255, 255]);
                for face in [[0.0, 1.0, 2.0], [2.0, 1.0, 0.0]] {
                    file.extend(number(length, 3.0, big));
                    face.iter().for_each(|corner| file.extend(number(index, *corner, big)));
                    file.push(255);
                }
                let expected = TriangleMesh {
                    vertices: corners.map(|corner| corner.map(|x| x as f32)).to_vec(),
                    triangles: vec![[0, 1, 2], [2, 1, 0]],
                    groups: groups(&[(2, None)]),
                    ..TriangleMesh::default()
                };
                assert_eq!(mesh("ply", &file), expected, "{order} {coordinate} {length} {index}");
            }
        }
    }
}

#[test]
fn normals_are_read_if_all_three_properties_exist() {
    let with = |names: &[&str]| {
        let properties: String = names.iter().map(|name| format!("property float {name}\n")).collect();
        let header = SQUARE_PLY.replace("property float z\n", &format!("property float z\n{properties}"));
        let mut text = header;
        for point in ["\n0 0 0\n", "\n1 0 0\n", "\n1 1 0\n", "\n0 1 0\n"] {
            let numbers: Vec<_> = ["0.5", "0", "2"][..names.len()].to_vec();
            text = text.replace(point, &format!("{} {}\n", point.trim_end(), numbers.join(" ")));
        }
        mesh("ply", text)
    };
    assert_eq!(with(&["nx", "ny", "nz"]), TriangleMesh { normals: vec![[0.5, 0.0, 2.0]; 4], ..square() });
    assert_eq!(with(&["nx", "ny"]), square());
}

#[test]
fn skipped_features_are_warnings() {
    let text = SQUARE_PLY
        .replace("property float z\n", "property float z\nproperty uchar red\n")
        .replace(" 0\n", " 0 255\n")
        .replace("face 1", "face 2")
        .replace("4 0 1", "2 0 1 4 0 1")
        .replace("end_header", "element tristrips 0\nproperty list int int vertex_indices\nend_header");
    let it = mesh("ply", text);
    assert_eq!(
        it.warnings,
        [
            "the colors of element `vertex` are ignored",
            "triangle strips are skipped",
            "faces with fewer than three vertices are skipped (1, in line 17)",
        ]
    );
}
