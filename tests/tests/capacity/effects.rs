//! Effects: a tracer refuses a scene that requires more than its effect set, and an effect that a scene does
//! not use costs no ray.

use crate::*;

/// Effect sets with one effect left out.
macro_rules! everything_but {
    ($($Name:ident { $($part:tt)* })*) => { $(
        struct $Name;

        impl Effects for $Name {
            const SET: EffectSet = EffectSet { $($part)*, ..EffectSet::ALL };
        }
    )* };
}

everything_but! {
    Spheres { shapes: ShapeKindSet::of(&[ShapeKind::Sphere]) }
    Flat { smooth_shading: false }
    PointLights { lights: LightKindSet::of(&[LightKind::Point]) }
    Checkers { textures: TextureKindSet::of(&[TextureKind::Checker]) }
    Dull { highlight: false }
    Shadowless { shadows: false }
    Mirrorless { reflection: false }
    Opaque { transmission: false }
    Clear { absorption: false }
    Uncolored { colored_shadows: false }
    Hard { soft_shadows: false }
    Pinhole { depth_of_field: false }
    Polished { gloss: false }
    Standing { motion_blur: false }
}

/// An effect, a function that removes it from a scene, and one that renders without it.
type DisableEffect =
    (&'static str, fn(&mut TestScene, &mut CameraDescriptor), fn(&TestScene, &CameraDescriptor) -> Vec<Rgb>);

/// A scene that requires every effect.
fn all_effects() -> (TestScene, CameraDescriptor) {
    let mut scene = mixed_scene();
    scene.material(Material {
        reflection: Rgb::gray(0.4),
        roughness: 0.4,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    });
    let moving = scene.sphere(vec3(2.0, 2.0, 2.0), 0.7);
    scene.set_motion(moving, -Vec3::X, Vec3::Y);
    let falloff = Falloff::NONE;
    let half = [Vec3::X, Vec3::Z];
    for source in [
        LightSource::Sphere { position: vec3(4.0, 7.0, 3.0), radius: 1.0, falloff },
        LightSource::Rectangle {
            position: vec3(-1.0, 6.0, 1.0),
            half_edges: half,
            soft_shadows: true,
            falloff,
        },
    ] {
        scene.lights.push(Light { source, color: Rgb::gray(0.3), casts_shadows: true });
    }
    scene.colored_shadows = true;
    let projection = Projection::ThinLens { field_of_view: 0.9, lens_radius: 0.1, focus_distance: 8.0 };
    (scene, CameraDescriptor { projection, ..VIEW })
}

fn rendered<E: Effects>(scene: &TestScene, view: &CameraDescriptor) -> Vec<Rgb> {
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let size = size(24, 16);
    let camera = Camera::new(view, size).unwrap();
    let tracer = Tracer::<_, E, 5>::new(&world, camera, Limits::DEFAULT).unwrap();
    let tile = Tile::full(size);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Framebuffer::new(tile, &mut colors).unwrap();
    let mut sampler = StochasticSampler::new(4).unwrap();
    let Ok(()) =
        render(&mut tracer.with_worker(&mut Worker::new(())), &mut sampler, tile.pixels(), &mut frame);
    colors
}

#[test]
fn a_tracer_without_an_effect_gives_the_same_picture_of_a_scene_that_does_not_use_it() {
    fn each_material(scene: &mut TestScene, change: impl Fn(&mut Material)) {
        scene.materials_mut().iter_mut().for_each(change);
    }
    let all: [DisableEffect; 9] = [
        (
            "shadows",
            |scene, _| scene.lights.iter_mut().for_each(|l| l.casts_shadows = false),
            rendered::<Shadowless>,
        ),
        (
            "reflection",
            |scene, _| each_material(scene, |m| m.reflection = Rgb::BLACK),
            rendered::<Mirrorless>,
        ),
        (
            "transmission",
            |scene, _| each_material(scene, |m| m.transmission = Rgb::BLACK),
            rendered::<Opaque>,
        ),
        (
            "absorption",
            |scene, _| each_material(scene, |m| m.attenuation_length = Material::MATTE.attenuation_length),
            rendered::<Clear>,
        ),
        ("colored shadows", |scene, _| scene.colored_shadows = false, rendered::<Uncolored>),
        ("penumbra", |scene, _| scene.lights.retain(|light| !light.has_soft_shadows()), rendered::<Hard>),
        ("lens", |_, view| view.projection = VIEW.projection, rendered::<Pinhole>),
        ("gloss", |scene, _| each_material(scene, |m| m.roughness = 0.0), rendered::<Polished>),
        ("motion", |scene, _| scene.clear_motions(), rendered::<Standing>),
    ];
    let (scene, view) = all_effects();
    let with = rendered::<AllEffects>(&scene, &view);
    for (effect, remove, without) in all {
        let (mut scene, mut view) = (scene.clone(), view);
        remove(&mut scene, &mut view);
        let picture = without(&scene, &view);
        assert_eq!(picture, rendered::<AllEffects>(&scene, &view), "without {effect}");
        assert_ne!(picture, with, "{effect} is visible");
    }
}

#[test]
fn a_tracer_refuses_a_scene_that_requires_an_effect_it_lacks() {
    fn refuses<E: Effects>(require: impl Fn(&mut TestScene, Material, Light)) {
        let light = |color| Light {
            source: LightSource::Directional { to_light: Vec3::Y },
            color,
            casts_shadows: false,
        };
        let mut scene = TestScene::new();
        scene.sphere(Vec3::ZERO, 1.0);
        let camera = Camera::new(&VIEW, size(2, 2)).unwrap();
        let is_refused = |scene: &TestScene| {
            let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
            match Tracer::<_, E, 5>::new(&world, camera, Limits::DEFAULT) {
                Ok(_) => false,
                Err(error) => {
                    let missing = scene.as_scene().required_effects().difference(&E::SET);
                    assert_eq!(error, TracerError::MissingEffects { missing });
                    true
                }
            }
        };
        assert!(!is_refused(&scene), "{:?}", E::SET);
        require(&mut scene, Material::matte(Rgb::WHITE), light(Rgb::WHITE));
        assert!(is_refused(&scene), "{:?}", E::SET);
    }
    let sphere = |scene: &mut TestScene, material| {
        scene.material(material);
        scene.sphere(Vec3::ZERO, 1.0);
    };
    let glass = |material| Material { transmission: Rgb::WHITE, ..material };
    refuses::<Spheres>(|scene, _, _| {
        scene.disc(Vec3::ZERO, Vec3::Y, 1.0);
    });
    refuses::<Flat>(|scene, _, _| {
        scene.smooth_triangle([Vec3::X, Vec3::Y, Vec3::Z], [Vec3::ONE; 3]);
    });
    refuses::<Flat>(|scene, _, _| {
        scene.polygon(&[Vec3::X, Vec3::Y, Vec3::Z], &[Vec3::ONE; 3]);
    });
    refuses::<PointLights>(|scene, _, light| scene.lights.push(light));
    refuses::<Checkers>(|scene, material, _| {
        let (from, to) = (Rgb::BLACK, Rgb::WHITE);
        let texture = scene.add_texture(Texture::Gradient {
            start_color: from,
            end_color: to,
            origin: Vec3::ZERO,
            axis: Vec3::X,
        });
        sphere(scene, Material { texture, ..material });
    });
    refuses::<Dull>(|scene, material, light| {
        scene.lights.push(light);
        sphere(scene, Material { highlight: Rgb::WHITE, highlight_exponent: 2.0, ..material });
    });
    refuses::<Shadowless>(|scene, _, light| scene.lights.push(Light { casts_shadows: true, ..light }));
    refuses::<Mirrorless>(|scene, material, _| {
        sphere(scene, Material { reflection: Rgb::gray(0.01), ..material })
    });
    refuses::<Opaque>(|scene, material, _| sphere(scene, glass(material)));
    refuses::<Hard>(|scene, _, light| {
        let falloff = Falloff::NONE;
        let source = LightSource::Sphere { position: Vec3::Y, radius: 1.0, falloff };
        scene.lights.push(Light { source, ..light });
    });
    refuses::<Polished>(|scene, material, _| {
        sphere(scene, Material { reflection: Rgb::WHITE, roughness: 0.1, ..material });
    });
    refuses::<Standing>(|scene, _, _| scene.set_motion(ItemId(0), Vec3::ZERO, Vec3::X));
    refuses::<Uncolored>(|scene, material, light| {
        sphere(scene, glass(material));
        scene.lights.push(Light { casts_shadows: true, ..light });
        scene.colored_shadows = true;
    });
    refuses::<Clear>(|scene, material, _| {
        sphere(scene, Material { attenuation_length: Rgb::new(Real::INFINITY, 2.0, 1.0), ..glass(material) });
    });
}

#[test]
fn a_tracer_without_a_lens_refuses_a_camera_that_has_one() {
    let scene = local();
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let (_, view) = all_effects();
    let camera = Camera::new(&view, size(2, 2)).unwrap();
    let refused = Tracer::<_, Pinhole, 5>::new(&world, camera, Limits::DEFAULT).err();
    assert_eq!(
        refused,
        Some(TracerError::MissingEffects { missing: EffectSet { depth_of_field: true, ..EffectSet::NONE } })
    );
    assert!(Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT).is_ok());
}

/// Exactly the effects of [`local`].
struct LocalLightEffects;

impl Effects for LocalLightEffects {
    const SET: EffectSet = EffectSet {
        shapes: ShapeKindSet::of(&[ShapeKind::Sphere, ShapeKind::Plane]),
        lights: LightKindSet::of(&[LightKind::Point]),
        ..EffectSet::NONE
    };
}

/// Spheres on a floor under a point light without shadows.
fn local() -> TestScene {
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::gray(0.5), ..Material::MATTE });
    scene.plane(vec3(0.0, -1.0, 0.0), Vec3::Y);
    for x in -2..3 {
        scene.sphere(vec3(x as Real, -0.5, 0.0), 0.5);
    }
    let source = LightSource::Point { position: vec3(3.0, 5.0, 4.0), falloff: Falloff::NONE };
    scene.lights.push(Light { source, color: Rgb::new(0.9, 0.8, 0.7), casts_shadows: false });
    scene.ambient = Rgb::gray(0.2);
    scene
}

#[test]
fn the_smallest_effect_set_and_all_effects_give_the_same_picture() {
    let scene = local();
    assert_eq!(scene.as_scene().required_effects(), LocalLightEffects::SET);
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let (small, counters) = picture::<_, LocalLightEffects, 1>(
        &world,
        size(48, 32),
        Limits { levels: 1, cutoff: 0.0 },
        &mut CenterSampler,
    );
    let (all, same) = picture::<_, AllEffects, 64>(
        &world,
        size(48, 32),
        Limits { levels: 64, cutoff: 0.0 },
        &mut CenterSampler,
    );
    assert_eq!(small, all);
    assert_eq!(counters, same);
    assert!(small.iter().any(|color| color.max_component() > 0.5));
}

#[test]
fn no_ray_is_traced_for_effects_that_the_scene_does_not_use() {
    let rays = |scene: &TestScene| {
        let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
        let (_, counters) =
            picture::<_, AllEffects, 5>(&world, size(24, 16), Limits::DEFAULT, &mut CenterSampler);
        assert_eq!(counters.rays[RayKind::Camera], 24 * 16);
        RayKind::ALL.map(|kind| {
            let rays = counters.rays[kind];
            assert_eq!(counters.shape_tests[kind] > 0, rays > 0);
            rays > 0
        })
    };
    let scene = local();
    assert_eq!(rays(&scene), [true, false, false, false]);
    let mut with_shadows = scene.clone();
    with_shadows.lights[0].casts_shadows = true;
    assert_eq!(rays(&with_shadows), [true, false, false, true]);
    // A black light costs no shadow ray.
    with_shadows.lights[0].color = Rgb::BLACK;
    assert_eq!(rays(&with_shadows), [true, false, false, false]);
}
