//! Distributed effects: their expected value is known in closed form, and the error falls with the number of
//! rays.

use crate::*;

/// Numbers of samples between which the convergence is measured.
const FEW_SAMPLES: u32 = 16;
const MANY_SAMPLES: u32 = 1024;

/// Asserts that the mean of many rays is the expected value, and that the error of `n` rays falls at least as
/// `n` to the power of `slope`.
#[track_caller]
fn assert_converges(mean: impl Fn(u32, u32) -> f64, expected: f64, tolerance: f64, slope: f64) {
    let got = mean(16_384, 99);
    assert!((got - expected).abs() < tolerance * expected, "{got} is not {expected}");
    // The root mean square over many seeds.
    let error = |n| {
        let squares: f64 = (0..64).map(|seed| square(mean(n, seed) - expected)).sum();
        (squares / 64.0).sqrt()
    };
    let (few, many) = (error(FEW_SAMPLES), error(MANY_SAMPLES));
    let got = (many / few).ln() / f64::from(MANY_SAMPLES / FEW_SAMPLES).ln();
    assert!(got < slope, "the error falls from {few} to {many}: as n to the power of {got}");
}

fn square(x: f64) -> f64 {
    x * x
}

/// A white floor under one light, with a black background.
fn floor(source: LightSource) -> TestScene {
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::BLACK, ..Material::MATTE });
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.lights.push(Light { source, color: Rgb::WHITE, casts_shadows: true });
    scene
}

/// Mean brightness of the floor at `x`, seen from the side.
fn brightness_at(scene: &TestScene, x: f64, n: u32, seed: u32) -> f64 {
    let target = vec3(x as Real, 0.0, 0.0);
    scene.trace_samples(target + vec3(0.0, 1.0, -7.0), target, ALL, n, seed)[0]
}

/// Mean of a function over the unit disc.
fn over_disc(function: impl Fn(f64, f64) -> f64) -> f64 {
    // Finer across the edge than along it.
    let coordinate = |i: i32, n: i32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    let (mut sum, mut count) = (0.0, 0.0);
    for (u, v) in (0..8000).flat_map(|i| (0..125).map(move |j| (coordinate(i, 8000), coordinate(j, 125)))) {
        if u * u + v * v < 1.0 {
            sum += function(u, v);
            count += 1.0;
        }
    }
    sum / count
}

#[test]
fn a_straight_edge_occludes_the_part_of_a_sphere_light_behind_it() {
    let mut scene =
        floor(LightSource::Sphere { position: vec3(0.0, 8.0, 0.0), radius: 1.0, falloff: Falloff::NONE });
    // Everything to the right of x = 0, at half the height of the light.
    let corners = [(0.0, -50.0), (50.0, -50.0), (50.0, 50.0), (0.0, 50.0)];
    scene.polygon(&corners.map(|(x, z)| vec3(x, 4.0, z)), &[]);
    for x in [-0.7, -0.3, 0.0, 0.4, 0.8] {
        // The disc that faces the point: one axis along z, the other perpendicular to the direction of its
        // center.
        let length = f64::hypot(x, 8.0);
        let (along_x, along_y) = (8.0 / length, x / length);
        let expected = over_disc(|u, v| {
            let (px, py) = (u * along_x, 8.0 + u * along_y);
            // Where the shadow ray crosses the height of the edge, and the cosine on the floor.
            let crosses = x + (px - x) * 4.0 / py;
            if crosses < 0.0 { py / (square(px - x) + py * py + v * v).sqrt() } else { 0.0 }
        });
        // The tolerance is 1/2000 of the unoccluded light.
        assert_converges(|n, seed| brightness_at(&scene, x, n, seed), expected, 5e-4 / expected, -0.6);
    }
}

#[test]
fn a_rectangle_light_is_the_integral_over_its_area() {
    let half = [vec3(1.5, 0.0, 0.0), vec3(0.0, 0.0, 0.5)];
    let source = LightSource::Rectangle {
        position: vec3(1.0, 3.0, 0.5),
        half_edges: half,
        soft_shadows: true,
        falloff: Falloff::INVERSE_SQUARE,
    };
    // Its front looks down: x cross z is -y.
    let scene = floor(source);
    let n = 400;
    let coordinate = |i: i32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    let mut expected = 0.0;
    for (u, v) in (0..n).flat_map(|i| (0..n).map(move |j| (coordinate(i), coordinate(j)))) {
        let (x, y, z) = (1.0 + 1.5 * u, 3.0_f64, 0.5 + 0.5 * v);
        let square = x * x + y * y + z * z;
        // The cosines on the floor and at the light, over the squared distance.
        expected += y * y / square / square / f64::from(n * n);
    }
    assert_converges(|n, seed| brightness_at(&scene, 0.0, n, seed), expected, 1e-3, -0.9);
    // No light on its back.
    let half = [half[1], half[0]];
    let source = LightSource::Rectangle {
        position: vec3(1.0, 3.0, 0.5),
        half_edges: half,
        soft_shadows: true,
        falloff: Falloff::INVERSE_SQUARE,
    };
    assert_eq!(brightness_at(&floor(source), 0.0, 64, 0), 0.0);
}

#[test]
fn a_light_without_extent_is_a_point_light_at_its_center() {
    let position = vec3(0.5, 3.0, 1.0);
    let falloff = Falloff::INVERSE_SQUARE;
    let point = brightness_at(&floor(LightSource::Point { position, falloff }), 0.0, 1, 0);
    let sphere = brightness_at(&floor(LightSource::Sphere { position, radius: 0.0, falloff }), 0.0, 1, 0);
    assert_eq!(point, sphere);
    let half = [Vec3::X, Vec3::Z];
    let rectangle = brightness_at(
        &floor(LightSource::Rectangle { position, half_edges: half, soft_shadows: false, falloff }),
        0.0,
        1,
        0,
    );
    let cos = 3.0 / f64::sqrt(0.25 + 9.0 + 1.0);
    assert!((rectangle - point * cos).abs() < ROUNDINGS * point);
}

#[test]
fn a_rough_mirror_shows_the_mean_over_its_microfacets() {
    for roughness in [0.2, 0.5, 0.8] {
        let mut scene = TestScene::new();
        let mirror =
            Material { diffuse: Rgb::BLACK, ambient: Rgb::BLACK, reflection: Rgb::WHITE, ..Material::MATTE };
        scene.material(Material { roughness, ..mirror });
        scene.plane(Vec3::ZERO, Vec3::Y);
        scene.background = Background::Gradient { up: Vec3::Y, below: Rgb::BLACK, above: Rgb::WHITE };
        // Microfacets of the GGX distribution, seen from above: the squared cosine of their tilt is
        // (1 - t) / (1 + (s^2 - 1) t) for uniform t in 0..1, and the reflected direction has twice the tilt.
        let slope = square(f64::from(roughness));
        let n = 200_000;
        let expected: f64 = (0..n)
            .map(|i| {
                let t = (f64::from(i) + 0.5) / f64::from(n);
                let cos2 = (1.0 - t) / (1.0 + (slope * slope - 1.0) * t);
                0.5 + 0.5 * (2.0 * cos2 - 1.0).abs()
            })
            .sum::<f64>()
            / f64::from(n);
        let viewpoint = vec3(0.0, 2.0, 0.0);
        let mean = |n, seed| scene.trace_samples(viewpoint, Vec3::ZERO, ALL, n, seed)[0];
        assert_converges(mean, expected, 1e-3, -0.8);
    }
}

#[test]
fn rough_glass_loses_no_light() {
    // In a white environment everything is white, however light is refracted.
    let mut scene = TestScene::new();
    let glass = Material {
        transmission: Rgb::WHITE,
        refractive_index: 1.5,
        fresnel: FresnelModel::Dielectric,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    };
    scene.material(Material { diffuse: Rgb::BLACK, ambient: Rgb::BLACK, roughness: 0.5, ..glass });
    scene.sphere(Vec3::ZERO, 1.0);
    scene.background = Background::Color(Rgb::WHITE);
    let limits = Limits { levels: 40, cutoff: 1e-4 };
    let got = scene.trace_samples(vec3(0.4, 0.3, 5.0), vec3(0.4, 0.3, 0.0), limits, 64, 0)[0];
    assert!((got - 1.0).abs() < 5e-3, "{got}");
}

#[test]
fn light_through_panes_and_bodies_has_their_color() {
    let sun = LightSource::Directional { to_light: Vec3::Y };
    let floor_color = |scene: &TestScene| scene.trace(vec3(0.0, 1.0, -7.0), Vec3::ZERO, ALL);
    let mut scene = floor(sun);
    scene.colored_shadows = true;
    let tint = Rgb::new(0.5, 0.25, 0.0);
    scene.material(Material { transmission: tint, ambient: Rgb::WHITE, ..Material::MATTE });
    scene.disc(vec3(0.0, 2.0, 0.0), Vec3::Y, 1.0);
    assert_color(floor_color(&scene), [0.5, 0.25, 0.0], ROUNDINGS);
    // A second pane absorbs the same factor; without colored shadows each pane occludes.
    scene.disc(vec3(0.0, 3.0, 0.0), Vec3::Y, 1.0);
    assert_color(floor_color(&scene), [0.25, 0.0625, 0.0], ROUNDINGS);
    scene.colored_shadows = false;
    assert_eq!(floor_color(&scene), Rgb::BLACK);

    // Through the center of a sphere: two surfaces that reflect 4 % each, and a distance of 2.
    let mut scene = floor(sun);
    scene.colored_shadows = true;
    let attenuation_length = Rgb::new(2.0, 4.0, Real::INFINITY);
    let glass = Material {
        transmission: Rgb::WHITE,
        refractive_index: 1.5,
        attenuation_length,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    };
    scene.material(Material { fresnel: FresnelModel::Dielectric, ..glass });
    scene.sphere(vec3(0.0, 3.0, 0.0), 1.0);
    let through = |length: f64| 0.96 * 0.96 * (-2.0 / length).exp();
    assert_color(floor_color(&scene), [through(2.0), through(4.0), 0.96 * 0.96], 1e-5);
    // Opaque objects behind glass occlude.
    scene.material(Material::matte(Rgb::WHITE));
    scene.disc(vec3(0.0, 6.0, 0.0), Vec3::Y, 1.0);
    assert_eq!(floor_color(&scene), Rgb::BLACK);
}

#[test]
fn a_moving_disc_covers_a_point_for_the_time_it_is_over_it() {
    // From left to right, by 4 while the shutter is open, seen from above.
    let (radius, distance): (f64, f64) = (0.75, 4.0);
    let mut scene = TestScene::new();
    scene.material(unlit(Rgb::WHITE));
    scene.ambient = Rgb::WHITE;
    let disc = scene.disc(Vec3::ZERO, Vec3::Y, radius as Real);
    scene.set_motion(disc, vec3(-2.0, 0.0, 0.0), vec3((distance - 2.0) as Real, 0.0, 0.0));
    for (x, z) in [(0.05, 0.0), (0.3, 0.5), (-1.7, 0.2), (2.4, -0.3), (0.1, 0.74)] {
        // Half of the chord, and the times when its ends are over the point.
        let half = (square(radius) - square(z)).sqrt();
        let [start, end] = [x - half, x + half].map(|x: f64| ((x + 2.0) / distance).clamp(0.0, 1.0));
        let target = vec3(x as Real, 0.0, z as Real);
        let mean = |n, seed| scene.trace_samples(target + 3.0 * Vec3::Y, target, levels(1), n, seed)[0];
        // One or two of the many rays may be on the wrong side.
        let expected = end - start;
        assert_converges(mean, expected, 2.0 / 16_384.0 / expected, -0.9);
    }
    // Beside its path, and before its start and after its end.
    for (x, z) in [(0.0, 0.8), (-2.8, 0.0), (2.8, 0.0)] {
        let target = vec3(x, 0.0, z);
        assert_eq!(scene.trace_samples(target + 3.0 * Vec3::Y, target, levels(1), 64, 0)[0], 0.0, "{x} {z}");
    }
}

#[test]
fn a_texture_moves_with_its_item() {
    // A gradient over the disc. Only the left half of the disc passes over the point.
    let mut scene = TestScene::new();
    scene.ambient = Rgb::WHITE;
    let (from, to) = (Rgb::BLACK, Rgb::WHITE);
    let texture = scene.add_texture(Texture::Gradient {
        start_color: from,
        end_color: to,
        origin: -Vec3::X,
        axis: 2.0 * Vec3::X,
    });
    scene.material(Material { texture, ..unlit(Rgb::WHITE) });
    let disc = scene.disc(Vec3::ZERO, Vec3::Y, 1.0);
    // When the shutter opens the center of the disc is over the point, when it closes the left edge.
    scene.set_motion(disc, Vec3::ZERO, Vec3::X);
    let mean = |n, seed| scene.trace_samples(3.0 * Vec3::Y, Vec3::ZERO, levels(1), n, seed)[0];
    assert_converges(mean, 0.25, 1e-3, -0.9);
}

#[test]
fn shadow_rays_and_reflected_rays_have_the_time_of_the_camera_ray() {
    // A disc over the floor, seen beside its shadow.
    let mut scene = floor(LightSource::Directional { to_light: Vec3::Y });
    let disc = scene.disc(vec3(0.0, 1.0, 0.0), Vec3::Y, 0.5);
    scene.set_motion(disc, -Vec3::X, Vec3::X);
    let got = brightness_at(&scene, 0.0, 4096, 3);
    assert!((got - 0.5).abs() < 1e-3, "shadowed half of the time: {got}");
    // In a mirror under it, seen past it: black half of the time.
    let mut scene = TestScene::new();
    let mirror =
        Material { diffuse: Rgb::BLACK, ambient: Rgb::BLACK, reflection: Rgb::WHITE, ..Material::MATTE };
    scene.material(mirror);
    scene.plane(Vec3::ZERO, Vec3::Y);
    scene.background = Background::Color(Rgb::WHITE);
    scene.material(unlit(Rgb::BLACK));
    let disc = scene.disc(vec3(0.0, 1.0, 1.0), Vec3::Y, 0.5);
    scene.set_motion(disc, -Vec3::X, Vec3::X);
    let got = scene.trace_samples(vec3(0.0, 2.0, -2.0), Vec3::ZERO, ALL, 4096, 3)[0];
    assert!((got - 0.5).abs() < 1e-3, "{got}");
}

#[test]
fn a_point_out_of_focus_is_a_disc_of_confusion() {
    let (angle, rows, radius, focus, sphere_radius): (f64, u32, f64, f64, f64) = (0.5, 65, 0.25, 4.0, 0.02);
    let size = Resolution::new(rows, rows).unwrap();
    let mut scene = TestScene::new();
    scene.ambient = Rgb::WHITE;
    scene.material(unlit(Rgb::WHITE));
    for distance in [2.5, focus, 7.0] {
        let mut scene = scene.clone();
        scene.sphere(vec3(0.0, 0.0, -distance as Real), sphere_radius as Real);
        let projection = Projection::ThinLens {
            field_of_view: angle as Real,
            lens_radius: radius as Real,
            focus_distance: focus as Real,
        };
        let view = CameraDescriptor { position: Vec3::ZERO, target: -Vec3::Z, up: Vec3::Y, projection };
        let world = World::new(scene.as_scene(), List::without_bounds(1));
        let camera = Camera::new(&view, size).unwrap();
        let tracer = Tracer::<_, AllEffects, 1>::new(&world, camera, levels(1)).unwrap();
        let (mut light, mut second) = (0.0, 0.0);
        let mut sink = |pixel: Pixel, color: Rgb| {
            let from_center = |coordinate: u32| f64::from(coordinate) - f64::from(rows - 1) / 2.0;
            light += f64::from(color.r);
            second += f64::from(color.r) * (square(from_center(pixel.x)) + square(from_center(pixel.y)));
        };
        let mut sampler = StochasticSampler::new(256).unwrap();
        let pixels = Tile::full(size).pixels();
        let Ok(()) = render(&mut tracer.with_worker(&mut Worker::new(())), &mut sampler, pixels, &mut sink);
        // A disc of radius r has the second moment r^2 / 2. Those of the circle of confusion and of the
        // sphere add up, and that of the pixel, 1/12 for each axis. In pixels:
        let pixel = |length: f64, distance: f64| {
            length / distance / (2.0 * (angle / 2.0).tan() / f64::from(rows - 1))
        };
        let confusion = pixel(radius * (distance - focus).abs() / distance, focus);
        let expected = (square(confusion) + square(pixel(sphere_radius, distance))) / 2.0 + 2.0 / 12.0;
        let got = second / light;
        if distance == focus {
            // In focus: a sphere of half a pixel, whose light is in its pixel and partly in the next.
            assert!(got < 0.5, "{got}");
            continue;
        }
        assert!((got - expected).abs() < 0.03 * expected, "{distance}: {got} is not {expected}");
    }
}
