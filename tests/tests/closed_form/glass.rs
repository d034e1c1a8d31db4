//! Glass: the direction and the amount of transmitted and reflected light.

use crate::*;

/// Clear glass without color of its own.
const fn glass(index: Real) -> Material {
    Material { transmission: Rgb::WHITE, refractive_index: index, ..unlit(Rgb::BLACK) }
}

/// Adds a wide plate from `bottom` to `top`.
fn plate(scene: &mut TestScene, material: Material, bottom: Real, top: Real) {
    scene.material(material);
    scene.cuboid(vec3(-1e3, bottom, -1e3), vec3(1e3, top, 1e3));
}

/// Snell's law: the angle behind a surface.
fn refracted_angle(angle: f64, index: f64) -> f64 {
    (angle.sin() / index).asin()
}

const ANGLES: [f64; 6] = [0.0, 0.1, 0.5, 0.9, 1.2, -0.7];

#[test]
fn a_plate_displaces_a_ray_by_the_offset_of_snells_law() {
    for index in [1.33, 1.5, 2.42, 0.8] {
        for depth in [0.25, 1.0] {
            let mut scene = TestScene::new();
            plate(&mut scene, glass(index), -depth, 0.0);
            ruler(&mut scene, -2.0);
            let (n, d) = (f64::from(index), f64::from(depth));
            for a in ANGLES.into_iter().filter(|a| a.sin().abs() < 0.79) {
                let b = refracted_angle(a, n);
                let offset = d * a.sin() * (1.0 - a.cos() / (n * b.cos()));
                // The ray starts 1.5 above the plate; along the ruler the offset is longer.
                let expected = 3.5 * a.tan() - offset / a.cos();
                let x = 1.5 * a.tan() - 1.5 * a.tan();
                let actual = ruler_x(trace_down(&scene, [x, 1.5], a, ALL));
                assert!(
                    (actual - expected).abs() <= 4.0 * RULER_TOLERANCE / a.cos(),
                    "{index} {a}: {actual} is not {expected}"
                );
            }
        }
    }
}

#[test]
fn a_ray_leaves_a_plate_parallel_to_the_incident_ray() {
    let ruler_x_below = |height: f64, a: f64| {
        let mut scene = TestScene::new();
        plate(&mut scene, glass(1.5), -1.0, 0.0);
        ruler(&mut scene, height);
        ruler_x(trace_down(&scene, [0.0, 0.5], a, ALL))
    };
    for a in ANGLES {
        let (near, far) = (ruler_x_below(-1.25, a), ruler_x_below(-2.75, a));
        assert!(
            (far - near - 1.5 * a.tan()).abs() <= 4.0 * RULER_TOLERANCE / a.cos(),
            "{a}: from {near} to {far}"
        );
    }
}

#[test]
fn a_glass_sphere_deflects_a_ray_by_twice_the_difference_of_the_angles() {
    let mut scene = TestScene::new();
    scene.material(glass(1.5));
    scene.sphere(Vec3::ZERO, 2.0);
    // The background encodes the height of the direction.
    scene.background = Background::Gradient { up: Vec3::Y, below: Rgb::BLACK, above: Rgb::WHITE };
    for h in [0.0, 0.25, 1.0, -1.5, 1.9] {
        let a = (h / 2.0_f64).asin();
        let deflection = 2.0 * (a - refracted_angle(a, 1.5));
        let viewpoint = vec3(-5.0, h as Real, 0.0);
        let (color, counters) = scene.trace_counted(viewpoint, viewpoint + Vec3::X, ALL);
        assert_eq!(counters.rays[RayKind::Transmitted], 2);
        let expected = 0.5 - 0.5 * deflection.sin();
        assert!(
            (f64::from(color.r) - expected).abs() <= 4.0 * ROUNDINGS / a.cos(),
            "{h}: {color:?} is not {expected}"
        );
    }
}

#[test]
fn a_pane_of_index_one_does_not_refract() {
    let with = |add: &dyn Fn(&mut TestScene)| {
        let mut scene = TestScene::new();
        add(&mut scene);
        ruler(&mut scene, -2.0);
        scene
    };
    let air = with(&|_| ());
    let pane = with(&|scene| {
        scene.material(glass(1.0));
        scene.disc(vec3(0.0, 0.5, 0.0), Vec3::Y, 10.0);
    });
    let block = with(&|scene| plate(scene, glass(1.0), -1.0, 0.5));
    for a in ANGLES {
        let expected = ruler_x(trace_down(&air, [0.0, 1.0], a, ALL));
        for scene in [&pane, &block] {
            let actual = ruler_x(trace_down(scene, [0.0, 1.0], a, ALL));
            assert!(
                (actual - expected).abs() <= RULER_TOLERANCE / a.cos(),
                "{a}: {actual} is not {expected}"
            );
        }
    }
}

/// Glass below y = 0 with a floor of the color `inside`, and a ceiling above of the color `outside`.
fn half_space(material: Material, inside: Rgb, outside: Rgb) -> TestScene {
    let mut scene = TestScene::new();
    scene.material(material);
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.material(unlit(inside));
    scene.plane(vec3(0.0, -2.0, 0.0), Vec3::Y);
    scene.material(unlit(outside));
    scene.plane(vec3(0.0, 3.0, 0.0), Vec3::Y);
    scene.ambient = Rgb::WHITE;
    scene
}

#[test]
fn a_constant_interface_reflects_and_transmits_the_factors_of_the_material() {
    let factors = Material {
        reflection: Rgb::new(0.25, 0.5, 0.0),
        transmission: Rgb::new(0.5, 0.25, 1.0),
        ..glass(1.5)
    };
    let scene = half_space(factors, Rgb::new(1.0, 0.5, 0.25), Rgb::new(0.25, 1.0, 0.5));
    for a in ANGLES {
        let (color, counters) = trace_down_counted(&scene, [0.0, 1.0], a, ALL);
        // The reflected factor times the ceiling plus the transmitted factor times the floor, at every angle.
        assert_eq!(color, Rgb::new(0.5625, 0.625, 0.25), "{a}");
        assert_eq!((counters.rays[RayKind::Reflected], counters.rays[RayKind::Transmitted]), (1, 1));
    }
}

/// Fresnel reflectance of unpolarized light, from the angles.
fn fresnel(a: f64, b: f64) -> f64 {
    let across = (a - b).sin() / (a + b).sin();
    let along = (a - b).tan() / (a + b).tan();
    0.5 * (across * across + along * along)
}

#[test]
fn a_fresnel_interface_reflects_the_fresnel_reflectance() {
    let (floor, ceiling) = (Rgb::new(1.0, 0.0, 0.25), Rgb::new(0.0, 1.0, 0.5));
    let scene = half_space(Material { fresnel: FresnelModel::Dielectric, ..glass(1.5) }, floor, ceiling);
    let color_at = |a| trace_down(&scene, [0.0, 1.0], a, ALL);
    // The reflectance is a difference of two numbers near one: its error is absolute.
    let near = |color: Rgb, reflectance: f64| {
        let expected = [1.0 - reflectance, reflectance, 0.25 * (1.0 - reflectance) + 0.5 * reflectance];
        for (got, expected) in [color.r, color.g, color.b].map(f64::from).into_iter().zip(expected) {
            assert!((got - expected).abs() <= ROUNDINGS, "{got} is not {expected}");
        }
    };
    near(color_at(0.0), 0.04);
    for a in [0.1_f64, 0.5, 0.9, 1.2, -0.7] {
        near(color_at(a), fresnel(a.abs(), refracted_angle(a.abs(), 1.5)));
    }
}

#[test]
fn a_fresnel_interface_conserves_light() {
    let material = Material { fresnel: FresnelModel::Dielectric, ..glass(1.5) };
    let scene = half_space(material, Rgb::WHITE, Rgb::WHITE);
    for i in 0..150 {
        let a = 0.01 * f64::from(i);
        // From above into the glass, and from inside.
        assert_gray(trace_down(&scene, [0.0, 1.0], a, ALL), 1.0, ROUNDINGS);
        assert_gray(trace_down(&scene, [0.0, -1.0], std::f64::consts::PI - a, ALL), 1.0, ROUNDINGS);
    }
    // The transmitted factor of the glass applies to both.
    let tinted = Material { transmission: Rgb::new(0.5, 0.25, 0.75), ..material };
    let scene = half_space(tinted, Rgb::WHITE, Rgb::WHITE);
    assert_color(trace_down(&scene, [0.0, 1.0], 1.0, ALL), [0.5, 0.25, 0.75], ROUNDINGS);
}

#[test]
fn beyond_the_critical_angle_the_transmitted_factor_is_reflected() {
    let kt = 0.75;
    let mut scene = TestScene::new();
    scene.material(Material { transmission: Rgb::gray(kt), ..glass(1.5) });
    scene.plane(Vec3::ZERO, Vec3::Y);
    ruler(&mut scene, -2.0);
    let critical = (1.0_f64 / 1.5).asin();
    for a in [critical + 1e-4, 0.9, 1.1, 1.2] {
        let upward = std::f64::consts::PI - a;
        let (color, counters) = trace_down_counted(&scene, [0.0, -1.0], upward, ALL);
        assert_eq!((counters.rays[RayKind::Reflected], counters.rays[RayKind::Transmitted]), (1, 0), "{a}");
        // Up by one and down by two.
        let (x, expected) = (ruler_x(color * (1.0 / kt)), 3.0 * a.tan());
        assert!((x - expected).abs() <= 8.0 * RULER_TOLERANCE / a.cos(), "{a}: {x} is not {expected}");
    }
    let (color, counters) =
        trace_down_counted(&scene, [0.0, -1.0], std::f64::consts::PI - critical + 1e-4, ALL);
    assert_eq!((counters.rays[RayKind::Reflected], counters.rays[RayKind::Transmitted]), (0, 1));
    assert_eq!(color, Rgb::BLACK, "the background is black");
}

#[test]
fn around_the_critical_angle_no_light_is_lost() {
    let material = Material { fresnel: FresnelModel::Dielectric, ..glass(1.5) };
    let scene = half_space(material, Rgb::WHITE, Rgb::WHITE);
    // From below, with the slope in single steps around the critical one.
    let critical = (1.0_f64 / 1.5).asin().tan() as Real;
    let mut slope = critical;
    for _ in 0..300 {
        slope = slope.next_down();
    }
    let mut passed = 0;
    for _ in 0..600 {
        let viewpoint = vec3(0.0, -1.0, 0.0);
        let (color, counters) = scene.trace_counted(viewpoint, vec3(slope, 0.0, 0.0), ALL);
        assert_gray(color, 1.0, ROUNDINGS);
        passed += counters.rays[RayKind::Transmitted];
        slope = slope.next_up();
    }
    // Half of them, up to some roundings of the angle.
    assert!(passed > 290 && passed < 310, "{passed}");
}
