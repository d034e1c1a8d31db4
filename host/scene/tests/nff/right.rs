//! Contents of valid files.

use strahl_core::{Material, Resolution, Rgb};
use strahl_loader_tests::invalid_nff::VIEW;
use strahl_scene::LoadError;
use strahl_scene::description::{
    BackgroundDescription, CameraDescription, LightDescription, LightSourceDescription, Located,
    ObjectDescription, ProjectionDescription, ShapeDescription,
};
use strahl_session::tables;

use crate::text::{ALL, file_of, loaded, refused};

/// The scene of [`VIEW`] followed by this text.
fn after_view(text: &str) -> strahl_scene::description::LoadedScene {
    loaded(&format!("{VIEW}{text}"))
}

fn lamp(x: f32, y: f32, z: f32, color: Rgb) -> LightDescription {
    let source = LightSourceDescription::Point { position: [x, y, z], falloff: [1.0, 0.0, 0.0] };
    LightDescription { source, color, shadows: true }
}

fn flat(x: f32) -> String {
    format!("p 3 {x} 0 0 {x} 1 0 {x} 2 0\n")
}

#[test]
fn every_entity_is_loaded_as_the_format_describes() {
    let it = loaded(ALL);
    let view = CameraDescription {
        from: [0.0, -8.0, 1.0],
        at: [0.0, 0.0, 0.5],
        up: [0.0, 0.0, 1.0],
        projection: ProjectionDescription::Perspective(40.0),
    };
    assert_eq!(it.camera, view);
    assert_eq!(it.settings.size, Resolution::new(40, 30));
    assert_eq!(it.background, BackgroundDescription::Color(Rgb::new(0.125, 0.25, 0.5)));

    // sqrt(2) / 4 for two lights.
    let rule = Rgb::gray(0.353_553_39);
    let colored = lamp(-4.0, -3.0, 2.0, Rgb::new(1.0, 0.5, 0.25));
    assert_eq!(it.ambient, rule);
    assert_eq!(
        it.lights,
        [
            Located { value: lamp(4.0, -3.0, 2.0, rule), line: 10, name: None },
            Located { value: colored, line: 11, name: None }
        ]
    );

    let scattered = Rgb::new(0.5, 0.375, 0.25);
    let mirror = Material {
        ambient: scattered,
        diffuse: scattered,
        highlight: Rgb::gray(0.25),
        highlight_exponent: 8.0,
        reflection: Rgb::gray(0.25),
        ..Material::MATTE
    };
    let glass = Material {
        ambient: Rgb::BLACK,
        diffuse: Rgb::BLACK,
        highlight_exponent: 100_000.0,
        transmission: Rgb::gray(0.5),
        refractive_index: 1.5,
        ..Material::MATTE
    };
    assert_eq!(
        it.materials,
        [Located { value: mirror, line: 12, name: None }, Located { value: glass, line: 27, name: None }]
    );

    let objects = [
        (ShapeDescription::Sphere { center: [0.0; 3], radius: 1.0 }, 0, 13),
        (
            ShapeDescription::Cone {
                base: [0.0, 0.0, 1.0],
                base_radius: 0.5,
                end: [0.0, 0.0, 2.0],
                end_radius: 0.0,
                capped: false,
            },
            0,
            14,
        ),
        (ShapeDescription::Triangle { vertices: [0, 1, 2], smooth: false }, 0, 17),
        (ShapeDescription::Polygon { first: 3, count: 5, smooth: false }, 0, 21),
        (ShapeDescription::Triangle { vertices: [8, 9, 10], smooth: true }, 1, 28),
        (ShapeDescription::Polygon { first: 11, count: 4, smooth: true }, 1, 32),
    ];
    assert_eq!(
        it.objects,
        objects.map(|(shape, material, line)| ObjectDescription { shape, material, line })
    );

    assert_eq!(it.vertices.len(), 15);
    assert_eq!(it.vertices[..3], [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(it.vertices[6], [2.0, 1.0, 0.0]);
    assert_eq!(it.vertices[14], [0.0, 1.0, 0.0]);
    // A normal has the index of its vertex.
    assert_eq!(it.normals.len(), 15);
    assert_eq!(it.normals[8..11], [[0.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, -1.0, 1.0]]);
    assert_eq!(it.normals[14], [0.0, 1.0, 1.0]);
    assert_eq!(it.warnings, [""; 0]);
}

#[test]
fn a_loaded_scene_is_valid_in_both_precisions() {
    let it = loaded(ALL);
    let (single, double) = (tables::single::scene_tables(&it), tables::double::scene_tables(&it));
    assert_eq!(single.scene().unwrap().descriptor().geometry.shapes.len(), 6);
    assert_eq!(double.scene().unwrap().descriptor().geometry.shapes.len(), 6);
}

#[test]
fn an_empty_scene_is_a_scene() {
    let it = loaded("v from 0 0 9 at 0 0 0 up 0 1 0 angle 30 resolution 4 3");
    assert_eq!((it.objects.len(), it.materials.len(), it.lights.len()), (0, 0, 0));
    assert_eq!(it.background, BackgroundDescription::Color(Rgb::BLACK));
    assert!(tables::single::scene_tables(&it).scene().is_ok());
}

#[test]
fn line_ends_tabs_empty_lines_and_comments_change_nothing_but_line_numbers() {
    let it = loaded(ALL);
    assert_eq!(loaded(&ALL.replace('\n', "\r\n")), it);
    assert_eq!(loaded(&ALL.replace(' ', "\t")), it);
    assert_eq!(loaded(&ALL.replace('\n', "  # v s 1 2 x\n")), it);
    assert_eq!(loaded(ALL.trim_end()), it);

    let mut moved = it;
    moved.lights.iter_mut().for_each(|light| light.line *= 2);
    moved.materials.iter_mut().for_each(|material| material.line *= 2);
    moved.objects.iter_mut().for_each(|object| object.line *= 2);
    moved.setting_lines.values_mut().for_each(|line| *line *= 2);
    assert_eq!(loaded(&ALL.replace('\n', "\n\n").replacen("# a", "\n# a", 1)), moved);
}

#[test]
fn the_numbers_of_an_entity_may_be_in_any_lines() {
    let one = after_view("f 1 1 1 1 0 0 0 0\nc 1 2 3 4 5 6 7 8\n");
    let many = after_view("f 1 1 1 1 0 0 0 0\nc\n1\n2 3\n\n4 5 6\n7\n8\n");
    assert_eq!(one, many);
}

#[test]
fn the_keys_of_a_viewpoint_may_be_in_any_order_and_without_hither() {
    let mut it = loaded("v\nresolution 4 3\nangle 30\nup 0 1 0\nat 0 0 0\nfrom 0 0 9\n");
    assert_eq!(it.setting_lines["size"], 2);
    let usual = loaded(VIEW);
    it.setting_lines.clone_from(&usual.setting_lines);
    assert_eq!(it, usual);
}

#[test]
fn entities_may_be_in_any_order() {
    let first = loaded(&format!("b 0 0.5 1\nl 1 2 3\nf 1 0 0 1 0 0 0 0\ns 0 0 0 1\n{VIEW}"));
    let mut last = after_view("l 1 2 3\nf 1 0 0 1 0 0 0 0\ns 0 0 0 1\nb 0 0.5 1\n");
    assert_eq!(first.background, BackgroundDescription::Color(Rgb::new(0.0, 0.5, 1.0)));
    assert_eq!((last.lights[0].line, last.materials[0].line), (2, 3));
    last.lights[0].line = first.lights[0].line;
    last.materials[0].line = first.materials[0].line;
    last.objects[0].line = first.objects[0].line;
    last.setting_lines.clone_from(&first.setting_lines);
    assert_eq!(first, last);
}

#[test]
fn numbers_may_be_written_in_every_usual_way() {
    for (word, number) in [
        ("1.", 1.0),
        (".5", 0.5),
        ("1e-3", 0.001),
        ("+2", 2.0),
        ("-.25E+1", -2.5),
        ("007", 7.0),
        ("1e-60", 0.0),
        ("1e15", 1e15),
        ("-1e15", -1e15),
    ] {
        let it = after_view(&format!("f 1 1 1 1 0 0 0 0\ns {word} 0 0 1"));
        assert_eq!(
            it.objects[0].shape,
            ShapeDescription::Sphere { center: [number, 0.0, 0.0], radius: 1.0 },
            "{word}"
        );
    }
}

#[test]
fn a_number_is_rounded_once() {
    // Just above the midpoint between 1 and the next number in single precision, so it rounds up; via double
    // precision it would be rounded to the midpoint, and then to even, which is 1.
    let it = after_view("f 1 1 1 1 0 0 0 0\ns 1.0000000596046447753906250000001 0 0 1");
    assert_eq!(
        it.objects[0].shape,
        ShapeDescription::Sphere { center: [1.0 + f32::EPSILON, 0.0, 0.0], radius: 1.0 }
    );
}

#[test]
fn lights_without_a_color_have_the_intensity_of_the_databases() {
    assert_eq!(after_view("").ambient, Rgb::gray(0.5));
    for n in 1..=16 {
        let it = after_view(&"l 1 2 3\n".repeat(n));
        let expected = ((n as f64).sqrt() / (2 * n) as f64) as f32;
        assert_eq!(it.ambient, Rgb::gray(expected), "{n}");
        assert_eq!(it.lights.len(), n);
        assert!(it.lights.iter().all(|l| l.value.color == Rgb::gray(expected)), "{n}");
    }
}

#[test]
fn a_light_with_a_color_keeps_it_and_counts_in_the_number_of_lights() {
    let it = after_view("l 1 2 3\nl 1 2 3 0 1 0.5\nl 1 2 3 1e6 0 0\nl 1 2 3\n");
    let colors = [0.25, 0.0, 0.0, 0.25].map(Rgb::gray);
    let colors = [colors[0], Rgb::new(0.0, 1.0, 0.5), Rgb::new(1e6, 0.0, 0.0), colors[3]];
    assert_eq!(it.lights.iter().map(|l| l.value.color).collect::<Vec<_>>(), colors);
    assert_eq!(it.ambient, Rgb::gray(0.25));
}

#[test]
fn equal_materials_are_shared() {
    let it = after_view(
        "f 1 0 0 1 0 0 0 0\ns 0 0 0 1\nf 0 1 0 1 0 0 0 0\ns 0 0 0 2\nf 1.0 0 0 1 0 0 0 0\ns 0 0 0 3\n",
    );
    assert_eq!(it.objects.iter().map(|o| o.material).collect::<Vec<_>>(), [0, 1, 0]);
    assert_eq!(it.materials.iter().map(|m| m.line).collect::<Vec<_>>(), [2, 4]);
}

#[test]
fn a_scene_has_at_most_65536_materials() {
    let surface = |n: u32| format!("f {} {} 0 1 0 0 0 0\n", n % 256, n / 256);
    let text: String = (0..65_536).map(surface).collect();
    let it = after_view(&format!("{text}s 0 0 0 1\n{}s 0 0 0 2\n", surface(7)));
    assert_eq!(it.materials.len(), 65_536);
    assert_eq!(it.objects.iter().map(|o| o.material).collect::<Vec<_>>(), [65_535, 7]);
    let (line, reason) = refused(format!("{VIEW}{text}{}", surface(65_536)).as_bytes());
    assert_eq!((line, reason.as_str()), (65_538, "more than 65536 different materials"));
}

#[test]
fn an_opaque_surface_may_have_any_index_of_refraction() {
    for index in ["0", "-1", "1.5", "1e9"] {
        let it = after_view(&format!("f 1 1 1 1 0 0 0 {index}\n"));
        assert_eq!(it.materials[0].value.refractive_index, 1.0, "{index}");
        assert!(!it.materials[0].value.is_transmitting());
    }
}

#[test]
fn the_smallest_index_of_refraction_is_valid_in_both_precisions() {
    let it = after_view("f 1 1 1 1 0 0 0.5 0.01\n");
    assert_eq!(tables::single::scene_tables(&it).scene().err(), None);
    assert!(tables::double::scene_tables(&it).scene().is_ok());
}

#[test]
fn a_diffuse_color_is_clamped_to_the_maximum_channel() {
    let it = after_view("f 1e6 1 0 10 0 0 0 0\n");
    assert_eq!(it.materials[0].value.diffuse, Rgb::new(1e6, 10.0, 0.0));
}

#[test]
fn a_negative_radius_counts_as_its_absolute_value() {
    let inside = after_view("f 1 1 1 1 0 0 0 0\ns 1 2 3 -4\nc 0 0 0 -1 0 0 1 -2\n");
    let outside = after_view("f 1 1 1 1 0 0 0 0\ns 1 2 3 4\nc 0 0 0 1 0 0 1 2\n");
    assert_eq!(inside, outside);
}

#[test]
fn polygons_without_area_keep_their_index_and_one_warning_counts_them() {
    let it = after_view(&format!(
        "f 1 1 1 1 0 0 0 0\ns 0 0 0 1\n{}{}p 3 0 0 0 1 0 0 0 1 0\npp 4 {}\n",
        flat(1.0),
        flat(2.0),
        "5 5 5 0 0 1 ".repeat(4)
    ));
    let nothing = |number: usize| it.objects[number].shape == ShapeDescription::Degenerate;
    assert_eq!([0, 1, 2, 3, 4].map(nothing), [false, true, true, false, true]);
    assert_eq!(it.objects[3].shape, ShapeDescription::Triangle { vertices: [6, 7, 8], smooth: false });
    assert_eq!(it.warnings.len(), 1);
    let warning = &it.warnings[0];
    assert!(warning.contains("3 polygons") && warning.contains("line 4"), "{warning}");
    let scene_tables = tables::single::scene_tables(&it);
    assert_eq!(scene_tables.scene().unwrap().descriptor().geometry.shapes.len(), 5);
}

#[test]
fn normals_have_any_length_but_zero() {
    let it = after_view("f 1 1 1 1 0 0 0 0\npp 3 0 0 0 0 0 1e-45 1 0 0 0 0 1e15 0 1 0 1e-30 0 1e15\n");
    assert!(tables::single::scene_tables(&it).scene().is_ok());
    assert!(tables::double::scene_tables(&it).scene().is_ok());
}

#[test]
fn a_file_may_request_the_maximum_number_of_pixels() {
    for (width, height) in [(1, 1), (4096, 4096), (65_536, 256), (256, 65_536)] {
        let it = loaded(&VIEW.replace("4 3", &format!("{width} {height}")));
        assert_eq!(it.settings.size, Resolution::new(width, height));
    }
}

#[test]
fn comments_may_have_any_encoding() {
    assert_eq!(loaded(&format!("{VIEW}# Würfel, 立方体, куб\n")), loaded(VIEW));
    let latin = [VIEW.as_bytes(), b"# W\xfcrfel\n"].concat();
    assert_eq!(strahl_scene::load(file_of(&latin).path()).unwrap(), loaded(VIEW));
}

#[test]
fn a_file_may_start_with_a_byte_order_mark() {
    assert_eq!(loaded(&format!("\u{feff}{VIEW}")), loaded(VIEW));
}

#[test]
fn the_extension_of_a_scene_may_be_upper_case() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("SCENE.NFF");
    std::fs::write(&path, VIEW).unwrap();
    assert_eq!(strahl_scene::load(&path).unwrap(), loaded(VIEW));
}

#[test]
fn a_file_with_an_unknown_extension_is_rejected() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["scene.stl", "scene", "nff", "scene.nff.gz"] {
        let path = folder.path().join(name);
        std::fs::write(&path, VIEW).unwrap();
        let failure = strahl_scene::load(&path).unwrap_err();
        assert!(matches!(failure, LoadError::Invalid { .. }), "{failure}");
        assert!(failure.to_string().contains(".nff"), "{failure}");
    }
}

#[test]
fn an_unreadable_file_is_reported_before_an_unknown_extension() {
    let folder = tempfile::tempdir().unwrap();
    for path in [folder.path().join("missing.nff"), folder.path().join("missing.toml"), folder.path().into()]
    {
        let failure = strahl_scene::load(&path).unwrap_err();
        assert!(matches!(failure, LoadError::Unreadable { .. }), "{failure}");
        assert!(failure.to_string().contains(&path.display().to_string()), "{failure}");
    }
    let gone = file_of(b"").path().to_owned();
    assert!(matches!(strahl_scene::load(&gone), Err(LoadError::Unreadable { .. })));
}
