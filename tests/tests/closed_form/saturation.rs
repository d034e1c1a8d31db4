//! Extreme values that a scene accepts: every pixel is finite.

use strahl_test_scene::{DVec3, SplitMix64, TestShape, TestShapeKind};

use crate::*;

const BRIGHTEST: Rgb = Rgb::gray(Rgb::MAX_CHANNEL);

fn glaring() -> Material {
    Material {
        ambient: BRIGHTEST,
        diffuse: BRIGHTEST,
        highlight: BRIGHTEST,
        highlight_exponent: 1.0,
        ..Material::MATTE
    }
}

#[test]
fn the_brightest_mirrors_and_glass_give_a_finite_pixel_after_64_levels() {
    // Two facing mirrors with a plate of glass between them; a light in the face of the plate, at distance
    // zero; bright textures on everything.
    let mut scene = TestScene::new();
    let texture = scene.add_texture(Texture::Checker {
        even: BRIGHTEST,
        odd: BRIGHTEST,
        origin: Vec3::ZERO,
        frequency: Vec3::ZERO,
    });
    scene.material(Material { texture, reflection: Rgb::WHITE, ..glaring() });
    scene.plane(vec3(3.0, 0.0, 0.0), Vec3::X);
    scene.plane(vec3(-2.0, 0.0, 0.0), Vec3::X);
    scene.material(Material { texture, transmission: Rgb::WHITE, refractive_index: 1.5, ..glaring() });
    scene.cuboid(vec3(1.0, -50.0, -50.0), vec3(2.0, 50.0, 50.0));
    scene.ambient = BRIGHTEST;
    scene.background = Background::Color(BRIGHTEST);
    for position in [vec3(0.5, 0.1, 0.0), vec3(1.0, 0.0, 0.0)] {
        let source = LightSource::Point {
            position,
            falloff: Falloff { constant: 0.0, linear: 0.0, quadratic: 1e-30 },
        };
        scene.lights.push(Light { source, color: BRIGHTEST, casts_shadows: false });
    }
    let (color, counters) = scene.trace_counted(Vec3::ZERO, Vec3::X, ALL);
    assert_eq!(counters.rays[RayKind::Transmitted] + counters.rays[RayKind::Reflected], 63);
    // Each of the 64 surfaces is clamped to 1e15.
    assert_gray(color, 64e15, 64.0 * 6e-8);
}

#[test]
fn a_full_tree_of_perfect_mirrors_and_panes_gives_a_finite_pixel() {
    // Every ray hits a pane that transmits and reflects all light.
    let n = 14;
    let mut scene = TestScene::new();
    scene.material(Material { reflection: Rgb::WHITE, transmission: Rgb::WHITE, ..glaring() });
    for i in 0..n {
        scene.plane(vec3(Real::from(i) + 1.0, 0.0, 0.0), Vec3::X);
        scene.plane(vec3(-Real::from(i) - 1.0, 0.0, 0.0), Vec3::X);
    }
    scene.ambient = BRIGHTEST;
    let (color, counters) = scene.trace_counted(Vec3::ZERO, Vec3::X, levels(n));
    let surfaces = (1_u64 << n) - 1;
    assert_eq!(counters.rays[RayKind::Transmitted] + counters.rays[RayKind::Reflected], surfaces - 1);
    // 1e6 times 1e6 of each; the sum rounds as often as there are surfaces.
    assert_gray(color, 1e12 * surfaces as f64, surfaces as f64 * 6e-8);
}

#[test]
fn a_light_at_the_point_that_it_lights_adds_nothing() {
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::BLACK, ..glaring() });
    scene.plane(Vec3::ZERO, Vec3::Y);
    let light = |y: Real| Light {
        source: LightSource::Point { position: vec3(0.0, y, 0.0), falloff: Falloff::INVERSE_SQUARE },
        color: BRIGHTEST,
        casts_shadows: true,
    };
    scene.lights = vec![light(0.0)];
    assert_eq!(scene.trace(Vec3::Y, Vec3::ZERO, ALL), Rgb::BLACK);
    // As near as possible: falloff and surface are clamped.
    scene.lights = vec![light(1e-30)];
    assert_gray(scene.trace(Vec3::Y, Vec3::ZERO, ALL), 1e15, ROUNDINGS);
}

/// A random element.
fn one_of<T: Copy>(numbers: &[T], rng: &mut SplitMix64) -> T {
    numbers[rng.below(numbers.len() as u32) as usize]
}

fn color(numbers: &[Real], rng: &mut SplitMix64) -> Rgb {
    Rgb::new(one_of(numbers, rng), one_of(numbers, rng), one_of(numbers, rng))
}

#[test]
fn every_accepted_scene_gives_finite_pixels() {
    let mut rng = SplitMix64::new(0x5eed_0006);
    let r = &mut rng;
    let bright = [0.0, 1e-30, 1.0, 1e6];
    let factor = [0.0, 1e-30, 0.5, 1.0];
    let mut lit = 0;
    for _ in 0..400 {
        let scale = one_of(&[1e-15, 1e-6, 1.0, 1e6, 1e14], r);
        let near = |r: &mut SplitMix64| {
            let p = r.in_ball(DVec3::ZERO, 2.0 * scale);
            vec3(p.x as Real, p.y as Real, p.z as Real)
        };
        let mut scene = TestScene::new();
        let texture = scene.add_texture(match r.below(3) {
            0 => Texture::Checker {
                even: color(&bright, r),
                odd: color(&bright, r),
                origin: vec3(1.0, 2.0, 3.0),
                frequency: Vec3::splat(one_of(&[0.0, 1e-15, 1.0, 1e15], r)),
            },
            1 => Texture::ZonePlate {
                start_color: color(&bright, r),
                end_color: color(&bright, r),
                origin: Vec3::ONE,
                frequency: one_of(&[0.0, 1e-30, 1.0, 1e15], r),
            },
            _ => Texture::Gradient {
                start_color: color(&bright, r),
                end_color: color(&bright, r),
                origin: Vec3::ZERO,
                axis: Vec3::X * one_of(&[1e-18, 1.0, 1e15], r),
            },
        });
        for _ in 0..1 + r.below(8) {
            scene.material(Material {
                roughness: one_of(&[0.0, 0.3, 1.0], r),
                ambient: color(&bright, r),
                diffuse: color(&bright, r),
                texture: one_of(&[TextureId::NONE, texture], r),
                highlight: color(&bright, r),
                highlight_exponent: one_of(&[0.0, 1e-30, 1.0, 1e6], r),
                reflection: color(&factor, r),
                transmission: color(&factor, r),
                refractive_index: one_of(&[0.01, 1.0, 1.5, 100.0], r),
                fresnel: one_of(&[FresnelModel::None, FresnelModel::Dielectric], r),
                attenuation_length: color(&[1e-30, 1.0, 1e30, Real::INFINITY], r),
                priority: r.below(3) as u8,
                two_sided: r.below(2) == 0,
            });
            let kind = one_of(&TestShapeKind::ALL, r);
            let center = r.in_ball(DVec3::ZERO, scale);
            let item = scene.add_shape(&TestShape::random(kind, center, scale, r));
            if r.below(3) == 0 {
                let far = one_of(&[1e-15, 1.0, 1e15], r);
                scene.set_motion(item, near(r) * 0.1, Vec3::X * far);
            }
        }
        for _ in 0..r.below(4) {
            let falloff = Falloff {
                constant: one_of(&[0.0, 1.0, 1e15], r),
                linear: one_of(&[0.0, 1e-30, 1e15], r),
                quadratic: one_of(&[1e-30, 1.0, 1e15], r),
            };
            let toward = try_normalize(near(r)).unwrap();
            let source = match r.below(5) {
                0 => LightSource::Point { position: near(r), falloff },
                1 => LightSource::Directional { to_light: toward },
                2 => {
                    let radius = one_of(&[0.0, 1e-30, 1.0, 1e15], r);
                    LightSource::Sphere { position: near(r), radius, falloff }
                }
                3 => {
                    let side = one_of(&[1e-3, 1.0, 1e15], r);
                    let half = [Vec3::X * side, vec3(0.0, 1.0, 1.0)];
                    LightSource::Rectangle {
                        position: near(r),
                        half_edges: half,
                        soft_shadows: r.below(4) > 0,
                        falloff,
                    }
                }
                _ => {
                    let (cos_inner, cos_outer) =
                        one_of(&[(1.0, 1.0), (1.0, -1.0), (0.5, 0.5), (-1.0, -1.0)], r);
                    LightSource::Spot { position: near(r), direction: toward, cos_inner, cos_outer, falloff }
                }
            };
            scene.lights.push(Light { source, color: color(&bright, r), casts_shadows: r.below(2) == 0 });
        }
        scene.ambient = color(&bright, r);
        scene.background = Background::Color(color(&bright, r));
        scene.colored_shadows = r.below(2) == 0;
        for _ in 0..4 {
            let (viewpoint, target) = (r.in_ball(DVec3::ZERO, 3.0 * scale), r.in_ball(DVec3::ZERO, scale));
            let [viewpoint, target] =
                [viewpoint, target].map(|p| vec3(p.x as Real, p.y as Real, p.z as Real));
            // `trace` asserts that every channel is finite and not negative.
            lit += usize::from(!scene.trace(viewpoint, target, levels(9)).is_black());
        }
    }
    assert!(lit > 400, "{lit}");
}
