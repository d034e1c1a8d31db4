//! Defaults.

use strahl_core::scene::{FilmPoint, FresnelModel};
use strahl_core::{Camera, Material, Resolution, Rgb, Sphere, vec3};
use strahl_scene::description::{
    BackgroundDescription, CameraDescription, LightSourceDescription, ProjectionDescription,
    ShapeDescription, TextureDescription,
};
use strahl_settings::SettingsOverrides;

use crate::text::{errors, loaded};

#[test]
fn a_file_with_one_sphere_is_a_scene() {
    let it = loaded("[[sphere]]\nradius = 2\n");
    assert_eq!(it.objects[0].shape, ShapeDescription::Sphere { center: [0.0; 3], radius: 2.0 });
    assert_eq!(it.materials.len(), 1);
    assert_eq!(it.materials[0].value, Material::matte(Rgb::WHITE));
    assert_eq!(it.settings, SettingsOverrides::default());
    assert_eq!(it.background, BackgroundDescription::Color(Rgb::BLACK));
    assert_eq!(it.ambient, Rgb::gray(0.1));
    assert_eq!(it.lights.len(), 1);
    assert!(it.lights[0].value.shadows && it.lights[0].value.color == Rgb::WHITE);
    assert!(matches!(it.lights[0].value.source, LightSourceDescription::Directional { .. }));
    assert_eq!(it.camera.at, [0.0; 3]);
    assert_eq!(it.camera.up, [0.0, 1.0, 0.0]);
    assert_eq!(it.camera.projection, ProjectionDescription::Perspective(45.0));
    assert!(it.warnings.is_empty());
}

#[test]
fn a_scene_without_objects_is_a_warning_and_an_empty_file_an_error() {
    let it = loaded("[camera]\n");
    assert!(it.objects.is_empty());
    assert_eq!(it.warnings, ["the scene has no objects"]);
    for text in ["", "\n", "# nothing\n", "\u{feff}"] {
        let list = errors(text);
        assert!(list.len() == 1 && list[0].3.contains("the file is empty"), "{list:?}");
    }
}

#[test]
fn every_shape_has_a_default_position_and_direction() {
    let it = loaded(
        "[[plane]]\n[[disc]]\nradius = 1\n[[cylinder]]\nend = [0, 2, 0]\nradius = 1\n\
         [[cone]]\nend = [0, 2, 0]\nradius = 1\n[[torus]]\nradius = 2\ntube = 1\n[[box]]\nsize = 2\n",
    );
    let up = [0.0, 1.0, 0.0];
    let (base, end) = ([0.0; 3], [0.0, 2.0, 0.0]);
    let forms: Vec<ShapeDescription> = it.objects.iter().map(|object| object.shape).collect();
    assert_eq!(
        forms,
        [
            ShapeDescription::Plane { point: base, normal: up },
            ShapeDescription::Disc { center: base, normal: up, radius: 1.0 },
            ShapeDescription::Cone { base, base_radius: 1.0, end, end_radius: 1.0, capped: true },
            ShapeDescription::Cone { base, base_radius: 1.0, end, end_radius: 0.0, capped: true },
            ShapeDescription::Torus { center: base, axis: up, major_radius: 2.0, minor_radius: 1.0 },
            ShapeDescription::Cuboid { min: [-1.0; 3], max: [1.0; 3] },
        ]
    );
    // All of them share one material.
    assert_eq!(it.materials.len(), 1);
}

#[test]
fn lights_are_white_without_falloff_by_default() {
    let it = loaded("[[point_light]]\nposition = [1, 2, 3]\n[[directional_light]]\ndirection = [0, -1, 0]\n");
    let point = LightSourceDescription::Point { position: [1.0, 2.0, 3.0], falloff: [1.0, 0.0, 0.0] };
    assert_eq!(it.lights[0].value.source, point);
    assert_eq!(it.lights[1].value.source, LightSourceDescription::Directional { to_light: [0.0, 1.0, 0.0] });
    assert!(it.lights.iter().all(|light| light.value.color == Rgb::WHITE && light.value.shadows));
    assert_eq!(it.ambient, Rgb::gray(0.1));
}

#[test]
fn a_file_with_a_light_gets_no_default_light() {
    for light in [
        "[ambient_light]",
        "[[point_light]]\nposition = [1, 2, 3]",
        "[[directional_light]]\ndirection = [0, -1, 0]",
        "[[spot_light]]\nposition = [1, 2, 3]\nat = [0, 0, 0]",
    ] {
        let it = loaded(light);
        assert_eq!(it.lights.len(), usize::from(!light.starts_with("[ambient")), "{light}");
        assert_eq!(it.ambient, Rgb::gray(0.1), "{light}");
    }
}

/// The material of a sphere with these keys.
fn material(keys: &str) -> Material {
    loaded(&format!("[[sphere]]\nradius = 1\nmaterial = {{ {keys} }}\n")).materials[0].value
}

#[test]
fn defaults_of_material_keys_depend_on_other_keys() {
    assert_eq!(material(""), Material::matte(Rgb::WHITE));
    let it = material("mirror = 0.25");
    assert_eq!((it.diffuse, it.ambient, it.reflection), (Rgb::gray(0.75), Rgb::gray(0.75), Rgb::gray(0.25)));
    let it = material("mirror = 0.25, transmission = [0.5, 1, 0]");
    assert_eq!(it.diffuse, Rgb::new(0.25, 0.0, 0.75));
    assert_eq!((it.refractive_index, it.fresnel, it.priority), (1.5, FresnelModel::None, 0));
    assert_eq!(it.attenuation_length, Rgb::gray(f32::INFINITY));
    let it = material("diffuse = 0.5, color = [1, 0.5, 0]");
    assert_eq!((it.diffuse, it.ambient), (Rgb::new(0.5, 0.25, 0.0), Rgb::new(0.5, 0.25, 0.0)));
    assert_eq!(material("mirror = 1, diffuse = 0.5").diffuse, Rgb::gray(0.5));

    assert_eq!((it.highlight, it.highlight_exponent), (Rgb::BLACK, 0.0));
    let it = material("shininess = 20");
    assert_eq!((it.highlight, it.highlight_exponent), (Rgb::gray(0.5), 20.0));
    let it = material("highlight = 0.75");
    assert_eq!((it.highlight, it.highlight_exponent), (Rgb::gray(0.75), 50.0));
    let it = material("highlight = 0");
    assert_eq!((it.highlight, it.highlight_exponent), (Rgb::BLACK, 0.0));
}

#[test]
fn the_default_checker_is_for_floors_and_the_default_gradient_from_black_to_white() {
    let it = loaded(
        "[[plane]]\nmaterial = { checker = {} }\n[[plane]]\nmaterial = { gradient = { start = [0, 0, 0], end = [0, 1, 0] } }\n",
    );
    let checker = TextureDescription::Checker {
        even: Rgb::WHITE,
        odd: Rgb::gray(0.1),
        origin: [0.0; 3],
        size: [1.0, 0.0, 1.0],
    };
    let gradient = TextureDescription::Gradient {
        from: Rgb::BLACK,
        to: Rgb::WHITE,
        start: [0.0; 3],
        end: [0.0, 1.0, 0.0],
    };
    assert_eq!(it.textures, [checker, gradient]);
}

#[test]
fn unused_keys_of_transparent_bodies_are_warnings() {
    let it = loaded("[[material]]\nname = \"a\"\nindex = 1.5\nclarity = 2\nfresnel = false\n");
    assert_eq!(
        it.warnings[..2],
        [
            "`index` in line 3 has no effect without `transmission`",
            "`clarity` in line 4 has no effect without `transmission`"
        ]
    );
}

#[test]
fn a_background_gradient_has_the_up_direction_of_the_camera() {
    let it = loaded("background = { below = 0, above = 1 }\n[camera]\nfrom = [1, 0, 0]\nup = [0, 0, 3]\n");
    let up = [0.0, 0.0, 3.0];
    assert_eq!(it.background, BackgroundDescription::Gradient { up, below: Rgb::BLACK, above: Rgb::WHITE });
}

#[test]
fn a_default_camera_sees_all_bounded_objects() {
    for (text, center, radius) in [
        ("[[sphere]]\nradius = 2\ncenter = [5, 6, 7]", [5.0, 6.0, 7.0], 2.0),
        ("[[sphere]]\nradius = 2e9\n[[plane]]", [0.0; 3], 2e9),
        ("[[sphere]]\nradius = 0.001\n[camera]\nangle = 100", [0.0; 3], 0.001),
        ("[[sphere]]\nradius = 1\n[camera]\nangle = 10\nat = [3, 0, 0]", [0.0; 3], 1.0),
        ("[[sphere]]\nradius = 1\n[render]\nsize = [30, 90]", [0.0; 3], 1.0),
    ] {
        let it = loaded(text);
        let size = it.settings.size.unwrap_or(Resolution::new(640, 480).unwrap());
        let camera =
            Camera::new(&strahl_session::tables::single::camera_descriptor(&it.camera), size).unwrap();
        // No ray through the edge of the picture hits the sphere.
        let ball = Sphere { center: vec3(center[0], center[1], center[2]), radius };
        let (w, h) = (size.width() as f32, size.height() as f32);
        for pixel in 0..100 {
            let s = pixel as f32 / 99.0;
            let middle = [(s * w, 0.5), (s * w, h - 0.5), (0.5, s * h), (w - 0.5, s * h)];
            for (x, y) in middle {
                let ray = camera.ray(FilmPoint { x, y });
                let way = ball.center - ray.origin;
                let near = way.dot(ray.direction);
                let distance = way.dot(way) - near * near;
                assert!(distance > radius * radius, "{text}: {x} {y}");
            }
        }
        assert_eq!(it.camera.up, [0.0, 1.0, 0.0]);
    }
}

#[test]
fn a_camera_with_a_height_is_orthographic() {
    let it = loaded("[[sphere]]\nradius = 1\n[camera]\nheight = 3\nfrom = [0, 0, 9]\n");
    let view = CameraDescription {
        from: [0.0, 0.0, 9.0],
        at: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        projection: ProjectionDescription::Orthographic(3.0),
    };
    assert_eq!(it.camera, view);
}

#[test]
fn missing_required_keys_are_reported() {
    for (table, key) in [
        ("[[sphere]]", "radius"),
        ("[[disc]]", "radius"),
        ("[[triangle]]", "corners"),
        ("[[polygon]]", "corners"),
        ("[[box]]", "extent"),
        ("[[cylinder]]\nradius = 1", "end"),
        ("[[cylinder]]\nend = [1, 1, 1]", "radius"),
        ("[[cone]]\nradius = 1", "end"),
        ("[[cone]]\nend = [1, 1, 1]", "radius"),
        ("[[torus]]\nradius = 1", "tube"),
        ("[[torus]]\ntube = 1", "radius"),
        ("[[mesh]]", "file"),
        ("[[material]]", "name"),
        ("[[point_light]]", "position"),
        ("[[directional_light]]", "direction"),
        ("[[spot_light]]\nat = [1, 1, 1]", "position"),
        ("[[spot_light]]\nposition = [1, 1, 1]", "needs `at` or `direction`"),
        ("[background]", "color"),
    ] {
        let list = errors(&format!("\n{table}\n"));
        assert_eq!(list.len(), 1, "{table} {list:?}");
        let (line, column, underlined, message) = &list[0];
        assert_eq!((*line, *column), (2, 1), "{table}");
        assert_eq!(Some(underlined.as_str()), table.lines().next());
        assert!(message.contains(key), "{message}");
    }
}
