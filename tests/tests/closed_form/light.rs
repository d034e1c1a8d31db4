//! Diffuse and specular reflection (Lambert, Phong), ambient light, and falloff.

use crate::*;

const LIGHT_COLOR: Rgb = Rgb::new(0.9, 0.5, 0.25);

/// Color of a floor under one light, seen vertically from above.
fn lit(material: Material, source: LightSource) -> Rgb {
    lit_from(material, source, vec3(0.0, 4.0, 0.0))
}

fn lit_from(material: Material, source: LightSource, viewpoint: Vec3) -> Rgb {
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::BLACK, ..material });
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.lights.push(Light { source, color: LIGHT_COLOR, casts_shadows: true });
    scene.trace(viewpoint, Vec3::ZERO, ALL)
}

/// A point light at distance 5 from the origin, at an angle from the vertical.
fn point(angle: f64, falloff: Falloff) -> LightSource {
    let position = vec3((5.0 * angle.sin()) as Real, (5.0 * angle.cos()) as Real, 0.0);
    LightSource::Point { position, falloff }
}

/// The color of the light times these factors.
fn lit_color(factors: [f64; 3]) -> [f64; 3] {
    let [r, g, b] = factors;
    [r * f64::from(LIGHT_COLOR.r), g * f64::from(LIGHT_COLOR.g), b * f64::from(LIGHT_COLOR.b)]
}

/// Tolerance for a light at an angle: its position is rounded, which matters more at grazing angles.
fn grazing_tolerance(angle: f64) -> f64 {
    ROUNDINGS / angle.cos()
}

const ANGLES: [f64; 7] = [0.0, 0.2, 0.5, 0.8, 1.1, 1.4, 1.5];

const MATTE: Material =
    Material { diffuse: Rgb::new(0.5, 1.0, 0.25), ambient: Rgb::WHITE, ..Material::MATTE };

#[test]
fn diffuse_light_falls_with_the_cosine() {
    for angle in ANGLES {
        let cos = angle.cos();
        let expected = lit_color([0.5 * cos, cos, 0.25 * cos]);
        assert_color(lit(MATTE, point(angle, Falloff::NONE)), expected, grazing_tolerance(angle));
        let toward = try_normalize(vec3(angle.sin() as Real, angle.cos() as Real, 0.0)).unwrap();
        assert_color(
            lit(MATTE, LightSource::Directional { to_light: toward }),
            expected,
            grazing_tolerance(angle),
        );
    }
}

#[test]
fn a_light_below_the_surface_adds_nothing() {
    assert_eq!(lit(MATTE, point(2.0, Falloff::NONE)), Rgb::BLACK);
    assert_eq!(lit(MATTE, LightSource::Directional { to_light: -Vec3::Y }), Rgb::BLACK);
    // A light in the plane of the surface adds nothing either.
    assert_eq!(lit(MATTE, LightSource::Directional { to_light: Vec3::X }), Rgb::BLACK);
}

#[test]
fn diffuse_light_does_not_depend_on_the_camera() {
    let source = point(0.5, Falloff::NONE);
    for viewpoint in [vec3(3.0, 1.0, 0.0), vec3(-2.0, 0.25, 5.0), vec3(0.0, 40.0, 1.0)] {
        let cos = 0.5_f64.cos();
        // The hit point is the origin up to some roundings of the camera's distance over its height.
        assert_color(
            lit_from(MATTE, source, viewpoint),
            lit_color([0.5 * cos, cos, 0.25 * cos]),
            4.0 * ROUNDINGS,
        );
    }
}

#[test]
fn light_falls_off_with_the_distance() {
    for (constant, linear, quadratic) in
        [(1.0, 0.0, 0.0), (0.0, 0.5, 0.0), (0.0, 0.0, 1.0), (2.0, 0.25, 0.125)]
    {
        let falloff = Falloff { constant, linear, quadratic };
        let share = 1.0 / f64::from(constant + 5.0 * linear + 25.0 * quadratic);
        let expected = lit_color([0.5 * share, share, 0.25 * share]);
        assert_color(lit(MATTE, point(0.0, falloff)), expected, ROUNDINGS);
    }
    assert_color(lit(MATTE, point(0.0, Falloff::INVERSE_SQUARE)), lit_color([0.02, 0.04, 0.01]), ROUNDINGS);
}

#[test]
fn a_spot_light_is_bright_inside_dark_outside_and_smooth_between() {
    let spot = |angle: f64| LightSource::Spot {
        position: vec3(0.0, 4.0, 0.0),
        // The point below is at this angle from the axis of the cone.
        direction: vec3(angle.sin() as Real, -angle.cos() as Real, 0.0),
        cos_inner: 0.75,
        cos_outer: 0.5,
        falloff: Falloff::NONE,
    };
    let bright = |angle: f64, share: f64, tolerance: f64| {
        assert_color(lit(MATTE, spot(angle)), lit_color([0.5 * share, share, 0.25 * share]), tolerance);
    };
    for angle in [0.0, 0.3, 0.75_f64.acos() - 1e-5] {
        bright(angle, 1.0, ROUNDINGS);
    }
    for angle in [0.5_f64.acos() + 1e-5, 1.2, 2.0, 3.1] {
        bright(angle, 0.0, 0.0);
    }
    // The smoothstep s^2 (3 - 2 s), where s is the fraction between the two cosines.
    for s in [0.25_f64, 0.5, 0.75] {
        // The cosine is rounded, and the cosines are a quarter apart.
        bright((0.5 + 0.25 * s).acos(), s * s * (3.0 - 2.0 * s), 8.0 * ROUNDINGS);
    }
}

#[test]
fn a_spot_light_with_equal_cosines_has_a_sharp_edge() {
    let spot = |angle: f64| LightSource::Spot {
        position: vec3(0.0, 4.0, 0.0),
        direction: vec3(angle.sin() as Real, -angle.cos() as Real, 0.0),
        cos_inner: 0.5,
        cos_outer: 0.5,
        falloff: Falloff::NONE,
    };
    let edge = 0.5_f64.acos();
    assert_color(lit(MATTE, spot(edge - 1e-5)), lit_color([0.5, 1.0, 0.25]), ROUNDINGS);
    assert_eq!(lit(MATTE, spot(edge + 1e-5)), Rgb::BLACK);
}

#[test]
fn ambient_light_is_a_product_and_needs_no_light_source() {
    let mut scene = TestScene::new();
    let (even, odd) = (Rgb::new(0.5, 1.0, 0.25), Rgb::BLACK);
    let texture =
        scene.add_texture(Texture::Checker { even, odd, origin: Vec3::ZERO, frequency: Vec3::ZERO });
    scene.material(Material { ambient: Rgb::new(0.5, 0.25, 1.0), texture, ..Material::MATTE });
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.ambient = Rgb::new(0.25, 1.0, 0.5);
    let ambient = scene.trace(Vec3::Y, Vec3::ZERO, ALL);
    assert_eq!(ambient, Rgb::new(0.5 * 0.5 * 0.25, 0.25, 0.25 * 0.5));
    // A light is added; the texture applies to both.
    scene.lights.push(Light {
        source: LightSource::Directional { to_light: Vec3::Y },
        color: LIGHT_COLOR,
        casts_shadows: true,
    });
    assert_eq!(scene.trace(Vec3::Y, Vec3::ZERO, ALL), ambient + even * LIGHT_COLOR);
}

#[test]
fn lights_add_up() {
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::BLACK, ..MATTE });
    scene.plane(Vec3::ZERO, Vec3::Y);
    let mut sum = 0.0;
    for angle in ANGLES {
        scene.lights.push(Light {
            source: point(angle, Falloff::NONE),
            color: Rgb::WHITE,
            casts_shadows: true,
        });
        sum += angle.cos();
        let color = scene.trace(vec3(0.0, 4.0, 0.0), Vec3::ZERO, ALL);
        assert_color(color, [0.5 * sum, sum, 0.25 * sum], 2.0 * ROUNDINGS);
    }
}

const SHINY: Material = Material {
    diffuse: Rgb::BLACK,
    highlight: Rgb::new(0.5, 0.25, 1.0),
    highlight_exponent: 20.0,
    ambient: Rgb::WHITE,
    ..Material::MATTE
};

#[test]
fn the_highlight_is_brightest_in_the_mirror_direction() {
    // 3, 4, 5. The power of a cosine near one: the exponent multiplies its rounding error.
    let source = LightSource::Point { position: vec3(3.0, 4.0, 0.0), falloff: Falloff::NONE };
    let peak = lit_from(SHINY, source, vec3(-3.0, 4.0, 0.0));
    assert_color(peak, lit_color([0.5, 0.25, 1.0]), 20.0 * 6e-8 + ROUNDINGS);
    let with_matte = Material { diffuse: Rgb::WHITE, ..SHINY };
    let both = lit_from(with_matte, source, vec3(-3.0, 4.0, 0.0));
    assert_color(both, lit_color([1.3, 1.05, 1.8]), 20.0 * 6e-8 + ROUNDINGS);
}

#[test]
fn the_highlight_falls_with_the_power_of_the_cosine() {
    for exponent in [1.0, 5.0, 20.0, 200.0] {
        let material = Material { highlight_exponent: exponent, ..SHINY };
        for angle in [0.0_f64, 0.1, 0.4, 0.9, 1.5] {
            // Seen from above, the angle to the mirror direction is that of the light.
            let share = angle.cos().powf(f64::from(exponent));
            let expected = lit_color([0.5 * share, 0.25 * share, share]);
            // The exponent multiplies the rounding error of the cosine, and tiny powers underflow.
            let tolerance = f64::from(exponent) * 4.0 * 6e-8 / angle.cos() + ROUNDINGS;
            let got = lit(material, point(angle, Falloff::NONE));
            if share > 1e-30 {
                assert_color(got, expected, tolerance);
            } else {
                assert!(got.max_component() <= 1e-30, "{got:?}");
            }
        }
    }
}

#[test]
fn a_highlight_ends_at_a_right_angle_and_needs_an_exponent() {
    // The light is at 60 degrees, the camera at 45 on the same side: 105 from the mirror direction.
    let angle = std::f64::consts::FRAC_PI_3;
    assert_eq!(lit_from(SHINY, point(angle, Falloff::NONE), vec3(4.0, 4.0, 0.0)), Rgb::BLACK);
    let source = LightSource::Point { position: vec3(3.0, 4.0, 0.0), falloff: Falloff::NONE };
    let dull = Material { highlight_exponent: 0.0, ..SHINY };
    assert_eq!(lit_from(dull, source, vec3(-3.0, 4.0, 0.0)), Rgb::BLACK);
}

#[test]
fn a_smooth_surface_is_shaded_by_its_interpolated_normal() {
    // A flat square whose normals lean outward by 45 degrees at the edges, and a light above.
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::BLACK, ..Material::MATTE });
    let corners = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(x, z)| vec3(x, 0.0, z));
    let normals = corners.map(|corner| vec3(corner.x, 1.0, 0.0));
    scene.polygon(&corners, &normals);
    scene.lights.push(Light {
        source: LightSource::Directional { to_light: Vec3::Y },
        color: Rgb::WHITE,
        casts_shadows: true,
    });
    for x in [-0.75, -0.5, -0.125, 0.0, 0.25, 0.625] {
        // Linear between the edges before normalization: (x, root of 2, 0) times half of the root.
        let lean = x / 2.0_f64.sqrt();
        let expected = 0.5_f64.sqrt() / lean.hypot(0.5_f64.sqrt());
        let got = scene.trace(vec3(x as Real, 3.0, 0.25), vec3(x as Real, 0.0, 0.25), ALL);
        assert_gray(got, expected, 2.0 * ROUNDINGS);
    }
}
