//! A scene of another size, mirrored, or with its axes in another order, is the same scene.

use strahl_core::accel::List;
use strahl_core::image::Frame;
use strahl_core::math::try_normalize;
use strahl_core::scene::{Interface, Texture};
use strahl_core::{
    AllEffects, Background, Camera, Falloff, Light, Limits, Material, Projection, Resolution, Rgb, Single,
    Source, Tile, Tracer, Vec3, View, Worker, World, render, vec3,
};
use strahl_tests::hard::cases;
use strahl_tests::oracle::{Truth, meet, size};
use strahl_tests::single::Stage;
use strahl_tests::{Core, Found, Kind, Line, Random, Thing, Vector, vector};

const SEED: u64 = 0x5eed_0006;

fn power_of_two(k: i32) -> f32 {
    (0..k.abs()).fold(1.0, |x, _| if k < 0 { x * 0.5 } else { x * 2.0 })
}

/// All shapes in paint, rough mirrors and glass under all lights, with every length times `scale`,
/// which is a power of two, through a lens or none.
fn picture(scale: f32, has_lens: bool) -> Vec<[u32; 3]> {
    let wide = f64::from(scale);
    let mut random = Random::new(SEED);
    let mut stage = Stage::new();
    let checker = stage.add_texture(Texture::Checker {
        even: Rgb::WHITE,
        odd: Rgb::gray(0.25),
        origin: vec3(0.3, 0.2, 0.1) * scale,
        frequency: vec3(1.3, 0.7, 1.1) / scale,
    });
    let gradient = stage.add_texture(Texture::Gradient {
        from: Rgb::WHITE,
        to: Rgb::new(0.9, 0.5, 0.1),
        origin: vec3(0.0, -2.0, 0.0) * scale,
        along: vec3(0.3, 4.0, 0.1) * scale,
    });
    let zones = stage.add_texture(Texture::ZonePlate {
        from: Rgb::WHITE,
        to: Rgb::new(0.2, 0.7, 0.9),
        origin: vec3(0.5, 0.1, -0.4) * scale,
        frequency: 0.3 / (scale * scale),
    });
    let paint = Material { highlight: Rgb::gray(0.5), exponent: 20.0, ..Material::MATTE };
    let materials = [
        Material { texture: checker, ..paint },
        Material { texture: gradient, mirror: Rgb::gray(0.5), ..paint },
        Material { texture: zones, mirror: Rgb::gray(0.3), roughness: 0.3, ..paint },
        Material {
            transmitted: Rgb::gray(0.9),
            index: 1.5,
            interface: Interface::Fresnel,
            clarity: Rgb::new(3.0, 4.0, 5.0) * scale,
            diffuse: Rgb::BLACK,
            ..paint
        },
    ];
    stage.material(materials[0]);
    stage.plane(vec3(0.0, -3.0, 0.0) * scale, Vec3::Y);
    for i in 0..42 {
        stage.material(materials[i % materials.len()]);
        let kind = Kind::ALL[i % Kind::ALL.len()];
        if kind != Kind::Plane {
            let thing = Thing::random(kind, random.near(Vector::ZERO, 3.0), 0.8, &mut random);
            stage.thing(&thing.mapped(|p| p * wide, |d| d, wide));
        }
    }
    let falloff = Falloff { constant: 1.0, linear: 0.01 / scale, quadratic: 0.001 / (scale * scale) };
    let position = vec3(6.0, 8.0, 3.0);
    let direction = try_normalize(-position).unwrap();
    for source in [
        Source::Point { position: vec3(-5.0, 9.0, 6.0) * scale, falloff },
        Source::Directional { toward: Vec3::Y },
        Source::Sphere { position: vec3(4.0, 7.0, 8.0) * scale, radius: 0.7 * scale, falloff },
        Source::Rectangle {
            position: vec3(-4.0, 8.0, -2.0) * scale,
            half: [Vec3::X * scale, Vec3::Z * (0.5 * scale)],
            soft: true,
            falloff,
        },
        Source::Spot { position: position * scale, direction, cos_bright: 0.95, cos_dark: 0.9, falloff },
    ] {
        stage.lights.push(Light { source, color: Rgb::gray(0.4), shadows: true });
    }
    stage.ambient = Rgb::gray(0.1);
    stage.colored_shadows = true;
    stage.background =
        Background::Gradient { up: Vec3::Y, below: Rgb::BLACK, above: Rgb::new(0.2, 0.4, 0.9) };

    let size = Resolution::new(32, 24).unwrap();
    let view = View {
        from: vec3(1.0, 2.0, 11.0) * scale,
        at: vec3(0.1, -0.2, 0.0) * scale,
        up: Vec3::Y,
        projection: if has_lens {
            Projection::Lens { angle: 0.8, radius: 0.2 * scale, focus: 9.0 * scale }
        } else {
            Projection::Perspective { angle: 0.8 }
        },
    };
    let camera = Camera::new(&view, size).unwrap();
    let world = World::new(stage.scene(), List::without_bounds(stage.item_count()));
    let limits = Limits { levels: 6, cutoff: 0.0 };
    let tracer = Tracer::<_, AllEffects, 6>::new(&world, camera, limits).unwrap();
    let tile = Tile::whole(size);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Frame::new(tile, &mut colors).unwrap();
    let Ok(()) =
        render(&mut tracer.with_worker(&mut Worker::new(())), &mut Single, tile.pixels(), &mut frame);
    colors.iter().map(|color| [color.r, color.g, color.b].map(f32::to_bits)).collect()
}

#[test]
fn a_scene_of_any_size_gives_the_same_picture_bit_for_bit() {
    let truths = [false, true].map(|has_lens| picture(1.0, has_lens));
    for truth in &truths {
        let colors: std::collections::BTreeSet<_> = truth.iter().collect();
        assert!(colors.len() > 500, "only {} colours", colors.len());
    }
    assert!(truths[0] != truths[1]);
    for k in -20..=20 {
        // Both with and without a lens, in turn.
        let has_lens = k % 2 == 0;
        assert!(picture(power_of_two(k), has_lens) == truths[usize::from(has_lens)], "2^{k}");
    }
}

/// Things of every kind and hard ones, and rays at them.
fn scenes(random: &mut Random) -> Vec<(Thing, Vec<Line>)> {
    let mut scenes = Vec::new();
    for kind in Kind::ALL {
        for _ in 0..20 {
            let place = random.near(Vector::ZERO, 5.0);
            let thing = Thing::random(kind, place, random.scale(0.1, 3.0), random);
            let line = |random: &mut Random| {
                let (eye, target) = (random.near(place, 12.0), random.near(place, 3.0));
                let speed = random.scale(0.1, 10.0);
                let way = (target - eye) * speed;
                Line {
                    origin: eye,
                    direction: vector(way.x as f32 as f64, way.y as f32 as f64, way.z as f32 as f64),
                }
            };
            scenes.push((thing, (0..30).map(|_| line(random)).collect()));
        }
    }
    // Distances of directions 1e-30 long leave the range by themselves.
    let hard = cases().into_iter().filter(|case| !case.name.contains("1e-30"));
    scenes.extend(hard.flat_map(|case| case.aims(10)));
    scenes
}

#[test]
fn distances_grow_with_the_scene_bit_for_bit() {
    let mut random = Random::new(SEED + 1);
    let mut hits = 0;
    for (thing, lines) in scenes(&mut random) {
        let truth = Stage::with(std::slice::from_ref(&thing)).cast(&lines);
        for k in [-20, -7, -1, 1, 13, 20] {
            let scale = f64::from(power_of_two(k));
            let larger = thing.mapped(|p| p * scale, |d| d, scale);
            let rays: Vec<Line> =
                lines.iter().map(|line| Line { origin: line.origin * scale, ..*line }).collect();
            let answers = Stage::with(&[larger]).cast(&rays);
            for ((line, truth), answer) in lines.iter().zip(&truth).zip(answers) {
                let grown = |found: &Found| Found {
                    t: found.t * scale,
                    point: found.point * scale,
                    error: found.error * scale,
                    ..*found
                };
                assert_eq!(answer, truth.as_ref().map(grown), "2^{k}: {thing:?}\n{line:?}");
                hits += usize::from(answer.is_some());
            }
        }
    }
    assert!(hits > 20_000, "{hits}");
}

/// Whether the normal goes round the corners, so that a mirror turns it over.
fn is_handed(thing: &Thing) -> bool {
    matches!(
        thing,
        Thing::Triangle { .. }
            | Thing::SmoothTriangle { .. }
            | Thing::Polygon { .. }
            | Thing::SmoothPolygon { .. }
    )
}

#[test]
fn a_mirrored_scene_has_the_mirrored_hits_bit_for_bit() {
    let mut random = Random::new(SEED + 2);
    let mut hits = 0;
    for (thing, lines) in scenes(&mut random) {
        let truth = Stage::with(std::slice::from_ref(&thing)).cast(&lines);
        for sides in [vector(-1.0, 1.0, 1.0), vector(1.0, -1.0, 1.0), vector(1.0, 1.0, -1.0)] {
            let mirrored = |v: Vector| v * sides;
            let other = thing.mapped(mirrored, mirrored, 1.0);
            let rays: Vec<Line> = lines
                .iter()
                .map(|line| Line { origin: mirrored(line.origin), direction: mirrored(line.direction) })
                .collect();
            let answers = Stage::with(&[other]).cast(&rays);
            for ((line, truth), answer) in lines.iter().zip(&truth).zip(answers) {
                // An edge of a polygon holds its lower end and not its upper one.
                let may_differ = matches!(thing, Thing::Polygon { .. } | Thing::SmoothPolygon { .. })
                    && matches!(meet(&thing, line), Truth::Unclear);
                if may_differ {
                    continue;
                }
                let over = if is_handed(&thing) { -1.0 } else { 1.0 };
                let seen = |found: &Found| {
                    (found.t, mirrored(found.point), mirrored(found.normal) * over, found.error)
                };
                let got = answer.map(|found| (found.t, found.point, found.normal, found.error));
                assert_eq!(got, truth.as_ref().map(seen), "{sides:?}: {thing:?}\n{line:?}");
                hits += usize::from(answer.is_some());
            }
        }
    }
    assert!(hits > 10_000, "{hits}");
}

#[test]
fn a_scene_with_its_axes_in_another_order_has_the_same_hits_but_for_rounding() {
    // Sums of three products round in the order of the axes. What has none is the same to the last
    // bit: triangles, whose test looks along one axis, and upright boxes.
    let mut random = Random::new(SEED + 3);
    let mut hits = 0;
    for (thing, lines) in scenes(&mut random) {
        let is_exact =
            matches!(thing, Thing::Triangle { .. } | Thing::SmoothTriangle { .. } | Thing::Cuboid { .. });
        let truth = Stage::with(std::slice::from_ref(&thing)).cast(&lines);
        for turns in [1, 2] {
            let turned = |v: Vector| if turns == 1 { vector(v.y, v.z, v.x) } else { vector(v.z, v.x, v.y) };
            let other = thing.mapped(turned, turned, 1.0);
            let rays: Vec<Line> = lines
                .iter()
                .map(|line| Line { origin: turned(line.origin), direction: turned(line.direction) })
                .collect();
            for ((line, truth), answer) in lines.iter().zip(&truth).zip(Stage::with(&[other]).cast(&rays)) {
                let about = || format!("{thing:?}\n{line:?}\n{truth:?}\n{answer:?}");
                let t = |found: &Found| found.t;
                if is_exact {
                    assert_eq!(answer.as_ref().map(t), truth.as_ref().map(t), "{}", about());
                } else if let Truth::Hit(contact) = meet(&thing, line) {
                    let (Some(one), Some(other)) = (truth, answer) else { panic!("{}", about()) };
                    // Each is within 4 units in the last place (8 for cones and tori) of the truth.
                    let conditioning = size(&thing, line) / contact.slope + contact.way;
                    let speed = line.direction.dot(line.direction).sqrt();
                    let off = (one.t - other.t).abs() * speed;
                    assert!(off <= 8.0 * f64::from(f32::EPSILON) * conditioning, "{}", about());
                }
                hits += usize::from(answer.is_some());
            }
        }
    }
    assert!(hits > 5_000, "{hits}");
}
