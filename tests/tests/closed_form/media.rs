//! Participating media: absorption, and the priority of bodies that overlap.

use crate::*;

const fn body(index: Real, attenuation_length: Rgb, priority: u8) -> Material {
    Material {
        transmission: Rgb::WHITE,
        refractive_index: index,
        attenuation_length,
        priority,
        ..unlit(Rgb::BLACK)
    }
}

const CLEAR: Rgb = Rgb::gray(Real::INFINITY);

fn plate(scene: &mut TestScene, material: Material, bottom: Real, top: Real) {
    scene.material(material);
    scene.cuboid(vec3(-1e3, bottom, -1e3), vec3(1e3, top, 1e3));
}

fn refracted_angle(angle: f64, index: f64) -> f64 {
    (angle.sin() / index).asin()
}

const ANGLES: [f64; 5] = [0.0, 0.2, 0.6, 1.0, -0.8];

#[test]
fn one_over_e_of_the_light_is_left_after_each_attenuation_length() {
    let attenuation_length = Rgb::new(2.0, 0.5, Real::INFINITY);
    for index in [1.0, 1.5] {
        let mut scene = TestScene::new();
        plate(&mut scene, body(index, attenuation_length, 0), -3.0, 0.0);
        scene.background = Background::Color(Rgb::new(0.5, 1.0, 0.25));
        for a in ANGLES {
            // The distance inside is longer than the plate is thick.
            let distance = 3.0 / refracted_angle(a, index.into()).cos();
            let expected = [0.5 * (-distance / 2.0).exp(), (-distance / 0.5).exp(), 0.25];
            // The exponent multiplies the rounding error of the distance.
            assert_color(
                trace_down(&scene, [0.0, 1.0], a, ALL),
                expected,
                ROUNDINGS + 8.0 * 6e-8 * distance / 0.5,
            );
        }
    }
}

#[test]
fn a_body_and_its_surface_both_absorb() {
    let mut scene = TestScene::new();
    let tinted = Material { transmission: Rgb::new(0.5, 0.25, 1.0), ..body(1.5, Rgb::gray(2.0), 0) };
    plate(&mut scene, tinted, -1.0, 0.0);
    scene.background = Background::Color(Rgb::WHITE);
    // Twice through the surface, once through the body.
    let left = (-0.5_f64).exp();
    assert_color(trace_down(&scene, [0.0, 1.0], 0.0, ALL), [0.25 * left, 0.0625 * left, left], ROUNDINGS);
}

#[test]
fn no_light_arrives_from_infinity_through_an_absorbing_body() {
    let mut scene = TestScene::new();
    scene.material(body(1.5, Rgb::new(1e6, Real::INFINITY, 1.0), 0));
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.background = Background::Color(Rgb::WHITE);
    assert_eq!(trace_down(&scene, [0.0, 1.0], 0.0, ALL), Rgb::new(0.0, 1.0, 0.0));
}

#[test]
fn an_item_inside_a_body_is_visible_through_it() {
    let mut scene = TestScene::new();
    plate(&mut scene, body(1.0, Rgb::gray(2.0), 0), -4.0, 0.0);
    scene.material(unlit(Rgb::WHITE));
    scene.disc(vec3(0.0, -1.0, 0.0), Vec3::Y, 1.0);
    scene.ambient = Rgb::WHITE;
    assert_gray(trace_down(&scene, [0.0, 1.0], 0.0, ALL), (-0.5_f64).exp(), ROUNDINGS);
}

#[test]
fn a_camera_inside_glass_starts_in_its_medium() {
    let mut scene = TestScene::new();
    plate(&mut scene, body(1.5, Rgb::gray(4.0), 0), -2.0, 0.0);
    let mut open = scene.clone();
    ruler(&mut scene, -3.0);
    open.background = Background::Color(Rgb::WHITE);
    for b in [0.0, 0.1, 0.3, -0.6] {
        // From the center: 1 through glass at the angle b, and 1 through air at the angle a.
        let a = (1.5 * f64::sin(b)).asin();
        let left = (-1.0 / b.cos() / 4.0).exp();
        let color = trace_down(&scene, [0.0, -1.0], b, ALL);
        let (x, expected) = (ruler_x(color * (1.0 / left) as Real), b.tan() + a.tan());
        assert!((x - expected).abs() <= 4.0 * RULER_TOLERANCE / a.cos(), "{b}: {x} is not {expected}");
        assert_gray(trace_down(&open, [0.0, -1.0], b, ALL), left, ROUNDINGS);
    }
}

/// Water from -2 to 0 and glass from -3 to -1.5, which overlap, with a ruler below both.
fn glass_in_water(water_priority: u8, glass_priority: u8) -> TestScene {
    let mut scene = TestScene::new();
    plate(&mut scene, body(1.33, CLEAR, water_priority), -2.0, 0.0);
    plate(&mut scene, body(1.5, CLEAR, glass_priority), -3.0, -1.5);
    ruler(&mut scene, -4.0);
    scene
}

#[test]
fn the_body_with_the_higher_priority_fills_the_overlap() {
    let across = |scene: &TestScene, a: f64, water: f64, glass: f64| {
        let (color, counters) = trace_down_counted(scene, [0.0, 1.0], a, ALL);
        // Two surfaces are entered and two are left, hidden or not.
        assert_eq!((counters.rays[RayKind::Transmitted], counters.rays[RayKind::Reflected]), (4, 0));
        // 1 through air above and 1 below.
        let expected =
            2.0 * a.tan() + water * refracted_angle(a, 1.33).tan() + glass * refracted_angle(a, 1.5).tan();
        let x = ruler_x(color);
        assert!((x - expected).abs() <= 4.0 * RULER_TOLERANCE / a.cos(), "{a}: {x} is not {expected}");
    };
    let (glass_wins, water_wins) = (glass_in_water(0, 1), glass_in_water(7, 3));
    let equal = glass_in_water(2, 2);
    for a in ANGLES {
        across(&glass_wins, a, 1.5, 1.5);
        across(&water_wins, a, 2.0, 1.0);
        // Among equals the body that was entered last.
        across(&equal, a, 1.5, 1.5);
    }
}

#[test]
fn a_hidden_surface_only_costs_a_level() {
    // The water is a colored mirror inside the glass, where its surface is hidden.
    let mut scene = TestScene::new();
    scene.ambient = Rgb::WHITE;
    scene.background = Background::Color(Rgb::gray(0.5));
    let painted = Material { reflection: Rgb::gray(0.5), ambient: Rgb::WHITE, ..body(1.33, CLEAR, 0) };
    plate(&mut scene, body(1.5, CLEAR, 1), -3.0, 0.0);
    plate(&mut scene, painted, -2.0, -1.0);
    let (color, counters) = trace_down_counted(&scene, [0.0, 1.0], 0.3, ALL);
    assert_eq!((color, counters.rays[RayKind::Reflected]), (Rgb::gray(0.5), 0));
    assert_eq!(counters.rays[RayKind::Transmitted], 4);
    assert_eq!(trace_down(&scene, [0.0, 1.0], 0.3, levels(4)), Rgb::BLACK);
    assert_eq!(trace_down(&scene, [0.0, 1.0], 0.3, levels(5)), Rgb::gray(0.5));
}

#[test]
fn glass_in_water_reflects_less() {
    // Fresnel reflectance at normal incidence between media n and m: ((n - m) / (n + m))^2.
    let mut scene = TestScene::new();
    let fresnel = |material| Material { fresnel: FresnelModel::Dielectric, ..material };
    scene.material(fresnel(body(1.33, CLEAR, 0)));
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.material(fresnel(body(1.5, CLEAR, 1)));
    scene.plane(vec3(0.0, -1.0, 0.0), Vec3::Y);
    scene.material(unlit(Rgb::WHITE));
    scene.plane(vec3(0.0, -2.0, 0.0), Vec3::Y);
    scene.ambient = Rgb::WHITE;
    // Down through both, without reflected light.
    let share = |n: f64, m: f64| ((n - m) / (n + m)) * ((n - m) / (n + m));
    let expected = (1.0 - share(1.33, 1.0)) * (1.0 - share(1.5, 1.33));
    assert_gray(scene.trace(Vec3::Y, Vec3::ZERO, levels(3)), expected, ROUNDINGS);
}

#[test]
fn a_pane_is_no_body() {
    let pane = |scene: &mut TestScene, height: Real| {
        scene.material(Material { transmission: Rgb::gray(0.5), priority: 9, ..body(1.0, CLEAR, 0) });
        scene.disc(vec3(0.0, height, 0.0), Vec3::Y, 10.0);
    };
    // In front of a body: the body refracts as if the pane did not exist, in spite of the pane's priority.
    let mut scene = TestScene::new();
    pane(&mut scene, 0.5);
    plate(&mut scene, body(1.5, CLEAR, 0), -1.0, 0.0);
    ruler(&mut scene, -2.0);
    for a in ANGLES {
        let expected = 2.0 * a.tan() + refracted_angle(a, 1.5).tan();
        let x = ruler_x(trace_down(&scene, [0.0, 1.0], a, ALL) * 2.0);
        assert!((x - expected).abs() <= 4.0 * RULER_TOLERANCE / a.cos(), "{a}: {x} is not {expected}");
    }
    // Inside a body: the body continues behind the pane.
    let mut scene = TestScene::new();
    plate(&mut scene, body(1.5, Rgb::gray(2.0), 0), -3.0, 0.0);
    pane(&mut scene, -1.0);
    scene.background = Background::Color(Rgb::WHITE);
    assert_gray(trace_down(&scene, [0.0, 1.0], 0.0, ALL), 0.5 * (-1.5_f64).exp(), ROUNDINGS);
}
