//! What rays leave to chance: its mean is known on paper, and many rays come nearer to it than
//! few.

use crate::*;

/// The smallest and the largest number of samples that convergence is looked at with.
const FEW: u32 = 16;
const MANY: u32 = 1024;

/// Holds the mean of many rays against what is known, and looks how fast it comes near: the
/// error of `n` rays must fall as `n` to the power of `slope` at least.
#[track_caller]
fn converges(mean: impl Fn(u32, u32) -> f64, want: f64, tolerance: f64, slope: f64) {
    let got = mean(16_384, 99);
    assert!((got - want).abs() < tolerance * want, "{got} is not {want}");
    // Of many seeds, the root of the mean square.
    let error = |n| {
        let squares: f64 = (0..64).map(|seed| square(mean(n, seed) - want)).sum();
        (squares / 64.0).sqrt()
    };
    let (few, many) = (error(FEW), error(MANY));
    let got = (many / few).ln() / f64::from(MANY / FEW).ln();
    assert!(got < slope, "the error falls from {few} to {many}: as n to the power of {got}");
}

fn square(x: f64) -> f64 {
    x * x
}

/// A white floor under one light, before nothing.
fn floor(source: Source) -> TestScene {
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::BLACK, ..Material::MATTE });
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.lights.push(Light { source, color: Rgb::WHITE, shadows: true });
    scene
}

/// The mean brightness of the floor at `x`, seen from the side.
fn at(scene: &TestScene, x: f64, n: u32, seed: u32) -> f64 {
    let target = vec3(x as Real, 0.0, 0.0);
    scene.trace_samples(target + vec3(0.0, 1.0, -7.0), target, ALL, n, seed)[0]
}

/// The mean over a disc of radius one of what is known of each place `(u, v)` on it.
fn over_disc(of: impl Fn(f64, f64) -> f64) -> f64 {
    // Finer across the edge than along it.
    let place = |i: i32, n: i32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    let (mut sum, mut count) = (0.0, 0.0);
    for (u, v) in (0..8000).flat_map(|i| (0..125).map(move |j| (place(i, 8000), place(j, 125)))) {
        if u * u + v * v < 1.0 {
            sum += of(u, v);
            count += 1.0;
        }
    }
    sum / count
}

#[test]
fn a_round_light_is_hidden_by_a_straight_edge_as_much_as_it_is() {
    let mut scene =
        floor(Source::Sphere { position: vec3(0.0, 8.0, 0.0), radius: 1.0, falloff: Falloff::NONE });
    // Everything to the right of x = 0, at half the height of the light.
    let corners = [(0.0, -50.0), (50.0, -50.0), (50.0, 50.0), (0.0, 50.0)];
    scene.polygon(&corners.map(|(x, z)| vec3(x, 4.0, z)), &[]);
    for x in [-0.7, -0.3, 0.0, 0.4, 0.8] {
        // The disc that faces the point: one axis along z, the other across the way to its middle.
        let length = f64::hypot(x, 8.0);
        let (along_x, along_y) = (8.0 / length, x / length);
        let want = over_disc(|u, v| {
            let (px, py) = (u * along_x, 8.0 + u * along_y);
            // Where the way crosses the height of the edge, and the cosine on the floor.
            let crosses = x + (px - x) * 4.0 / py;
            if crosses < 0.0 { py / (square(px - x) + py * py + v * v).sqrt() } else { 0.0 }
        });
        // Off by at most a two-thousandth of the whole light.
        converges(|n, seed| at(&scene, x, n, seed), want, 5e-4 / want, -0.6);
    }
}

#[test]
fn a_rectangle_gives_the_light_of_all_its_places() {
    let half = [vec3(1.5, 0.0, 0.0), vec3(0.0, 0.0, 0.5)];
    let source =
        Source::Rectangle { position: vec3(1.0, 3.0, 0.5), half, soft: true, falloff: Falloff::SQUARE };
    // Its front looks down: x cross z is -y.
    let scene = floor(source);
    let n = 400;
    let place = |i: i32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    let mut want = 0.0;
    for (u, v) in (0..n).flat_map(|i| (0..n).map(move |j| (place(i), place(j)))) {
        let (x, y, z) = (1.0 + 1.5 * u, 3.0_f64, 0.5 + 0.5 * v);
        let square = x * x + y * y + z * z;
        // The cosine on the floor, that of the light, and the square of the distance.
        want += y * y / square / square / f64::from(n * n);
    }
    converges(|n, seed| at(&scene, 0.0, n, seed), want, 1e-3, -0.9);
    // Nothing behind it.
    let half = [half[1], half[0]];
    let source =
        Source::Rectangle { position: vec3(1.0, 3.0, 0.5), half, soft: true, falloff: Falloff::SQUARE };
    assert_eq!(at(&floor(source), 0.0, 64, 0), 0.0);
}

#[test]
fn a_light_whose_extent_is_left_out_is_one_in_its_middle() {
    let position = vec3(0.5, 3.0, 1.0);
    let falloff = Falloff::SQUARE;
    let point = at(&floor(Source::Point { position, falloff }), 0.0, 1, 0);
    let sphere = at(&floor(Source::Sphere { position, radius: 0.0, falloff }), 0.0, 1, 0);
    assert_eq!(point, sphere);
    let half = [Vec3::X, Vec3::Z];
    let rectangle = at(&floor(Source::Rectangle { position, half, soft: false, falloff }), 0.0, 1, 0);
    let cos = 3.0 / f64::sqrt(0.25 + 9.0 + 1.0);
    assert!((rectangle - point * cos).abs() < ROUNDINGS * point);
}

#[test]
fn a_rough_mirror_shows_the_mean_of_what_its_facets_show() {
    for roughness in [0.2, 0.5, 0.8] {
        let mut scene = TestScene::new();
        let mirror =
            Material { diffuse: Rgb::BLACK, ambient: Rgb::BLACK, mirror: Rgb::WHITE, ..Material::MATTE };
        scene.material(Material { roughness, ..mirror });
        scene.plane(Vec3::ZERO, Vec3::Y);
        scene.background = Background::Gradient { up: Vec3::Y, below: Rgb::BLACK, above: Rgb::WHITE };
        // Facets of the GGX distribution, seen from above: the square of the cosine of their tilt
        // is (1 - t) / (1 + (s^2 - 1) t) for t evenly in 0..1, and light comes from twice the tilt.
        let slope = square(f64::from(roughness));
        let n = 200_000;
        let want: f64 = (0..n)
            .map(|i| {
                let t = (f64::from(i) + 0.5) / f64::from(n);
                let cos2 = (1.0 - t) / (1.0 + (slope * slope - 1.0) * t);
                0.5 + 0.5 * (2.0 * cos2 - 1.0).abs()
            })
            .sum::<f64>()
            / f64::from(n);
        let eye = vec3(0.0, 2.0, 0.0);
        let mean = |n, seed| scene.trace_samples(eye, Vec3::ZERO, ALL, n, seed)[0];
        converges(mean, want, 1e-3, -0.8);
    }
}

#[test]
fn rough_glass_loses_no_light() {
    // Inside of a white room everything is white, however light is broken.
    let mut scene = TestScene::new();
    let glass =
        Material { transmitted: Rgb::WHITE, index: 1.5, interface: Interface::Fresnel, ..Material::MATTE };
    scene.material(Material { diffuse: Rgb::BLACK, ambient: Rgb::BLACK, roughness: 0.5, ..glass });
    scene.sphere(Vec3::ZERO, 1.0);
    scene.background = Background::Color(Rgb::WHITE);
    let limits = Limits { levels: 40, cutoff: 1e-4 };
    let got = scene.trace_samples(vec3(0.4, 0.3, 5.0), vec3(0.4, 0.3, 0.0), limits, 64, 0)[0];
    assert!((got - 1.0).abs() < 5e-3, "{got}");
}

#[test]
fn light_through_panes_and_bodies_has_their_colours() {
    let sun = Source::Directional { toward: Vec3::Y };
    let look = |scene: &TestScene| scene.trace(vec3(0.0, 1.0, -7.0), Vec3::ZERO, ALL);
    let mut scene = floor(sun);
    scene.colored_shadows = true;
    let tint = Rgb::new(0.5, 0.25, 0.0);
    scene.material(Material { transmitted: tint, ..Material::MATTE });
    scene.disc(vec3(0.0, 2.0, 0.0), Vec3::Y, 1.0);
    assert_color(look(&scene), [0.5, 0.25, 0.0], ROUNDINGS);
    // A second pane takes as much again, and without the scene's key none lets light through.
    scene.disc(vec3(0.0, 3.0, 0.0), Vec3::Y, 1.0);
    assert_color(look(&scene), [0.25, 0.0625, 0.0], ROUNDINGS);
    scene.colored_shadows = false;
    assert_eq!(look(&scene), Rgb::BLACK);

    // Through the middle of a ball: two surfaces, each mirrors 4 %, and two lengths of way.
    let mut scene = floor(sun);
    scene.colored_shadows = true;
    let clarity = Rgb::new(2.0, 4.0, Real::INFINITY);
    let glass = Material { transmitted: Rgb::WHITE, index: 1.5, clarity, ..Material::MATTE };
    scene.material(Material { interface: Interface::Fresnel, ..glass });
    scene.sphere(vec3(0.0, 3.0, 0.0), 1.0);
    let through = |clarity: f64| 0.96 * 0.96 * (-2.0 / clarity).exp();
    assert_color(look(&scene), [through(2.0), through(4.0), 0.96 * 0.96], 1e-5);
    // What is opaque stays so behind glass.
    scene.material(Material::MATTE);
    scene.disc(vec3(0.0, 6.0, 0.0), Vec3::Y, 1.0);
    assert_eq!(look(&scene), Rgb::BLACK);
}

#[test]
fn a_moving_disc_covers_a_place_as_long_as_it_is_over_it() {
    // From the left to the right at four lengths in a shutter's time, seen from above.
    let (radius, way): (f64, f64) = (0.75, 4.0);
    let mut scene = TestScene::new();
    scene.material(shining(Rgb::WHITE));
    scene.ambient = Rgb::WHITE;
    let disc = scene.disc(Vec3::ZERO, Vec3::Y, radius as Real);
    scene.set_motion(disc, vec3(-2.0, 0.0, 0.0), vec3((way - 2.0) as Real, 0.0, 0.0));
    for (x, z) in [(0.05, 0.0), (0.3, 0.5), (-1.7, 0.2), (2.4, -0.3), (0.1, 0.74)] {
        // Half of the chord, and when its middle comes to lie over the place.
        let half = (square(radius) - square(z)).sqrt();
        let [begins, ends] = [x - half, x + half].map(|x: f64| ((x + 2.0) / way).clamp(0.0, 1.0));
        let target = vec3(x as Real, 0.0, z as Real);
        let mean = |n, seed| scene.trace_samples(target + 3.0 * Vec3::Y, target, levels(1), n, seed)[0];
        // Of the many rays one or two may be on the wrong side.
        let want = ends - begins;
        converges(mean, want, 2.0 / 16_384.0 / want, -0.9);
    }
    // Beside its way, and before and behind it.
    for (x, z) in [(0.0, 0.8), (-2.8, 0.0), (2.8, 0.0)] {
        let target = vec3(x, 0.0, z);
        assert_eq!(scene.trace_samples(target + 3.0 * Vec3::Y, target, levels(1), 64, 0)[0], 0.0, "{x} {z}");
    }
}

#[test]
fn a_texture_moves_with_what_it_is_on() {
    // A gradient over the disc, which is over the place with its left half first.
    let mut scene = TestScene::new();
    scene.ambient = Rgb::WHITE;
    let (from, to) = (Rgb::BLACK, Rgb::WHITE);
    let texture = scene.add_texture(Texture::Gradient { from, to, origin: -Vec3::X, along: 2.0 * Vec3::X });
    scene.material(Material { texture, ..shining(Rgb::WHITE) });
    let disc = scene.disc(Vec3::ZERO, Vec3::Y, 1.0);
    // At the end of the time its left rim is over the place, at the beginning its middle.
    scene.set_motion(disc, Vec3::ZERO, Vec3::X);
    let mean = |n, seed| scene.trace_samples(3.0 * Vec3::Y, Vec3::ZERO, levels(1), n, seed)[0];
    converges(mean, 0.25, 1e-3, -0.9);
}

#[test]
fn shadows_and_mirrors_see_the_time_of_the_camera_ray() {
    // A disc over the floor, seen beside its shadow: a place is either covered or shadowed.
    let mut scene = floor(Source::Directional { toward: Vec3::Y });
    let disc = scene.disc(vec3(0.0, 1.0, 0.0), Vec3::Y, 0.5);
    scene.set_motion(disc, -Vec3::X, Vec3::X);
    let got = at(&scene, 0.0, 4096, 3);
    assert!((got - 0.5).abs() < 1e-3, "in its shadow half of the time: {got}");
    // In a mirror under it, seen past it: half of the time dark, and never both.
    let mut scene = TestScene::new();
    let mirror = Material { diffuse: Rgb::BLACK, ambient: Rgb::BLACK, mirror: Rgb::WHITE, ..Material::MATTE };
    scene.material(mirror);
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.background = Background::Color(Rgb::WHITE);
    scene.material(shining(Rgb::BLACK));
    let disc = scene.disc(vec3(0.0, 1.0, 1.0), Vec3::Y, 0.5);
    scene.set_motion(disc, -Vec3::X, Vec3::X);
    let got = scene.trace_samples(vec3(0.0, 2.0, -2.0), Vec3::ZERO, ALL, 4096, 3)[0];
    assert!((got - 0.5).abs() < 1e-3, "{got}");
}

#[test]
fn a_point_out_of_focus_is_a_disc_of_confusion() {
    let (angle, rows, radius, focus, ball): (f64, u32, f64, f64, f64) = (0.5, 65, 0.25, 4.0, 0.02);
    let size = Resolution::new(rows, rows).unwrap();
    let mut scene = TestScene::new();
    scene.ambient = Rgb::WHITE;
    scene.material(shining(Rgb::WHITE));
    for distance in [2.5, focus, 7.0] {
        let mut scene = scene.clone();
        scene.sphere(vec3(0.0, 0.0, -distance as Real), ball as Real);
        let projection =
            Projection::Lens { angle: angle as Real, radius: radius as Real, focus: focus as Real };
        let view = View { from: Vec3::ZERO, at: -Vec3::Z, up: Vec3::Y, projection };
        let world = World::new(scene.as_scene(), List::without_bounds(1));
        let camera = Camera::new(&view, size).unwrap();
        let tracer = Tracer::<_, AllEffects, 1>::new(&world, camera, levels(1)).unwrap();
        let (mut light, mut second) = (0.0, 0.0);
        let mut sink = |pixel: Pixel, color: Rgb| {
            let from_middle = |place: u32| f64::from(place) - f64::from(rows - 1) / 2.0;
            light += f64::from(color.r);
            second += f64::from(color.r) * (square(from_middle(pixel.x)) + square(from_middle(pixel.y)));
        };
        let mut sampler = Stochastic::new(256).unwrap();
        let pixels = Tile::whole(size).pixels();
        let Ok(()) = render(&mut tracer.with_worker(&mut Worker::new(())), &mut sampler, pixels, &mut sink);
        // A disc of radius r has the second moment r^2 / 2. Two of them, that of confusion and the
        // ball, add up, and so does the pixel: 1/12 for each axis. In pixels:
        let pixel = |length: f64, distance: f64| {
            length / distance / (2.0 * (angle / 2.0).tan() / f64::from(rows - 1))
        };
        let confusion = pixel(radius * (distance - focus).abs() / distance, focus);
        let want = (square(confusion) + square(pixel(ball, distance))) / 2.0 + 2.0 / 12.0;
        let got = second / light;
        if distance == focus {
            // In focus: a ball of half a pixel, whose light lies in its pixel and some of the next.
            assert!(got < 0.5, "{got}");
            continue;
        }
        assert!((got - want).abs() < 0.03 * want, "{distance}: {got} is not {want}");
    }
}
