//! Contents of valid files.

use strahl_core::scene::{FresnelModel, TextureId};
use strahl_core::{Material, Resolution, Rgb};
use strahl_scene::description::{
    BackgroundDescription, CameraDescription, LightDescription, LightSourceDescription, LinearMotion,
    Located, ObjectDescription, ProjectionDescription, ShapeDescription, TextureDescription,
};
use strahl_settings::{Accel, Bounds, Filter, Precision, SamplerSettings, SettingsOverrides, Walk};

use crate::text::{ALL, loaded};

const RED: Rgb = Rgb::new(1.0, 0.0, 0.0);

#[test]
fn every_light_and_setting_is_loaded_as_the_format_describes() {
    let it = loaded(ALL);
    let view = CameraDescription {
        from: [0.0, -8.0, 1.0],
        at: [0.0, 0.0, 0.5],
        up: [0.0, 0.0, 1.0],
        projection: ProjectionDescription::Perspective(40.0),
    };
    assert_eq!(it.camera, view);
    let settings = SettingsOverrides {
        size: Resolution::new(40, 30),
        levels: Some(7),
        cutoff: Some(0.25),
        sampler: Some(SamplerSettings::Regular(3)),
        ..SettingsOverrides::default()
    };
    assert_eq!(it.settings, settings);
    let (below, above) = (Rgb::BLACK, Rgb::new(0.5, 0.25, 1.0));
    assert_eq!(it.background, BackgroundDescription::Gradient { up: [0.0, 0.0, 2.0], below, above });
    assert_eq!(it.ambient, Rgb::new(0.25, 0.125, 0.0625));

    let spot = LightSourceDescription::Spot {
        position: [0.0, 0.0, 4.0],
        direction: [0.0, 0.0, -3.0],
        inner_angle: 15.0,
        outer_angle: 30.0,
        falloff: [0.0, 0.0, 1.0],
    };
    let point = LightSourceDescription::Point { position: [4.0, -3.0, 2.0], falloff: [1.0, 0.5, 0.25] };
    let sun = LightSourceDescription::Directional { to_light: [-1.0, -2.0, 3.0] };
    let placed = |source, color, shadows, line, name: Option<&str>| Located {
        value: LightDescription { source, color, shadows },
        line,
        name: name.map(String::from),
    };
    let lights = [
        placed(spot, Rgb::gray(2.0), true, 20, Some("lamp")),
        placed(sun, Rgb::gray(0.5), false, 30, None),
        placed(point, Rgb::new(1.0, 0.5, 0.25), true, 35, None),
    ];
    assert_eq!(it.lights, lights);
}

#[test]
fn settings_of_the_acceleration_structure_may_be_in_a_scene() {
    let it = loaded(
        "[render]\nprecision = \"double\"\naccel = \"bvh\"\nwalk = \"heap\"\nheap = 4\nbounds = \"none\"\nmailbox = 0\nshadow_cache = false\n",
    );
    let settings = SettingsOverrides {
        precision: Some(Precision::Double),
        accel: Some(Accel::Bvh),
        walk: Some(Walk::Heap),
        heap: Some(4),
        bounds: Some(Bounds::None),
        mailbox: Some(0),
        shadow_cache: Some(false),
        ..SettingsOverrides::default()
    };
    assert_eq!(it.settings, settings);
}

#[test]
fn samplers_have_the_syntax_of_the_command_line() {
    let it =
        loaded("[render]\nsampler = \"stochastic:8..64:0.9\"\nfilter = \"tent\"\nseed = 0xff\n").settings;
    let sampling: SamplerSettings = "stochastic:8..64:0.9:1/128".parse().unwrap();
    assert_eq!((it.sampler, it.filter, it.seed), (Some(sampling), Some(Filter::Tent), Some(255)));
}

#[test]
fn velocities_and_the_shutter_give_moving_objects() {
    let it = loaded(
        "[camera]\nshutter = [-0.5, 0.25]\n[[sphere]]\nradius = 1\nvelocity = [1, 2, 3]\n[[plane]]\n\
         [[box]]\nsize = 1\nvelocity = [0, 0, 0]\n[[torus]]\nradius = 1\ntube = 0.5\nvelocity = [0, -1, 0]\n",
    );
    assert_eq!(it.shutter, [-0.5, 0.25]);
    let motion = |object, velocity| LinearMotion { object, velocity };
    assert_eq!(it.motions, [motion(0, [1.0, 2.0, 3.0]), motion(3, [0.0, -1.0, 0.0])]);
    assert_eq!(loaded("[camera]\nshutter = 0.5\n[[plane]]\n").shutter, [0.0, 0.5]);
    assert_eq!(loaded("[[plane]]\n").shutter, [0.0, 1.0]);

    // The tables of the core have the displacements at the opening and closing times.
    let tables = strahl_session::tables::single::scene_tables(&it);
    let scene = tables.scene().unwrap();
    let geometry = &scene.descriptor().geometry;
    assert_eq!(geometry.motion_offset(&geometry.shapes[0], 0.0).to_array(), [-0.5, -1.0, -1.5]);
    assert_eq!(geometry.motion_offset(&geometry.shapes[0], 1.0).to_array(), [0.25, 0.5, 0.75]);
    assert!(scene.required_effects().motion_blur);
}

#[test]
fn lenses_area_lights_and_roughness_are_loaded_as_the_format_describes() {
    let it = loaded(
        "[camera]\nfrom = [0, 3, 4]\nat = [0, 0, 0]\nangle = 40\nlens_radius = 0.5\n\
         [render]\ncolored_shadows = true\n\
         [[rectangle_light]]\nposition = [0, 5, 0]\ndirection = [0, -2, 0]\nsize = [2, 6]\n\
         [[sphere_light]]\nposition = [1, 2, 3]\nradius = 0.25\nfalloff = \"square\"\n\
         [[plane]]\nmaterial = { mirror = 0.5, roughness = 0.75 }\n",
    );
    // The default focus distance is that of the target.
    assert_eq!(it.camera.projection, ProjectionDescription::Lens { angle: 40.0, radius: 0.5, focus: 5.0 });
    assert_eq!((it.camera_line, it.colored_shadows_line), (1, Some(7)));
    let half = [[1.0, 0.0, 0.0], [0.0, 0.0, 3.0]].map(|h| h.map(f32::abs));
    let LightSourceDescription::Rectangle { position, half_edges: got, soft_shadows: true, falloff } =
        it.lights[0].value.source
    else {
        panic!()
    };
    assert_eq!((position, got.map(|h| h.map(f32::abs)), falloff), ([0.0, 5.0, 0.0], half, [1.0, 0.0, 0.0]));
    // The front faces down.
    let [a, b] = got;
    assert!(a[2] * b[0] - a[0] * b[2] < 0.0, "{got:?}");
    let sphere =
        LightSourceDescription::Sphere { position: [1.0, 2.0, 3.0], radius: 0.25, falloff: [0.0, 0.0, 1.0] };
    assert_eq!(it.lights[1].value.source, sphere);
    assert_eq!(it.materials[0].value.roughness, 0.75);
    assert!(it.warnings.is_empty(), "{:?}", it.warnings);
    let it = loaded("[[plane]]\nmaterial = { roughness = 0.5 }\n");
    assert_eq!(it.warnings, ["`roughness` in line 2 has no effect without `mirror` or `transmission`"]);
}

#[test]
fn every_material_is_loaded_as_the_format_describes() {
    let it = loaded(ALL);
    let glass = Material {
        ambient: Rgb::BLACK,
        diffuse: Rgb::BLACK,
        reflection: Rgb::gray(0.125),
        transmission: Rgb::new(0.75, 0.5, 0.25),
        refractive_index: 1.25,
        fresnel: FresnelModel::Dielectric,
        attenuation_length: Rgb::new(f32::INFINITY, 2.0, 0.5),
        priority: 3,
        two_sided: false,
        ..Material::MATTE
    };
    let half = Rgb::gray(0.5);
    let floor = Material { ambient: half, diffuse: half, texture: TextureId(0), ..Material::MATTE };
    let fading = Material { texture: TextureId(1), ambient: Rgb::WHITE, ..Material::MATTE };
    let own = Material {
        ambient: RED * 0.5,
        diffuse: RED,
        highlight: Rgb::gray(0.25),
        highlight_exponent: 8.0,
        ..Material::MATTE
    };
    let named = |it, line, name: &str| Located { value: it, line, name: Some(name.into()) };
    let materials = [
        named(glass, 101, "glass"),
        named(floor, 112, "floor"),
        named(fading, 121, "fading"),
        Located { value: Material::matte(Rgb::WHITE), line: 56, name: None },
        Located { value: own, line: 69, name: None },
    ];
    assert_eq!(it.materials, materials);
    let checker = TextureDescription::Checker {
        even: Rgb::WHITE,
        odd: Rgb::new(0.0, 0.0, 0.5),
        origin: [0.5, 0.0, 0.0],
        size: [2.0, 2.0, 0.0],
    };
    let gradient = TextureDescription::Gradient {
        from: Rgb::BLACK,
        to: Rgb::WHITE,
        start: [0.0; 3],
        end: [0.0, 0.0, 2.0],
    };
    assert_eq!(it.textures, [checker, gradient]);
}

#[test]
fn every_object_is_loaded_as_the_format_describes_in_the_order_of_the_file() {
    let it = loaded(ALL);
    let object = |form, material, line| ObjectDescription { shape: form, material, line };
    let cone = |base, base_radius, end, end_radius, capped| ShapeDescription::Cone {
        base,
        base_radius,
        end,
        end_radius,
        capped,
    };
    let turned = ShapeDescription::OrientedCuboid {
        center: [1.0; 3],
        half_size: [1.0, 2.0, 3.0],
        first: [0.0, 1.0, 0.0],
        third: [0.0, 0.0, 1.0],
    };
    let objects = [
        object(ShapeDescription::Sphere { center: [0.0, 0.0, 1.0], radius: 1.0 }, 0, 40),
        object(ShapeDescription::Plane { point: [0.0, 0.0, -1.0], normal: [0.0, 0.0, 2.0] }, 1, 45),
        object(
            ShapeDescription::Disc { center: [1.0, 2.0, 3.0], normal: [0.0, 3.0, 0.0], radius: 2.5 },
            2,
            50,
        ),
        object(ShapeDescription::Triangle { vertices: [0, 1, 2], smooth: false }, 3, 56),
        object(ShapeDescription::Polygon { first: 3, count: 5, smooth: true }, 3, 59),
        object(ShapeDescription::Cuboid { min: [-1.0, -2.0, -3.0], max: [1.0, 2.0, 3.0] }, 3, 63),
        object(ShapeDescription::Sphere { center: [0.0; 3], radius: 0.5 }, 4, 67),
        object(turned, 3, 71),
        object(cone([0.0; 3], 0.5, [0.0, 0.0, 2.0], 0.5, false), 3, 76),
        object(cone([0.0, 0.0, 1.0], 1.0, [0.0, 0.0, 3.0], 0.25, true), 3, 82),
        object(
            ShapeDescription::Torus {
                center: [1.0, 0.0, 0.0],
                axis: [0.0, 0.0, 4.0],
                major_radius: 2.0,
                minor_radius: 0.5,
            },
            3,
            88,
        ),
        object(ShapeDescription::Triangle { vertices: [8, 9, 10], smooth: true }, 3, 94),
        object(ShapeDescription::Degenerate, 3, 98),
    ];
    let offset = it.objects[0].line - objects[0].line;
    assert_eq!(offset, 0);
    for (found, expected) in it.objects.iter().zip(&objects) {
        assert_eq!(found, expected);
    }
    assert_eq!(it.objects.len(), objects.len());
    assert_eq!(it.vertices.len(), 11);
    // A normal has the index of its vertex; the first triangle has none.
    assert_eq!(it.normals.len(), 11);
    assert_eq!(it.normals[4], [1.0, 0.0, 1.0]);
    assert_eq!(it.normals[8..], [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
}

#[test]
fn triangles_without_area_keep_their_index_and_one_warning_counts_them() {
    let flat = "[[triangle]]\ncorners = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]\n";
    let it = loaded(&format!("[[sphere]]\nradius = 1\n{flat}{flat}[[sphere]]\nradius = 2\n"));
    let forms: Vec<bool> =
        it.objects.iter().map(|object| object.shape == ShapeDescription::Degenerate).collect();
    assert_eq!(forms, [false, true, true, false]);
    assert_eq!(it.warnings, ["2 triangles have zero area and are never hit (the first in line 3)"]);
}

#[test]
fn the_order_is_that_of_the_file_in_tables_written_in_one_line_too() {
    let it = loaded(
        "sphere = [{ radius = 1 },\n  { radius = 3 }]\n\nbox = [{ size = 2 }]\n[[plane]]\n\n[[disc]]\nradius = 4\n",
    );
    let lines: Vec<u32> = it.objects.iter().map(|object| object.line).collect();
    assert_eq!(lines, [1, 2, 4, 5, 7]);
    assert!(matches!(it.objects[1].shape, ShapeDescription::Sphere { radius: 3.0, .. }));
}

#[test]
fn a_number_may_be_written_in_every_way_that_toml_has() {
    for one in ["1", "1.0", "+1", "1e0", "0x1", "0b1", "0o1", "1_0e-1"] {
        let it = loaded(&format!("[[sphere]]\nradius = {one}\n"));
        assert!(matches!(it.objects[0].shape, ShapeDescription::Sphere { radius: 1.0, .. }), "{one}");
    }
}

#[test]
fn colors_are_linear_numbers_grays_srgb_codes_and_names() {
    let half = 0.215_860_5;
    for (written, color) in [
        ("[1, 0.5, 0]", Rgb::new(1.0, 0.5, 0.0)),
        ("0.25", Rgb::gray(0.25)),
        ("1000000", Rgb::gray(1e6)),
        ("\"#808080\"", Rgb::gray(half)),
        ("'#FF0000'", RED),
        ("\"gray\"", Rgb::gray(half)),
        ("\"white\"", Rgb::WHITE),
    ] {
        let it = loaded(&format!("background = {{ color = {written} }}\n"));
        assert_eq!(it.background, BackgroundDescription::Color(color), "{written}");
    }
}

#[test]
fn a_rotated_box_may_have_min_and_max_or_a_size() {
    let one = loaded("[[box]]\nmin = [-1, -2, 0]\nmax = [3, 2, 2]\nrotate = [30, 40, 50]\n");
    let other = loaded("[[box]]\ncenter = [1, 0, 1]\nsize = [4, 4, 2]\nrotate = [30, 40, 50]\n");
    assert_eq!(one.objects, other.objects);
    let axis_aligned = loaded("[[box]]\ncenter = [1, 0, 1]\nsize = [4, 4, 2]\nrotate = [0, 0, 0]\n");
    assert_eq!(
        axis_aligned.objects[0].shape,
        ShapeDescription::Cuboid { min: [-1.0, -2.0, 0.0], max: [3.0, 2.0, 2.0] }
    );
}

#[test]
fn a_spot_light_has_a_target_or_a_direction() {
    let it = loaded("[[spot_light]]\nposition = [0, 9, 0]\ndirection = [0, -1, 0]\n");
    let LightSourceDescription::Spot { direction, inner_angle: bright, outer_angle: dark, falloff, .. } =
        it.lights[0].value.source
    else {
        panic!()
    };
    assert_eq!((direction, bright, dark, falloff), ([0.0, -1.0, 0.0], 16.0, 20.0, [1.0, 0.0, 0.0]));
}

#[test]
fn all_line_ends_and_a_byte_order_mark_are_read() {
    let unix = loaded(ALL);
    assert_eq!(loaded(&ALL.replace('\n', "\r\n")), unix);
    assert_eq!(loaded(&format!("\u{feff}{ALL}")), unix);
}
