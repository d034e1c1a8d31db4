//! Contents of glTF files.

use strahl_core::scene::FresnelModel;
use strahl_core::{Material, Rgb};
use strahl_scene::mesh::TriangleMesh;

use crate::files::{PLAIN, glb, gltf_of, gltf_with, groups, mesh, read_with, square, square_bytes};

#[test]
fn buffers_may_be_data_uris_files_or_the_binary_chunk() {
    assert_eq!(mesh("gltf", gltf_of(PLAIN)), square());
    let beside = gltf_with(r#""uri":"a%20b.bin","#, PLAIN);
    assert_eq!(read_with("f.gltf", beside.as_bytes(), &[("a b.bin", &square_bytes())]), square());
    assert_eq!(mesh("glb", glb(&gltf_with("", PLAIN), Some(&square_bytes()))), square());
    // The file may be longer than its header declares.
    let longer = [square_bytes(), vec![7; 9]].concat();
    assert_eq!(mesh("glb", glb(&gltf_with("", PLAIN), Some(&longer))), square());
    assert_eq!(mesh("glb", glb(&gltf_of(PLAIN), None)), square());
    // The container is detected by its first bytes, not by its name.
    assert_eq!(mesh("gltf", glb(&gltf_of(PLAIN), None)), square());
}

#[test]
fn a_gltf_file_without_scenes_has_its_root_nodes() {
    let text = gltf_of(
        r#""nodes":[{"mesh":0},{"children":[0],"translation":[0,0,5]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":2}]}]"#,
    );
    let points = square().vertices.iter().map(|[x, y, _]| [*x, *y, 5.0]).collect();
    assert_eq!(mesh("gltf", text), TriangleMesh { vertices: points, ..square() });
}

#[test]
fn nodes_transform_their_children() {
    // Parent: a rotation by 90 degrees about z, then 10 along x. Child: a scale of 2 along x.
    let s = std::f64::consts::FRAC_1_SQRT_2;
    let text = gltf_of(&format!(
        r#""scenes":[{{"nodes":[1]}}],"nodes":[{{"mesh":0,"scale":[2,1,1]}},
        {{"children":[0],"rotation":[0,0,{s},{s}],"translation":[10,0,0]}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1}},"indices":2}}]}}]"#
    ));
    let it = mesh("gltf", text);
    for (point, expected) in
        it.vertices.iter().zip([[10.0, 0.0, 0.0], [10.0, 2.0, 0.0], [9.0, 2.0, 0.0], [9.0, 0.0, 0.0]])
    {
        for (x, e) in point.iter().zip(expected) {
            assert!((x - e).abs() <= 1e-6, "{point:?}");
        }
    }
    assert_eq!(it.normals, [[0.0, 0.0, 1.0]; 4]);
    assert_eq!(it.triangles, square().triangles);
}

#[test]
fn normals_stay_perpendicular_under_nonuniform_scales_and_mirroring_reverses_triangles() {
    // A shear: z grows with y, so the normal is tilted back; x is mirrored.
    let text = gltf_of(
        r#""nodes":[{"mesh":0,"matrix":[-3,0,0,0, 0,1,1,0, 0,0,1,0, 0,0,0,1]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2}]}]"#,
    );
    let it = mesh("gltf", text);
    assert_eq!(it.vertices, [[0.0, 0.0, 0.0], [-3.0, 0.0, 0.0], [-3.0, 1.0, 1.0], [0.0, 1.0, 1.0]]);
    assert_eq!(
        it.triangles,
        [[0, 1, 2], [0, 3, 1]].map(|t: [u32; 3]| match t {
            // Each triangle is reversed, so that its front stays its front; vertices are numbered in the order of
            // their first use.
            [0, 1, 2] => [0, 2, 1],
            _ => [0, 3, 2],
        })
    );
    let half = std::f32::consts::FRAC_1_SQRT_2;
    for normal in &it.normals {
        assert!((normal[1] + half).abs() < 1e-6 && (normal[2] - half).abs() < 1e-6, "{normal:?}");
    }
}

#[test]
fn strips_and_fans_are_triangulated_and_lines_are_skipped() {
    let with = |mode: u32| {
        gltf_of(&format!(
            r#""nodes":[{{"mesh":0}},{{"mesh":1}}],"meshes":[
            {{"primitives":[{{"attributes":{{"POSITION":0}},"mode":{mode}}}]}},
            {{"primitives":[{{"attributes":{{"POSITION":0}},"mode":1}}]}}]"#
        ))
    };
    let strip = mesh("gltf", with(5));
    let places = |it: &TriangleMesh| {
        it.triangles.iter().map(|t| t.map(|c| it.vertices[c as usize])).collect::<Vec<_>>()
    };
    let [a, b, c, d] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(places(&strip), [[a, b, c], [b, d, c]]);
    assert_eq!(strip.warnings, ["point and line primitives are skipped (1)"]);
    assert_eq!(places(&mesh("gltf", with(6))), [[b, c, a], [c, d, a]]);
}

#[test]
fn a_gltf_mesh_may_have_many_instances() {
    let text = gltf_of(
        r#""scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"translation":[0,0,1]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":2,"material":1},
        {"attributes":{"POSITION":0},"indices":2}]}],"materials":[{},{"name":"two"}]"#,
    );
    let it = mesh("gltf", text);
    assert_eq!(it.groups, groups(&[(2, Some(1)), (2, None), (2, Some(1)), (2, None)]));
    assert_eq!((it.vertices.len(), it.triangles.len()), (16, 8));
    assert_eq!(it.vertices[8], [0.0, 0.0, 1.0]);
    let names: Vec<_> = it.materials.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["material 0", "two"]);
}

#[test]
fn gltf_materials_are_converted_to_the_closest_material() {
    let text = gltf_of(&format!(
        r#"{PLAIN},"materials":[{{}},
        {{"pbrMetallicRoughness":{{"baseColorFactor":[1,0.5,0.25,1],"metallicFactor":1,"roughnessFactor":0.25}}}},
        {{"pbrMetallicRoughness":{{"baseColorFactor":[1,0.5,0.25,0.25],"metallicFactor":0,"roughnessFactor":0.5}},
          "alphaMode":"BLEND"}},
        {{"pbrMetallicRoughness":{{"metallicFactor":0,"roughnessFactor":0,"baseColorTexture":{{"index":0}}}},
          "emissiveFactor":[1,0,0],"extensions":{{"KHR_materials_transmission":{{"transmissionFactor":1}},
          "KHR_materials_ior":{{"ior":1.25}}}}}}]"#
    ));
    let it = mesh("gltf", text);
    let base = Rgb::new(1.0, 0.5, 0.25);
    let rough =
        Material { highlight: Rgb::BLACK, highlight_exponent: 0.0, ambient: Rgb::WHITE, ..Material::MATTE };
    let metal = Material {
        ambient: base * 0.25,
        diffuse: base * 0.25,
        highlight: base * 0.75,
        highlight_exponent: 510.0,
        reflection: base * 0.75,
        ..Material::MATTE
    };
    let veil = Material {
        ambient: base * 0.25,
        diffuse: base * 0.25,
        highlight: Rgb::gray(0.25),
        highlight_exponent: 30.0,
        transmission: Rgb::gray(0.75),
        ..Material::MATTE
    };
    let glass = Material {
        ambient: Rgb::BLACK,
        diffuse: Rgb::BLACK,
        highlight: Rgb::gray(0.5),
        highlight_exponent: 10_000.0,
        transmission: Rgb::WHITE,
        refractive_index: 1.25,
        fresnel: FresnelModel::Dielectric,
        ..Material::MATTE
    };
    assert_eq!(it.materials.iter().map(|(_, m)| *m).collect::<Vec<_>>(), [rough, metal, veil, glass]);
    assert_eq!(it.warnings, ["textures are ignored (1)", "emission is ignored (1)"]);
}
