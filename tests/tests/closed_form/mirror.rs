//! Mirrors: a series of images, and its end.

use crate::*;

/// Two mirrors that face each other and emit light.
fn facing(mirror: Rgb) -> TestScene {
    let mut scene = TestScene::new();
    scene.material(Material { reflection: mirror, ..unlit(Rgb::WHITE) });
    scene.plane(vec3(3.0, 0.0, 0.0), Vec3::X);
    scene.plane(vec3(-2.0, 0.0, 0.0), Vec3::X);
    scene.ambient = Rgb::WHITE;
    scene
}

fn reflections(scene: &TestScene, limits: Limits) -> (Rgb, u64) {
    let (color, counters) = scene.trace_counted(Vec3::ZERO, Vec3::X, limits);
    assert_eq!(counters.rays[RayKind::Camera], 1);
    (color, counters.rays[RayKind::Reflected])
}

#[test]
fn two_facing_mirrors_are_a_geometric_series() {
    let scene = facing(Rgb::new(0.5, 0.75, 0.25));
    for n in 1..=64 {
        let (color, reflected) = reflections(&scene, levels(n));
        assert_eq!(reflected, u64::from(n) - 1);
        // The partial sums: (1 - k^n) / (1 - k).
        let sum = |k: f64| (1.0 - k.powf(f64::from(n))) / (1.0 - k);
        assert_color(color, [sum(0.5), sum(0.75), sum(0.25)], f64::from(n) * 6e-8);
        if n <= 24 {
            // All bits of the sum of halves fit.
            assert_eq!(f64::from(color.r), sum(0.5), "{n}");
        }
    }
}

#[test]
fn perfect_mirrors_add_the_same_at_every_level() {
    let scene = facing(Rgb::WHITE);
    for n in [1, 2, 7, 64] {
        assert_eq!(reflections(&scene, levels(n)), (Rgb::gray(n as Real), u64::from(n) - 1));
    }
}

#[test]
fn the_cutoff_ends_the_series_when_the_largest_weight_does_not_exceed_it() {
    // The i-th image has the weight 2^-i in green, and less in the others.
    let scene = facing(Rgb::new(0.25, 0.5, 0.0));
    for (cutoff, images) in
        [(0.0, 63), (1.0 / 512.0, 8), (0.25, 1), (0.249, 2), (0.3, 1), (0.5, 0), (0.499, 1), (1.0, 0)]
    {
        let (color, reflected) = reflections(&scene, Limits { levels: 64, cutoff });
        assert_eq!(reflected, images, "{cutoff}");
        let sum = |k: f64| (0..=images).map(|i| k.powf(i as f64)).sum::<f64>();
        assert_color(color, [sum(0.25), sum(0.5), 1.0], ROUNDINGS);
    }
    // The weight of a perfect mirror is 1, which does not exceed a cutoff of 1.
    assert_eq!(reflections(&facing(Rgb::WHITE), Limits { levels: 64, cutoff: 1.0 }).1, 0);
}

#[test]
fn a_mirror_shows_the_mirror_direction() {
    // A mirror in y = 0, with the ruler above.
    let mut scene = TestScene::new();
    scene.material(Material {
        reflection: Rgb::gray(0.5),
        diffuse: Rgb::BLACK,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    });
    scene.material(Material { reflection: Rgb::gray(0.5), ..unlit(Rgb::BLACK) });
    scene.disc(Vec3::ZERO, Vec3::Y, 1.0);
    ruler(&mut scene, 2.0);
    for angle in [-1.2_f64, -0.5, 0.0, 0.3, 0.9, 1.25] {
        let start = [-angle.tan(), 1.0];
        let color = trace_down(&scene, start, angle, ALL);
        let x = ruler_x(color + color);
        assert!((x - 2.0 * angle.tan()).abs() <= 8.0 * RULER_TOLERANCE, "{x} is not {}", 2.0 * angle.tan());
        // With one level there is no image.
        assert_eq!(trace_down(&scene, start, angle, levels(1)), Rgb::BLACK);
    }
}

#[test]
fn a_mirror_shows_the_background() {
    let mut scene = TestScene::new();
    scene.material(Material { reflection: Rgb::new(0.5, 0.25, 1.0), ..unlit(Rgb::BLACK) });
    scene.sphere(vec3(0.0, 0.0, -3.0), 1.0);
    scene.background = Background::Color(Rgb::new(0.5, 1.0, 0.25));
    assert_eq!(scene.trace(Vec3::ZERO, -Vec3::Z, ALL), Rgb::new(0.25, 0.25, 0.25));
    assert_eq!(scene.trace(Vec3::ZERO, Vec3::Z, ALL), Rgb::new(0.5, 1.0, 0.25));
}
