//! Scaled, mirrored and permuted scenes have the same hits.

use strahl_core::accel::List;
use strahl_core::image::Framebuffer;
use strahl_core::math::try_normalize;
use strahl_core::scene::{FresnelModel, Texture};
use strahl_core::{
    AllEffects, Background, Camera, CameraDescriptor, CenterSampler, Falloff, Light, LightSource, Limits,
    Material, Projection, Resolution, Rgb, Tile, Tracer, Vec3, Worker, World, render, vec3,
};
use strahl_test_scene::{
    CoreHit, DVec3, SplitMix64, TestRay, TestScene, TestShape, TestShapeKind, TestedCore, dvec3,
};
use strahl_tests::hard::cases;
use strahl_tests::oracle::{OracleAnswer, intersect, size};

const SEED: u64 = 0x5eed_0006;

fn power_of_two(k: i32) -> f32 {
    (0..k.abs()).fold(1.0, |x, _| if k < 0 { x * 0.5 } else { x * 2.0 })
}

/// A picture of all shapes in matte materials, rough mirrors and glass under all lights, with every length
/// multiplied by `scale`, a power of two.
fn picture(scale: f32, has_lens: bool) -> Vec<[u32; 3]> {
    let scale_f64 = f64::from(scale);
    let mut rng = SplitMix64::new(SEED);
    let mut scene = TestScene::new();
    let checker = scene.add_texture(Texture::Checker {
        even: Rgb::WHITE,
        odd: Rgb::gray(0.25),
        origin: vec3(0.3, 0.2, 0.1) * scale,
        frequency: vec3(1.3, 0.7, 1.1) / scale,
    });
    let gradient = scene.add_texture(Texture::Gradient {
        start_color: Rgb::WHITE,
        end_color: Rgb::new(0.9, 0.5, 0.1),
        origin: vec3(0.0, -2.0, 0.0) * scale,
        axis: vec3(0.3, 4.0, 0.1) * scale,
    });
    let zones = scene.add_texture(Texture::ZonePlate {
        start_color: Rgb::WHITE,
        end_color: Rgb::new(0.2, 0.7, 0.9),
        origin: vec3(0.5, 0.1, -0.4) * scale,
        frequency: 0.3 / (scale * scale),
    });
    let shiny = Material {
        highlight: Rgb::gray(0.5),
        highlight_exponent: 20.0,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    };
    let materials = [
        Material { texture: checker, ..shiny },
        Material { texture: gradient, reflection: Rgb::gray(0.5), ..shiny },
        Material { texture: zones, reflection: Rgb::gray(0.3), roughness: 0.3, ..shiny },
        Material {
            transmission: Rgb::gray(0.9),
            refractive_index: 1.5,
            fresnel: FresnelModel::Dielectric,
            attenuation_length: Rgb::new(3.0, 4.0, 5.0) * scale,
            diffuse: Rgb::BLACK,
            ..shiny
        },
    ];
    scene.material(materials[0]);
    scene.plane(vec3(0.0, -3.0, 0.0) * scale, Vec3::Y);
    for i in 0..42 {
        scene.material(materials[i % materials.len()]);
        let kind = TestShapeKind::ALL[i % TestShapeKind::ALL.len()];
        if kind != TestShapeKind::Plane {
            let shape = TestShape::random(kind, rng.in_ball(DVec3::ZERO, 3.0), 0.8, &mut rng);
            scene.add_shape(&shape.mapped(|p| p * scale_f64, |d| d, scale_f64));
        }
    }
    let falloff = Falloff { constant: 1.0, linear: 0.01 / scale, quadratic: 0.001 / (scale * scale) };
    let position = vec3(6.0, 8.0, 3.0);
    let direction = try_normalize(-position).unwrap();
    for source in [
        LightSource::Point { position: vec3(-5.0, 9.0, 6.0) * scale, falloff },
        LightSource::Directional { to_light: Vec3::Y },
        LightSource::Sphere { position: vec3(4.0, 7.0, 8.0) * scale, radius: 0.7 * scale, falloff },
        LightSource::Rectangle {
            position: vec3(-4.0, 8.0, -2.0) * scale,
            half_edges: [Vec3::X * scale, Vec3::Z * (0.5 * scale)],
            soft_shadows: true,
            falloff,
        },
        LightSource::Spot { position: position * scale, direction, cos_inner: 0.95, cos_outer: 0.9, falloff },
    ] {
        scene.lights.push(Light { source, color: Rgb::gray(0.4), casts_shadows: true });
    }
    scene.ambient = Rgb::gray(0.1);
    scene.colored_shadows = true;
    scene.background =
        Background::Gradient { up: Vec3::Y, below: Rgb::BLACK, above: Rgb::new(0.2, 0.4, 0.9) };

    let size = Resolution::new(32, 24).unwrap();
    let view = CameraDescriptor {
        position: vec3(1.0, 2.0, 11.0) * scale,
        target: vec3(0.1, -0.2, 0.0) * scale,
        up: Vec3::Y,
        projection: if has_lens {
            Projection::ThinLens { field_of_view: 0.8, lens_radius: 0.2 * scale, focus_distance: 9.0 * scale }
        } else {
            Projection::Perspective { field_of_view: 0.8 }
        },
    };
    let camera = Camera::new(&view, size).unwrap();
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let limits = Limits { levels: 6, cutoff: 0.0 };
    let tracer = Tracer::<_, AllEffects, 6>::new(&world, camera, limits).unwrap();
    let tile = Tile::full(size);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Framebuffer::new(tile, &mut colors).unwrap();
    let Ok(()) =
        render(&mut tracer.with_worker(&mut Worker::new(())), &mut CenterSampler, tile.pixels(), &mut frame);
    colors.iter().map(|color| [color.r, color.g, color.b].map(f32::to_bits)).collect()
}

#[test]
fn a_scaled_scene_gives_the_same_picture_bit_for_bit() {
    let expected_pictures = [false, true].map(|has_lens| picture(1.0, has_lens));
    for expected in &expected_pictures {
        let colors: std::collections::BTreeSet<_> = expected.iter().collect();
        assert!(colors.len() > 500, "only {} colors", colors.len());
    }
    assert!(expected_pictures[0] != expected_pictures[1]);
    for k in -20..=20 {
        // With and without a lens, in turn.
        let has_lens = k % 2 == 0;
        assert!(picture(power_of_two(k), has_lens) == expected_pictures[usize::from(has_lens)], "2^{k}");
    }
}

/// Shapes of every kind and hard ones, and rays at them.
fn scenes(rng: &mut SplitMix64) -> Vec<(TestShape, Vec<TestRay>)> {
    let mut scenes = Vec::new();
    for kind in TestShapeKind::ALL {
        for _ in 0..20 {
            let center = rng.in_ball(DVec3::ZERO, 5.0);
            let shape = TestShape::random(kind, center, rng.log_between(0.1, 3.0), rng);
            let ray = |rng: &mut SplitMix64| {
                let (viewpoint, target) = (rng.in_ball(center, 12.0), rng.in_ball(center, 3.0));
                let speed = rng.log_between(0.1, 10.0);
                let direction = (target - viewpoint) * speed;
                TestRay {
                    origin: viewpoint,
                    direction: dvec3(
                        direction.x as f32 as f64,
                        direction.y as f32 as f64,
                        direction.z as f32 as f64,
                    ),
                }
            };
            scenes.push((shape, (0..30).map(|_| ray(rng)).collect()));
        }
    }
    // Distances along directions of length 1e-30 overflow.
    let hard = cases().into_iter().filter(|case| !case.name.contains("1e-30"));
    scenes.extend(hard.flat_map(|case| case.aims(10)));
    scenes
}

#[test]
fn distances_scale_with_the_scene_bit_for_bit() {
    let mut rng = SplitMix64::new(SEED + 1);
    let mut hits = 0;
    for (shape, rays) in scenes(&mut rng) {
        let expected = TestScene::with_shapes(std::slice::from_ref(&shape)).cast(&rays);
        for k in [-20, -7, -1, 1, 13, 20] {
            let scale = f64::from(power_of_two(k));
            let larger = shape.mapped(|p| p * scale, |d| d, scale);
            let other_rays: Vec<TestRay> =
                rays.iter().map(|ray| TestRay { origin: ray.origin * scale, ..*ray }).collect();
            let answers = TestScene::with_shapes(&[larger]).cast(&other_rays);
            for ((ray, expected), answer) in rays.iter().zip(&expected).zip(answers) {
                let scaled = |hit: &CoreHit| CoreHit {
                    t: hit.t * scale,
                    point: hit.point * scale,
                    error: hit.error * scale,
                    ..*hit
                };
                assert_eq!(answer, expected.as_ref().map(scaled), "2^{k}: {shape:?}\n{ray:?}");
                hits += usize::from(answer.is_some());
            }
        }
    }
    assert!(hits > 20_000, "{hits}");
}

/// Whether the winding of the vertices determines the normal, so that mirroring flips it.
fn is_handed(shape: &TestShape) -> bool {
    matches!(
        shape,
        TestShape::Triangle { .. }
            | TestShape::SmoothTriangle { .. }
            | TestShape::Polygon { .. }
            | TestShape::SmoothPolygon { .. }
    )
}

#[test]
fn a_mirrored_scene_has_the_mirrored_hits_bit_for_bit() {
    let mut rng = SplitMix64::new(SEED + 2);
    let mut hits = 0;
    for (shape, rays) in scenes(&mut rng) {
        let expected = TestScene::with_shapes(std::slice::from_ref(&shape)).cast(&rays);
        for sides in [dvec3(-1.0, 1.0, 1.0), dvec3(1.0, -1.0, 1.0), dvec3(1.0, 1.0, -1.0)] {
            let mirrored = |v: DVec3| v * sides;
            let other = shape.mapped(mirrored, mirrored, 1.0);
            let other_rays: Vec<TestRay> = rays
                .iter()
                .map(|ray| TestRay { origin: mirrored(ray.origin), direction: mirrored(ray.direction) })
                .collect();
            let answers = TestScene::with_shapes(&[other]).cast(&other_rays);
            for ((ray, expected), answer) in rays.iter().zip(&expected).zip(answers) {
                // An edge of a polygon contains its lower end and not its upper one.
                let may_differ = matches!(shape, TestShape::Polygon { .. } | TestShape::SmoothPolygon { .. })
                    && matches!(intersect(&shape, ray), OracleAnswer::Unclear);
                if may_differ {
                    continue;
                }
                let sign = if is_handed(&shape) { -1.0 } else { 1.0 };
                let mirrored_hit =
                    |hit: &CoreHit| (hit.t, mirrored(hit.point), mirrored(hit.normal) * sign, hit.error);
                let got = answer.map(|hit| (hit.t, hit.point, hit.normal, hit.error));
                assert_eq!(got, expected.as_ref().map(mirrored_hit), "{sides:?}: {shape:?}\n{ray:?}");
                hits += usize::from(answer.is_some());
            }
        }
    }
    assert!(hits > 10_000, "{hits}");
}

#[test]
fn a_scene_with_permuted_axes_has_the_same_hits_up_to_rounding() {
    // Sums of three products round in the order of the axes. Shapes without such sums are hit equally, bit
    // for bit: triangles, whose test projects along one axis, and axis-aligned boxes.
    let mut rng = SplitMix64::new(SEED + 3);
    let mut hits = 0;
    for (shape, rays) in scenes(&mut rng) {
        let is_exact = matches!(
            shape,
            TestShape::Triangle { .. } | TestShape::SmoothTriangle { .. } | TestShape::Cuboid { .. }
        );
        let expected = TestScene::with_shapes(std::slice::from_ref(&shape)).cast(&rays);
        for turns in [1, 2] {
            let permuted = |v: DVec3| if turns == 1 { dvec3(v.y, v.z, v.x) } else { dvec3(v.z, v.x, v.y) };
            let other = shape.mapped(permuted, permuted, 1.0);
            let other_rays: Vec<TestRay> = rays
                .iter()
                .map(|ray| TestRay { origin: permuted(ray.origin), direction: permuted(ray.direction) })
                .collect();
            for ((ray, expected), answer) in
                rays.iter().zip(&expected).zip(TestScene::with_shapes(&[other]).cast(&other_rays))
            {
                let context = || format!("{shape:?}\n{ray:?}\n{expected:?}\n{answer:?}");
                let t = |hit: &CoreHit| hit.t;
                if is_exact {
                    assert_eq!(answer.as_ref().map(t), expected.as_ref().map(t), "{}", context());
                } else if let OracleAnswer::Hit(contact) = intersect(&shape, ray) {
                    let (Some(one), Some(other)) = (expected, answer) else { panic!("{}", context()) };
                    // Each has an error of at most 4 units in the last place (8 for cones and tori).
                    let conditioning = size(&shape, ray) / contact.slope + contact.distance;
                    let speed = ray.direction.dot(ray.direction).sqrt();
                    let off = (one.t - other.t).abs() * speed;
                    assert!(off <= 8.0 * f64::from(f32::EPSILON) * conditioning, "{}", context());
                }
                hits += usize::from(answer.is_some());
            }
        }
    }
    assert!(hits > 5_000, "{hits}");
}
