//! Bodies: what fills space, what it takes away from light, and who wins where two overlap.

use crate::*;

const fn body(index: Real, clarity: Rgb, priority: u8) -> Material {
    Material { transmitted: Rgb::WHITE, index, clarity, priority, ..shining(Rgb::BLACK) }
}

const CLEAR: Rgb = Rgb::gray(Real::INFINITY);

fn plate(scene: &mut TestScene, material: Material, bottom: Real, top: Real) {
    scene.material(material);
    scene.cuboid(vec3(-1e3, bottom, -1e3), vec3(1e3, top, 1e3));
}

fn behind(angle: f64, index: f64) -> f64 {
    (angle.sin() / index).asin()
}

const ANGLES: [f64; 5] = [0.0, 0.2, 0.6, 1.0, -0.8];

#[test]
fn one_over_e_of_the_light_is_left_after_each_clarity() {
    let clarity = Rgb::new(2.0, 0.5, Real::INFINITY);
    for index in [1.0, 1.5] {
        let mut scene = TestScene::new();
        plate(&mut scene, body(index, clarity, 0), -3.0, 0.0);
        scene.background = Background::Color(Rgb::new(0.5, 1.0, 0.25));
        for a in ANGLES {
            // The way inside is longer than the plate is deep.
            let way = 3.0 / behind(a, index.into()).cos();
            let want = [0.5 * (-way / 2.0).exp(), (-way / 0.5).exp(), 0.25];
            // A rounding of the way counts as much as the exponent is large.
            assert_color(slanted(&scene, [0.0, 1.0], a, ALL), want, ROUNDINGS + 8.0 * 6e-8 * way / 0.5);
        }
    }
}

#[test]
fn a_body_and_its_surface_both_take_their_share() {
    let mut scene = TestScene::new();
    let tinted = Material { transmitted: Rgb::new(0.5, 0.25, 1.0), ..body(1.5, Rgb::gray(2.0), 0) };
    plate(&mut scene, tinted, -1.0, 0.0);
    scene.background = Background::Color(Rgb::WHITE);
    // Twice through the surface, once through the body.
    let left = (-0.5_f64).exp();
    assert_color(slanted(&scene, [0.0, 1.0], 0.0, ALL), [0.25 * left, 0.0625 * left, left], ROUNDINGS);
}

#[test]
fn nothing_comes_from_infinity_through_a_body_that_takes_light() {
    let mut scene = TestScene::new();
    scene.material(body(1.5, Rgb::new(1e6, Real::INFINITY, 1.0), 0));
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.background = Background::Color(Rgb::WHITE);
    assert_eq!(slanted(&scene, [0.0, 1.0], 0.0, ALL), Rgb::new(0.0, 1.0, 0.0));
}

#[test]
fn what_stands_in_a_body_is_seen_through_it() {
    let mut scene = TestScene::new();
    plate(&mut scene, body(1.0, Rgb::gray(2.0), 0), -4.0, 0.0);
    scene.material(shining(Rgb::WHITE));
    scene.disc(vec3(0.0, -1.0, 0.0), Vec3::Y, 1.0);
    scene.ambient = Rgb::WHITE;
    assert_gray(slanted(&scene, [0.0, 1.0], 0.0, ALL), (-0.5_f64).exp(), ROUNDINGS);
}

#[test]
fn an_eye_inside_glass_looks_out_of_it() {
    let mut scene = TestScene::new();
    plate(&mut scene, body(1.5, Rgb::gray(4.0), 0), -2.0, 0.0);
    let mut open = scene.clone();
    ruler(&mut scene, -3.0);
    open.background = Background::Color(Rgb::WHITE);
    for b in [0.0, 0.1, 0.3, -0.6] {
        // From the middle: one through glass at the angle b, and one through air at a.
        let a = (1.5 * f64::sin(b)).asin();
        let left = (-1.0 / b.cos() / 4.0).exp();
        let color = slanted(&scene, [0.0, -1.0], b, ALL);
        let (x, want) = (place(color * (1.0 / left) as Real), b.tan() + a.tan());
        assert!((x - want).abs() <= 4.0 * READING / a.cos(), "{b}: {x} is not {want}");
        assert_gray(slanted(&open, [0.0, -1.0], b, ALL), left, ROUNDINGS);
    }
}

/// Water from -2 to 0 and glass from -3 to -1.5, which overlap; a ruler below both.
fn glass_in_water(water_priority: u8, glass_priority: u8) -> TestScene {
    let mut scene = TestScene::new();
    plate(&mut scene, body(1.33, CLEAR, water_priority), -2.0, 0.0);
    plate(&mut scene, body(1.5, CLEAR, glass_priority), -3.0, -1.5);
    ruler(&mut scene, -4.0);
    scene
}

#[test]
fn where_two_bodies_overlap_the_higher_priority_fills_space() {
    let across = |scene: &TestScene, a: f64, water: f64, glass: f64| {
        let (color, counters) = slanted_and_counted(scene, [0.0, 1.0], a, ALL);
        // In at two surfaces and out at two, hidden or not.
        assert_eq!((counters.rays[RayKind::Transmitted], counters.rays[RayKind::Reflected]), (4, 0));
        // One through air above and one below.
        let want = 2.0 * a.tan() + water * behind(a, 1.33).tan() + glass * behind(a, 1.5).tan();
        let x = place(color);
        assert!((x - want).abs() <= 4.0 * READING / a.cos(), "{a}: {x} is not {want}");
    };
    let (glass_wins, water_wins) = (glass_in_water(0, 1), glass_in_water(7, 3));
    let equal = glass_in_water(2, 2);
    for a in ANGLES {
        across(&glass_wins, a, 1.5, 1.5);
        across(&water_wins, a, 2.0, 1.0);
        // Of equals the one that was entered last.
        across(&equal, a, 1.5, 1.5);
    }
}

#[test]
fn a_hidden_surface_does_nothing_but_take_a_level() {
    // The water's floor inside the glass is painted and a mirror, and nobody sees it.
    let mut scene = TestScene::new();
    scene.ambient = Rgb::WHITE;
    scene.background = Background::Color(Rgb::gray(0.5));
    let painted = Material { mirror: Rgb::gray(0.5), ambient: Rgb::WHITE, ..body(1.33, CLEAR, 0) };
    plate(&mut scene, body(1.5, CLEAR, 1), -3.0, 0.0);
    plate(&mut scene, painted, -2.0, -1.0);
    let (color, counters) = slanted_and_counted(&scene, [0.0, 1.0], 0.3, ALL);
    assert_eq!((color, counters.rays[RayKind::Reflected]), (Rgb::gray(0.5), 0));
    assert_eq!(counters.rays[RayKind::Transmitted], 4);
    assert_eq!(slanted(&scene, [0.0, 1.0], 0.3, levels(4)), Rgb::BLACK);
    assert_eq!(slanted(&scene, [0.0, 1.0], 0.3, levels(5)), Rgb::gray(0.5));
}

#[test]
fn glass_that_stands_in_water_throws_back_less() {
    // Fresnel, straight on: ((n - m) / (n + m))^2 between water and glass.
    let mut scene = TestScene::new();
    let fresnel = |material| Material { interface: Interface::Fresnel, ..material };
    scene.material(fresnel(body(1.33, CLEAR, 0)));
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.material(fresnel(body(1.5, CLEAR, 1)));
    scene.plane(vec3(0.0, -1.0, 0.0), Vec3::Y);
    scene.material(shining(Rgb::WHITE));
    scene.plane(vec3(0.0, -2.0, 0.0), Vec3::Y);
    scene.ambient = Rgb::WHITE;
    // Down through both, and nothing that was thrown back.
    let share = |n: f64, m: f64| ((n - m) / (n + m)) * ((n - m) / (n + m));
    let want = (1.0 - share(1.33, 1.0)) * (1.0 - share(1.5, 1.33));
    assert_gray(scene.trace(Vec3::Y, Vec3::ZERO, levels(3)), want, ROUNDINGS);
}

#[test]
fn a_pane_makes_no_body() {
    let pane = |scene: &mut TestScene, height: Real| {
        scene.material(Material { transmitted: Rgb::gray(0.5), priority: 9, ..body(1.0, CLEAR, 0) });
        scene.disc(vec3(0.0, height, 0.0), Vec3::Y, 10.0);
    };
    // Before a body: it breaks light as if the pane were not there, in spite of its priority.
    let mut scene = TestScene::new();
    pane(&mut scene, 0.5);
    plate(&mut scene, body(1.5, CLEAR, 0), -1.0, 0.0);
    ruler(&mut scene, -2.0);
    for a in ANGLES {
        let want = 2.0 * a.tan() + behind(a, 1.5).tan();
        let x = place(slanted(&scene, [0.0, 1.0], a, ALL) * 2.0);
        assert!((x - want).abs() <= 4.0 * READING / a.cos(), "{a}: {x} is not {want}");
    }
    // Inside a body: it goes on behind the pane.
    let mut scene = TestScene::new();
    plate(&mut scene, body(1.5, Rgb::gray(2.0), 0), -3.0, 0.0);
    pane(&mut scene, -1.0);
    scene.background = Background::Color(Rgb::WHITE);
    assert_gray(slanted(&scene, [0.0, 1.0], 0.0, ALL), 0.5 * (-1.5_f64).exp(), ROUNDINGS);
}
