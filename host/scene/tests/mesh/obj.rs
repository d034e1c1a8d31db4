//! Contents of OBJ files and their material libraries.

use strahl_core::scene::FresnelModel;
use strahl_core::{Material, Rgb};
use strahl_scene::mesh::TriangleMesh;

use crate::files::{SQUARE_OBJ, groups, is_named, mesh, read_with, square};

#[test]
fn a_quadrilateral_is_two_triangles() {
    assert_eq!(mesh("obj", SQUARE_OBJ), square());
}

#[test]
fn line_ends_comments_continuations_and_relative_indices_change_nothing() {
    for text in [
        SQUARE_OBJ.replace('\n', "\r\n"),
        SQUARE_OBJ.replace(' ', "\t "),
        SQUARE_OBJ.replace('\n', "  # v 7 7 7\n\n"),
        SQUARE_OBJ.replace("1 2 3 4", "1 2 \\\n3\\\r\n 4"),
        SQUARE_OBJ.replace("1 2 3 4", "-4 -3 -2 -1"),
        SQUARE_OBJ.replace("1 2 3 4", "1/7 2/8/ 3/-9 4//"),
        SQUARE_OBJ.replace("v 1 1 0", "v 1. +1e0 -0.0 1.0"),
        format!("\u{feff}# caf\u{e9}\no thing\ng one two\ns off\nvt 0 0\n{SQUARE_OBJ}"),
        SQUARE_OBJ.trim_end().to_owned(),
    ] {
        assert_eq!(mesh("obj", &text), square(), "{text}");
    }
    let latin = [b"# caf\xe9\n", SQUARE_OBJ.as_bytes()].concat();
    assert_eq!(mesh("obj", latin), square());
}

#[test]
fn vertices_with_equal_position_and_normal_are_shared() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nv 1 1 0\nvn 0 0 2\nvn 1 0 0\n\
        f 1//1 2//1 3//1\nf 3//1 2//1 5//1\nf 1//2 3//2 2//1\n";
    let expected = TriangleMesh {
        vertices: vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
        ],
        normals: [[[0.0, 0.0, 2.0]; 4].as_slice(), &[[1.0, 0.0, 0.0]; 2]].concat(),
        triangles: vec![[0, 1, 2], [2, 1, 3], [4, 5, 1]],
        groups: groups(&[(3, None)]),
        ..TriangleMesh::default()
    };
    assert_eq!(mesh("obj", text), expected);
}

#[test]
fn vertices_without_a_normal_get_that_of_their_triangle_if_others_have_one() {
    // The second face is in the xz plane; the normal of the third one is zero.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 1 1\nvn 0 0 0\nvn nan 0 1\n\
        f 1//1 2//1 3//1\nf 1 2 4\nf 1//2 2//3 3\nf 1 3 2\n";
    let it = mesh("obj", text);
    assert_eq!(it.triangles[..2], [[0, 1, 2], [3, 4, 5]]);
    assert_eq!(it.normals[..6], [[[0.0, 1.0, 1.0]; 3], [[0.0, -1.0, 0.0]; 3]].concat());
    assert_eq!(it.normals.len(), it.vertices.len());
    for corner in it.triangles[2] {
        assert_eq!(it.normals[corner as usize], [0.0, 0.0, 1.0]);
    }
    // It shares vertices without a normal with the second and the third, which have other orientations.
    for (corner, place) in it.triangles[3].into_iter().zip([[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]) {
        assert_eq!(it.normals[corner as usize], [0.0, 0.0, -1.0]);
        assert_eq!(it.vertices[corner as usize], place);
    }
    let expected = "zero or non-finite normals are replaced by face normals (2)";
    assert_eq!(it.warnings, [expected]);
}

#[test]
fn triangles_without_area_keep_their_index_and_are_counted() {
    let it = mesh("obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 1 1 1\n");
    assert_eq!(it.triangles, [[0, 1, 2], [0, 1, 3], [0, 0, 0]]);
    assert_eq!(it.warnings, ["2 triangles have zero area and are never hit"]);
}

#[test]
fn skipped_features_are_counted_by_kind_with_their_first_line() {
    let it = mesh("obj", format!("{SQUARE_OBJ}l 1 2\np 1\nf 1 2\nv 0 0 0 1 1 1\nbevel on\nbevel off\n"));
    assert_eq!(
        it.warnings,
        [
            "lines and points are skipped (2, the first in line 6)",
            "faces with fewer than three vertices are skipped (1, in line 8)",
            "vertex colors are ignored (1, in line 9)",
            "unknown keyword `bevel` is ignored (2, the first in line 10)",
        ]
    );
}

const LIBRARY: &str = "# two\nnewmtl red paint\nKa 1 1 1\nKd 0.5 0.25 0\nKs 0.5 0.5 0.5\nNs 20\nillum 2\n\
    newmtl mirror#2\nKd 0 0 0\nKs 0.75 0.5 2\nNs 1000\nillum 3\nmap_Kd wood.png\n\
    newmtl glass\nKd 1 1 1\nKs 0 0 0\nd 0.25\nTf 1 0.5 1\nNi 1.5\nillum 7\n\
    newmtl veil\nKd 0.5\nTr 0.75\nNi 1.5\nillum 1\nKs 1 1 1\nNs 5\n";

#[test]
fn materials_group_the_triangles() {
    let face = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let text = format!(
        "mtllib my colours.mtl\n{face}f 1 2 3\nusemtl glass\nf 1 2 3\nf 1 3 2\nusemtl mirror#2\n\
         usemtl red paint # and not the mirror\ng other\nf 1 2 3\nusemtl none\nf 1 2 3\n"
    );
    let it = read_with("file.obj", text.as_bytes(), &[("my colours.mtl", LIBRARY.as_bytes())]);
    assert_eq!(it.groups, groups(&[(1, None), (2, Some(2)), (1, Some(0)), (1, None)]));
    let names: Vec<_> = it.materials.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["red paint", "mirror#2", "glass", "veil"]);
    let paint = Material {
        ambient: Rgb::new(0.5, 0.25, 0.0),
        diffuse: Rgb::new(0.5, 0.25, 0.0),
        highlight: Rgb::gray(0.5),
        highlight_exponent: 20.0,
        ..Material::MATTE
    };
    let mirror = Material {
        ambient: Rgb::BLACK,
        diffuse: Rgb::BLACK,
        highlight: Rgb::new(0.75, 0.5, 2.0),
        highlight_exponent: 1000.0,
        reflection: Rgb::new(0.75, 0.5, 1.0),
        ..Material::MATTE
    };
    let glass = Material {
        ambient: Rgb::gray(0.25),
        diffuse: Rgb::gray(0.25),
        transmission: Rgb::new(0.75, 0.375, 0.75),
        refractive_index: 1.5,
        fresnel: FresnelModel::Dielectric,
        ..Material::MATTE
    };
    let veil = Material {
        ambient: Rgb::gray(0.125),
        diffuse: Rgb::gray(0.125),
        transmission: Rgb::gray(0.75),
        ..Material::MATTE
    };
    let expected = [paint, mirror, glass, veil];
    assert_eq!(it.materials.iter().map(|(_, material)| *material).collect::<Vec<_>>(), expected);
    assert_eq!(
        it.warnings,
        ["textures are ignored (1)", "material `none` is not in any library (1, in line 13)",]
    );
}

#[test]
fn a_line_may_name_several_libraries_and_a_missing_one_is_a_warning() {
    let text = format!("usemtl b\n{SQUARE_OBJ}mtllib one.mtl two.mtl three.mtl\nmtllib one.mtl\n");
    let it = read_with(
        "file.obj",
        text.as_bytes(),
        &[("one.mtl", b"newmtl a"), ("two.mtl", b"newmtl b\nnewmtl a")],
    );
    assert_eq!(it.groups, groups(&[(2, Some(1))]));
    assert_eq!(it.materials.len(), 3);
    assert_eq!(it.warnings.len(), 1);
    assert!(
        it.warnings[0].starts_with("cannot read material library `three.mtl` (line 7): "),
        "{:?}",
        it.warnings
    );
}

#[test]
fn an_invalid_library_is_rejected_with_its_path_and_line() {
    for (library, to_blame, expected) in [
        ("newmtl", 1, "the material has no name"),
        ("Kd 1 1 1", 1, "`Kd` comes before the first `newmtl`"),
        ("newmtl a\n\nKd 1 1", 3, "a color needs 3 numbers"),
        ("newmtl a\nKd spectral a.rfl", 2, "only RGB colors are supported"),
        ("newmtl a\nKd 1 -1 1", 2, "a color must be 0 to 1000000, not -1"),
        ("newmtl a\nKd 1 nan 1", 2, "a color must be 0 to 1000000, not NaN"),
        ("newmtl a\nNs x", 2, "its value must be a number, not `x`"),
        ("newmtl a\nd", 2, "`d` needs a number"),
        ("newmtl a\nd -halo 1.5", 2, "`d` must be 0 to 1, not 1.5"),
        ("newmtl a\nillum 300", 2, "must be a number, not `300`"),
    ] {
        let others = [("a.mtl", library.as_bytes())];
        match crate::files::failure("file.obj", format!("mtllib a.mtl\n{SQUARE_OBJ}").as_bytes(), &others) {
            (strahl_scene::LoadError::Invalid { path, line, reason }, _) => {
                assert!(is_named(&path, "a.mtl"), "{}", path.display());
                assert_eq!(line, Some(to_blame), "{library}");
                assert!(reason.contains(expected), "{reason}\n{library}");
            }
            (other, _) => panic!("{other}"),
        }
    }
}
