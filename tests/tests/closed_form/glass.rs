//! Glass: where light goes that passes it, and how much of it.

use crate::*;

/// Clear glass that adds nothing of its own.
const fn glass(index: Real) -> Material {
    Material { transmitted: Rgb::WHITE, index, ..shining(Rgb::BLACK) }
}

/// A plate from `bottom` to `top`, without an end to the sides.
fn plate(scene: &mut TestScene, material: Material, bottom: Real, top: Real) {
    scene.material(material);
    scene.cuboid(vec3(-1e3, bottom, -1e3), vec3(1e3, top, 1e3));
}

/// Snell: the angle behind a surface.
fn behind(angle: f64, index: f64) -> f64 {
    (angle.sin() / index).asin()
}

const ANGLES: [f64; 6] = [0.0, 0.1, 0.5, 0.9, 1.2, -0.7];

#[test]
fn a_plate_moves_light_sideways_by_snells_offset() {
    for index in [1.33, 1.5, 2.42, 0.8] {
        for depth in [0.25, 1.0] {
            let mut scene = TestScene::new();
            plate(&mut scene, glass(index), -depth, 0.0);
            ruler(&mut scene, -2.0);
            let (n, d) = (f64::from(index), f64::from(depth));
            for a in ANGLES.into_iter().filter(|a| a.sin().abs() < 0.79) {
                let b = behind(a, n);
                let offset = d * a.sin() * (1.0 - a.cos() / (n * b.cos()));
                // 1.5 through the air above the plate; across the wall the offset is longer.
                let want = 3.5 * a.tan() - offset / a.cos();
                let x = 1.5 * a.tan() - 1.5 * a.tan();
                let seen = place(slanted(&scene, [x, 1.5], a, ALL));
                assert!((seen - want).abs() <= 4.0 * READING / a.cos(), "{index} {a}: {seen} is not {want}");
            }
        }
    }
}

#[test]
fn light_leaves_a_plate_parallel_to_how_it_came() {
    let seen = |height: f64, a: f64| {
        let mut scene = TestScene::new();
        plate(&mut scene, glass(1.5), -1.0, 0.0);
        ruler(&mut scene, height);
        place(slanted(&scene, [0.0, 0.5], a, ALL))
    };
    for a in ANGLES {
        let (near, far) = (seen(-1.25, a), seen(-2.75, a));
        assert!((far - near - 1.5 * a.tan()).abs() <= 4.0 * READING / a.cos(), "{a}: from {near} to {far}");
    }
}

#[test]
fn a_ball_of_glass_turns_light_by_twice_the_difference_of_the_angles() {
    let mut scene = TestScene::new();
    scene.material(glass(1.5));
    scene.sphere(Vec3::ZERO, 2.0);
    // The background tells how high the direction is.
    scene.background = Background::Gradient { up: Vec3::Y, below: Rgb::BLACK, above: Rgb::WHITE };
    for h in [0.0, 0.25, 1.0, -1.5, 1.9] {
        let a = (h / 2.0_f64).asin();
        let turned = 2.0 * (a - behind(a, 1.5));
        let eye = vec3(-5.0, h as Real, 0.0);
        let (color, counters) = scene.trace_counted(eye, eye + Vec3::X, ALL);
        assert_eq!(counters.rays[RayKind::Transmitted], 2);
        let want = 0.5 - 0.5 * turned.sin();
        assert!(
            (f64::from(color.r) - want).abs() <= 4.0 * ROUNDINGS / a.cos(),
            "{h}: {color:?} is not {want}"
        );
    }
}

#[test]
fn a_pane_of_index_one_does_not_bend_light() {
    let with = |put: &dyn Fn(&mut TestScene)| {
        let mut scene = TestScene::new();
        put(&mut scene);
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
        let want = place(slanted(&air, [0.0, 1.0], a, ALL));
        for scene in [&pane, &block] {
            let seen = place(slanted(scene, [0.0, 1.0], a, ALL));
            assert!((seen - want).abs() <= READING / a.cos(), "{a}: {seen} is not {want}");
        }
    }
}

/// Glass below y = 0 with a floor that shines in `inside`, and a ceiling above in `outside`.
fn half_space(material: Material, inside: Rgb, outside: Rgb) -> TestScene {
    let mut scene = TestScene::new();
    scene.material(material);
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.material(shining(inside));
    scene.plane(vec3(0.0, -2.0, 0.0), Vec3::Y);
    scene.material(shining(outside));
    scene.plane(vec3(0.0, 3.0, 0.0), Vec3::Y);
    scene.ambient = Rgb::WHITE;
    scene
}

#[test]
fn a_constant_interface_gives_the_shares_that_the_material_names() {
    let shares =
        Material { mirror: Rgb::new(0.25, 0.5, 0.0), transmitted: Rgb::new(0.5, 0.25, 1.0), ..glass(1.5) };
    let scene = half_space(shares, Rgb::new(1.0, 0.5, 0.25), Rgb::new(0.25, 1.0, 0.5));
    for a in ANGLES {
        let (color, counters) = slanted_and_counted(&scene, [0.0, 1.0], a, ALL);
        // ks times the ceiling, kt times the floor, whatever the angle.
        assert_eq!(color, Rgb::new(0.5625, 0.625, 0.25), "{a}");
        assert_eq!((counters.rays[RayKind::Reflected], counters.rays[RayKind::Transmitted]), (1, 1));
    }
}

/// Fresnel's formulas by the angles: the mirrored share of unpolarised light.
fn fresnel(a: f64, b: f64) -> f64 {
    let across = (a - b).sin() / (a + b).sin();
    let along = (a - b).tan() / (a + b).tan();
    0.5 * (across * across + along * along)
}

#[test]
fn a_fresnel_interface_mirrors_as_much_as_the_angles_say() {
    let (floor, ceiling) = (Rgb::new(1.0, 0.0, 0.25), Rgb::new(0.0, 1.0, 0.5));
    let scene = half_space(Material { interface: Interface::Fresnel, ..glass(1.5) }, floor, ceiling);
    let look = |a| slanted(&scene, [0.0, 1.0], a, ALL);
    // The mirrored share is a difference of two numbers near one: it is right to some of their
    // roundings, not of its own.
    let near = |color: Rgb, share: f64| {
        let want = [1.0 - share, share, 0.25 * (1.0 - share) + 0.5 * share];
        for (got, want) in [color.r, color.g, color.b].map(f64::from).into_iter().zip(want) {
            assert!((got - want).abs() <= ROUNDINGS, "{got} is not {want}");
        }
    };
    near(look(0.0), 0.04);
    for a in [0.1_f64, 0.5, 0.9, 1.2, -0.7] {
        near(look(a), fresnel(a.abs(), behind(a.abs(), 1.5)));
    }
}

#[test]
fn the_shares_of_a_fresnel_interface_add_up_to_one() {
    let material = Material { interface: Interface::Fresnel, ..glass(1.5) };
    let scene = half_space(material, Rgb::WHITE, Rgb::WHITE);
    for i in 0..150 {
        let a = 0.01 * f64::from(i);
        // From above into the glass, and from inside it out or not.
        assert_gray(slanted(&scene, [0.0, 1.0], a, ALL), 1.0, ROUNDINGS);
        assert_gray(slanted(&scene, [0.0, -1.0], std::f64::consts::PI - a, ALL), 1.0, ROUNDINGS);
    }
    // The paint of the glass itself counts for both.
    let tinted = Material { transmitted: Rgb::new(0.5, 0.25, 0.75), ..material };
    let scene = half_space(tinted, Rgb::WHITE, Rgb::WHITE);
    assert_color(slanted(&scene, [0.0, 1.0], 1.0, ALL), [0.5, 0.25, 0.75], ROUNDINGS);
}

#[test]
fn beyond_the_critical_angle_the_transmitted_share_goes_where_a_mirror_sends_it() {
    let kt = 0.75;
    let mut scene = TestScene::new();
    scene.material(Material { transmitted: Rgb::gray(kt), ..glass(1.5) });
    scene.plane(Vec3::ZERO, Vec3::Y);
    ruler(&mut scene, -2.0);
    let critical = (1.0_f64 / 1.5).asin();
    for a in [critical + 1e-4, 0.9, 1.1, 1.2] {
        let upward = std::f64::consts::PI - a;
        let (color, counters) = slanted_and_counted(&scene, [0.0, -1.0], upward, ALL);
        assert_eq!((counters.rays[RayKind::Reflected], counters.rays[RayKind::Transmitted]), (1, 0), "{a}");
        // One up and two down.
        let (x, want) = (place(color * (1.0 / kt)), 3.0 * a.tan());
        assert!((x - want).abs() <= 8.0 * READING / a.cos(), "{a}: {x} is not {want}");
    }
    let (color, counters) =
        slanted_and_counted(&scene, [0.0, -1.0], std::f64::consts::PI - critical + 1e-4, ALL);
    assert_eq!((counters.rays[RayKind::Reflected], counters.rays[RayKind::Transmitted]), (0, 1));
    assert_eq!(color, Rgb::BLACK, "there is nothing above");
}

#[test]
fn around_the_critical_angle_no_light_is_lost() {
    let material = Material { interface: Interface::Fresnel, ..glass(1.5) };
    let scene = half_space(material, Rgb::WHITE, Rgb::WHITE);
    // At the surface from below, in single steps of the slope to both sides.
    let critical = (1.0_f64 / 1.5).asin().tan() as Real;
    let mut slope = critical;
    for _ in 0..300 {
        slope = slope.next_down();
    }
    let mut passed = 0;
    for _ in 0..600 {
        let eye = vec3(0.0, -1.0, 0.0);
        let (color, counters) = scene.trace_counted(eye, vec3(slope, 0.0, 0.0), ALL);
        assert_gray(color, 1.0, ROUNDINGS);
        passed += counters.rays[RayKind::Transmitted];
        slope = slope.next_up();
    }
    // Half of them, but for some roundings of the angle.
    assert!(passed > 290 && passed < 310, "{passed}");
}
