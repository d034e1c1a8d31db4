//! Every pixel is finite, and an invalid ray hits nothing.

use proptest::collection::vec;
use proptest::prelude::*;
use strahl_core::accel::List;
use strahl_core::geometry::Ray;
use strahl_core::image::{
    AdaptiveSampler, CacheEntry, Confidence, ContrastThreshold, Filter, Framebuffer, PixelSelection,
    PixelSelector, RegularSampler, StochasticSampler, Subdivision, UncachedCorners,
};
use strahl_core::math::try_normalize;
use strahl_core::render::render_selected;
use strahl_core::scene::{FresnelModel, Texture};
use strahl_core::tally::RayKind;
use strahl_core::{
    AllEffects, Background, Camera, CameraDescriptor, CenterSampler, Falloff, Light, LightSource, Limits,
    Material, Projection, Real, Resolution, Rgb, Tile, Tracer, Vec3, Worker, World, render, vec3,
};
use strahl_test_scene::{DVec3, SplitMix64, TestScene, TestShape, TestShapeKind};

/// A number from a list of ordinary and extreme ones.
fn one_of(values: &'static [f32]) -> impl Strategy<Value = f32> {
    prop::sample::select(values)
}

fn color(values: &'static [f32]) -> impl Strategy<Value = Rgb> {
    (one_of(values), one_of(values), one_of(values)).prop_map(|(r, g, b)| Rgb::new(r, g, b))
}

const BRIGHT: &[f32] = &[0.0, 1e-30, 0.5, 1.0, 1e6];
const FACTOR: &[f32] = &[0.0, 1e-30, 0.5, 0.999_999_9, 1.0];

prop_compose! {
    fn material(scale: f32)(
        (ambient, diffuse, highlight) in (color(BRIGHT), color(BRIGHT), color(BRIGHT)),
        (reflection, transmission) in (color(FACTOR), color(FACTOR)),
        highlight_exponent in one_of(&[0.0, 1e-6, 1.0, 30.0, 1e6]),
        refractive_index in one_of(&[0.01, 0.75, 1.0, 1.000_000_1, 1.5, 100.0]),
        length in one_of(&[1e-20, 1e-3, 1.0, 1e15, f32::INFINITY]),
        fresnel in prop::sample::select(vec![FresnelModel::None, FresnelModel::Dielectric]),
        (two_sided, priority, roughness) in (any::<bool>(), 0_u8..3, one_of(&[0.0, 0.0, 1e-6, 0.3, 1.0])),
    ) -> Material {
        let attenuation_length = Rgb::new(length * scale, f32::INFINITY, scale);
        Material {
            ambient, diffuse, highlight, reflection, transmission, highlight_exponent, refractive_index, attenuation_length, fresnel, two_sided,
            priority, roughness, ..Material::MATTE
        }
    }
}

/// A point in a scene of size one, rarely with coordinates 0 or -1.
fn point() -> impl Strategy<Value = Vec3> {
    let coordinate = || prop_oneof![8 => -2.0_f32..2.0, 1 => Just(0.0), 1 => Just(-1.0)];
    (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| vec3(x, y, z))
}

fn direction() -> impl Strategy<Value = Vec3> {
    let axes = prop::sample::select(vec![Vec3::X, Vec3::Y, -Vec3::Z]);
    prop_oneof![point().prop_map(|v| try_normalize(v).unwrap_or(Vec3::Y)), axes]
}

prop_compose! {
    fn light(scale: f32)(
        position in point(), direction in direction(), color in color(BRIGHT), kind in 0..6, casts_shadows in any::<bool>(),
        (constant, linear, quadratic) in (one_of(&[0.0, 1.0, 1e6]), one_of(&[0.0, 1.0]), one_of(&[0.0, 1e-6, 1.0])),
        (cos, extent) in (one_of(&[-1.0, 0.0, 0.9, 1.0]), one_of(&[1e-6, 0.1, 1.0, 100.0])),
    ) -> Light {
        let constant = if constant + linear + quadratic > 0.0 { constant } else { 1.0 };
        let falloff = Falloff { constant, linear: linear / scale, quadratic: quadratic / scale / scale };
        let position = position * scale;
        let source = match kind {
            0 => LightSource::Point { position, falloff },
            1 => LightSource::Directional { to_light: direction },
            2 => LightSource::Sphere { position, radius: 0.0, falloff },
            3 => LightSource::Sphere { position, radius: extent * scale, falloff },
            4 => {
                let side = try_normalize(direction.cross(vec3(0.3, 0.5, 0.8))).unwrap();
                let half_edges = [side, direction.cross(side)].map(|side| side * (extent * scale));
                LightSource::Rectangle { position, half_edges, soft_shadows: casts_shadows, falloff }
            }
            _ => LightSource::Spot { position, direction, cos_inner: cos, cos_outer: -1.0, falloff },
        };
        Light { source, color, casts_shadows }
    }
}

prop_compose! {
    fn view(scale: f32)(
        (position, target) in (point(), point()), up in direction(), kind in 0..3,
        field_of_view in one_of(&[1e-6, 0.8, 3.0, 0.999_999 * std::f32::consts::PI]), height in one_of(&[1e-6, 1.0, 1e6]),
    ) -> CameraDescriptor {
        let projection = match kind {
            0 => Projection::Orthographic { height: height * scale },
            1 => Projection::ThinLens { field_of_view, lens_radius: 0.1 * height * scale, focus_distance: scale },
            _ => Projection::Perspective { field_of_view },
        };
        CameraDescriptor { position: position * scale, target: target * scale, up, projection }
    }
}

fn texture(scale: f32) -> impl Strategy<Value = Texture> {
    let colors = (color(BRIGHT), color(BRIGHT));
    (colors, point(), direction(), 0..3, one_of(&[0.0, 1e-3, 3.0, 1e4])).prop_map(
        move |((from, to), origin, along, kind, frequency)| {
            let origin = origin * scale;
            match kind {
                0 => Texture::Checker {
                    even: from,
                    odd: to,
                    origin,
                    frequency: Vec3::splat(frequency / scale),
                },
                1 => Texture::Gradient { start_color: from, end_color: to, origin, axis: along * scale },
                _ => {
                    let frequency = frequency / scale / scale;
                    let frequency = if frequency < 1e15 { frequency } else { 1e15 };
                    Texture::ZonePlate { start_color: from, end_color: to, origin, frequency }
                }
            }
        },
    )
}

/// A scene and its camera.
#[derive(Clone, Debug)]
struct RandomScene {
    scale: f32,
    shapes: Vec<(usize, u64, usize)>,
    materials: Vec<Material>,
    lights: Vec<Light>,
    ambient: Rgb,
    view: CameraDescriptor,
    texture: Texture,
    colored_shadows: bool,
}

fn random_scene() -> impl Strategy<Value = RandomScene> {
    (-20..=20_i32).prop_flat_map(|k| {
        let scale = (0..k.abs()).fold(1.0, |x, _| if k < 0 { x * 0.5 } else { x * 2.0 });
        (
            Just(scale),
            vec((0..TestShapeKind::ALL.len(), any::<u64>(), 0..3_usize), 1..8),
            vec(material(scale), 3),
            vec(light(scale), 0..3),
            color(BRIGHT),
            view(scale),
            texture(scale),
            any::<bool>(),
        )
            .prop_map(
                |(scale, shapes, materials, lights, ambient, view, texture, colored_shadows)| RandomScene {
                    scale,
                    shapes,
                    materials,
                    lights,
                    ambient,
                    view,
                    texture,
                    colored_shadows,
                },
            )
    })
}

fn built(random_scene: &RandomScene) -> TestScene {
    let mut scene = TestScene::new();
    let scale = f64::from(random_scene.scale);
    let texture = scene.add_texture(random_scene.texture);
    for (kind, seed, material) in &random_scene.shapes {
        let material = random_scene.materials[*material];
        scene.material(if seed % 4 == 0 { Material { texture, ..material } } else { material });
        let mut rng = SplitMix64::new(*seed);
        let center = rng.in_ball(DVec3::ZERO, 1.5);
        let size = rng.log_between(1e-3, 2.0);
        let shape = TestShape::random(TestShapeKind::ALL[*kind], center, size, &mut rng);
        scene.add_shape(&shape.mapped(|p| p * scale, |d| d, scale));
    }
    scene.lights.clone_from(&random_scene.lights);
    scene.ambient = random_scene.ambient;
    scene.colored_shadows = random_scene.colored_shadows;
    scene.background = Background::Gradient { up: Vec3::Y, below: Rgb::gray(1e6), above: Rgb::BLACK };
    scene
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_channel_of_every_pixel_is_finite(
        random_scene in random_scene(), width in 1_u32..6, height in 1_u32..5, sampler in 0..5,
    ) {
        let scene = built(&random_scene);
        let size = Resolution::new(width, height).unwrap();
        // A camera without a picture is refused.
        let Ok(camera) = Camera::new(&random_scene.view, size) else { return Ok(()) };
        let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
        let limits = Limits { levels: 6, cutoff: 0.0 };
        let tracer = Tracer::<_, AllEffects, 6>::new(&world, camera, limits).unwrap();
        let tile = Tile::full(size);
        let mut colors = vec![Rgb::BLACK; tile.len()];
        let mut frame = Framebuffer::new(tile, &mut colors).unwrap();
        let mut worker = Worker::new(());
        let contrast = ContrastThreshold::new(0.05).unwrap();
        let mut cache = [CacheEntry::EMPTY; 8];
        let Ok(()) = match sampler {
            0 => render(&mut tracer.with_worker(&mut worker), &mut CenterSampler, tile.pixels(), &mut frame),
            1 => {
                let mut regular = RegularSampler::new(2).unwrap().with_filter(Filter::Gaussian);
                render(&mut tracer.with_worker(&mut worker), &mut regular, tile.pixels(), &mut frame)
            }
            2 => {
                let subdivision = Subdivision::new(2, contrast).unwrap();
                let mut adaptive = AdaptiveSampler::new(subdivision, UncachedCorners, &mut cache);
                render(&mut tracer.with_worker(&mut worker), &mut adaptive, tile.pixels(), &mut frame)
            }
            3 => {
                let ends = Confidence { standard_errors: 2.0, tolerance: 0.02 };
                let mut stochastic = StochasticSampler::with_range(4, 8, ends).unwrap();
                render(&mut tracer.with_worker(&mut worker), &mut stochastic, tile.pixels(), &mut frame)
            }
            _ => {
                let selection = PixelSelection::new(2, contrast).unwrap();
                let block_corners = selection.block_range(tile).pixels();
                let mut selected = PixelSelector::new(selection, CenterSampler, UncachedCorners, &mut cache);
                render_selected(&mut tracer.with_worker(&mut worker), &mut selected, block_corners, &mut frame)
            }
        };
        for color in colors {
            prop_assert!(color.is_in_range(Real::MAX), "{color:?}");
        }
    }

    #[test]
    fn every_number_of_a_hit_is_finite(
        random_scene in random_scene(), origin in point(), direction in point(), length in -30..30_i32,
    ) {
        let scene = built(&random_scene);
        let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
        let scale = (0..length.abs()).fold(1.0, |x, _| if length < 0 { x * 0.1 } else { x * 10.0 });
        let ray = Ray::new(origin * random_scene.scale, direction * scale);
        let hit = world.nearest_hit::<AllEffects, _>(&ray, Real::MAX, RayKind::Camera, &mut (), &mut ());
        if let Some(hit) = hit {
            prop_assert!(hit.t > 0.0 && hit.t <= Real::MAX);
            let surface = world.surface_interaction::<AllEffects>(&ray, hit);
            let surface = surface.expect("a hit has a surface");
            prop_assert!(surface.point.is_finite() && surface.point_error.is_finite(), "{surface:?}");
            for normal in [surface.normal, surface.shading_normal] {
                prop_assert!((normal.dot(normal) - 1.0).abs() <= 2e-6, "{surface:?}");
            }
        }
    }
}

#[test]
fn an_invalid_ray_hits_nothing_and_tests_nothing() {
    use strahl_core::accel::{
        Bvh, BvhEntry, BvhNode, BvhSize, Grid, GridSize, Octree, OctreeNode, OctreeSize, TraversalStack,
    };
    use strahl_core::tally::Counters;

    let mut rng = SplitMix64::new(0x5eed_0009);
    let mut scene = TestScene::new();
    for kind in TestShapeKind::ALL {
        scene.add_shape(&TestShape::random(kind, rng.in_ball(DVec3::ZERO, 2.0), 1.5, &mut rng));
    }
    let boxes = scene.bounds();
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let mut rays = vec![Ray::new(Vec3::ZERO, Vec3::ZERO), Ray::new(Vec3::ONE, vec3(0.0, -0.0, 0.0))];
    rays.push(Ray::new(Vec3::ZERO, vec3(1e-40, 0.0, 0.0)));
    for x in bad {
        for axis in 0..3 {
            let (mut origin, mut direction) = (vec3(0.1, 0.2, 3.0), vec3(0.1, 0.2, -1.0));
            origin[axis] = x;
            rays.push(Ray::new(origin, direction));
            direction[axis] = x;
            rays.push(Ray::new(vec3(0.1, 0.2, 3.0), direction));
            rays.push(Ray::new(origin, direction));
        }
    }

    macro_rules! assert_no_hit {
        ($accelerator:expr) => {
            let world = World::new(scene.as_scene(), $accelerator);
            let mut scratch = Default::default();
            let mut tally = Counters::new();
            for ray in &rays {
                for t_max in [1.0, Real::MAX, Real::INFINITY, Real::NAN, -1.0] {
                    let hit = world.nearest_hit::<AllEffects, _>(
                        ray,
                        t_max,
                        RayKind::Camera,
                        &mut scratch,
                        &mut tally,
                    );
                    assert_eq!(hit, None, "{ray:?}");
                    let occluder = world.occluder::<AllEffects, _>(
                        ray,
                        t_max,
                        RayKind::Shadow,
                        &mut scratch,
                        &mut tally,
                    );
                    assert_eq!(occluder, None, "{ray:?}");
                }
            }
            assert_eq!(tally, Counters::new(), "no box and no shape is tested");
        };
    }

    assert_no_hit!(List::without_bounds(scene.item_count()));
    let size = BvhSize::recommended(boxes.len());
    let (mut nodes, mut items) = (vec![BvhNode::EMPTY; size.nodes], vec![BvhEntry::EMPTY; size.entries]);
    assert_no_hit!(Bvh::<TraversalStack<64>>::build(&boxes, &mut nodes, &mut items).unwrap());
    let size = GridSize::recommended(&boxes);
    let (mut cells, mut items) = (vec![0; size.cells], vec![0; size.entries]);
    assert_no_hit!(Grid::<64>::build(&boxes, &mut cells, &mut items).unwrap());
    let size = OctreeSize::recommended(boxes.len());
    let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; size.nodes], vec![0; size.entries]);
    assert_no_hit!(Octree::<64>::build(&boxes, &mut nodes, &mut items).unwrap());
}
