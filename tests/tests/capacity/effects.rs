//! Effects: what a tracer was not built for it refuses, and what a scene does not call for
//! costs no ray.

use crate::*;

/// Tracers that can do everything but one thing.
macro_rules! everything_but {
    ($($Name:ident { $($part:tt)* })*) => { $(
        struct $Name;

        impl Effects for $Name {
            const SET: EffectSet = EffectSet { $($part)*, ..EffectSet::ALL };
        }
    )* };
}

everything_but! {
    Spheres { shapes: ShapeSet::of(&[ShapeKind::Sphere]) }
    Flat { smooth: false }
    PointLights { lights: LightSet::of(&[LightKind::Point]) }
    Checkers { textures: TextureSet::of(&[TextureKind::Checker]) }
    Dull { highlight: false }
    Shadowless { shadows: false }
    Mirrorless { reflection: false }
    Opaque { transmission: false }
    Clear { absorption: false }
}

#[test]
fn a_tracer_refuses_a_scene_that_asks_for_what_it_cannot_do() {
    fn refuses<E: Effects>(ask: impl Fn(&mut Stage, Material, Light)) {
        let light = |color| Light { source: Source::Directional { toward: Vec3::Y }, color, shadows: false };
        let mut stage = Stage::new();
        stage.sphere(Vec3::ZERO, 1.0);
        let camera = Camera::new(&VIEW, size(2, 2)).unwrap();
        let is_refused = |stage: &Stage| {
            let world = World::new(stage.scene(), List::bare(stage.len()));
            match Tracer::<_, E, 5>::new(&world, camera, Limits::DEFAULT) {
                Ok(_) => false,
                Err(error) => {
                    assert_eq!(error, TracerError::NotBuiltFor { asks: stage.scene().effects() });
                    true
                }
            }
        };
        assert!(!is_refused(&stage), "{:?}", E::SET);
        ask(&mut stage, Material::MATTE, light(Rgb::WHITE));
        assert!(is_refused(&stage), "{:?}", E::SET);
    }
    let ball = |stage: &mut Stage, material| {
        stage.material(material);
        stage.sphere(Vec3::ZERO, 1.0);
    };
    let glass = |material| Material { transmitted: Rgb::WHITE, ..material };
    refuses::<Spheres>(|stage, _, _| {
        stage.disc(Vec3::ZERO, Vec3::Y, 1.0);
    });
    refuses::<Flat>(|stage, _, _| {
        stage.smooth_triangle([Vec3::X, Vec3::Y, Vec3::Z], [Vec3::ONE; 3]);
    });
    refuses::<Flat>(|stage, _, _| {
        stage.polygon(&[Vec3::X, Vec3::Y, Vec3::Z], &[Vec3::ONE; 3]);
    });
    refuses::<PointLights>(|stage, _, light| stage.lights.push(light));
    refuses::<Checkers>(|stage, material, _| {
        let (from, to) = (Rgb::BLACK, Rgb::WHITE);
        let texture = stage.texture(Texture::Gradient { from, to, origin: Vec3::ZERO, along: Vec3::X });
        ball(stage, Material { texture, ..material });
    });
    refuses::<Dull>(|stage, material, light| {
        stage.lights.push(light);
        ball(stage, Material { highlight: Rgb::WHITE, exponent: 2.0, ..material });
    });
    refuses::<Shadowless>(|stage, _, light| stage.lights.push(Light { shadows: true, ..light }));
    refuses::<Mirrorless>(|stage, material, _| ball(stage, Material { mirror: Rgb::gray(0.01), ..material }));
    refuses::<Opaque>(|stage, material, _| ball(stage, glass(material)));
    refuses::<Clear>(|stage, material, _| {
        ball(stage, Material { clarity: Rgb::new(Real::INFINITY, 2.0, 1.0), ..glass(material) });
    });
}

/// Just what [`local`] asks for.
struct Local;

impl Effects for Local {
    const SET: EffectSet = EffectSet {
        shapes: ShapeSet::of(&[ShapeKind::Sphere, ShapeKind::Plane]),
        lights: LightSet::of(&[LightKind::Point]),
        ..EffectSet::NONE
    };
}

/// Balls on a floor, lit from one place without shadows.
fn local() -> Stage {
    let mut stage = Stage::new();
    stage.material(Material { ambient: Rgb::gray(0.5), ..Material::MATTE });
    stage.plane(vec3(0.0, -1.0, 0.0), Vec3::Y);
    for x in -2..3 {
        stage.sphere(vec3(x as Real, -0.5, 0.0), 0.5);
    }
    let source = Source::Point { position: vec3(3.0, 5.0, 4.0), falloff: Falloff::NONE };
    stage.lights.push(Light { source, color: Rgb::new(0.9, 0.8, 0.7), shadows: false });
    stage.ambient = Rgb::gray(0.2);
    stage
}

#[test]
fn the_smallest_tracer_and_the_one_that_can_everything_give_the_same_picture() {
    let stage = local();
    assert_eq!(stage.scene().effects(), Local::SET);
    let world = World::new(stage.scene(), List::bare(stage.len()));
    let (small, counters) =
        picture::<_, Local, 1>(&world, size(48, 32), Limits { levels: 1, cutoff: 0.0 }, &mut Single);
    let (all, same) =
        picture::<_, Everything, 64>(&world, size(48, 32), Limits { levels: 64, cutoff: 0.0 }, &mut Single);
    assert_eq!(small, all);
    assert_eq!(counters, same);
    assert!(small.iter().any(|color| color.largest() > 0.5));
}

#[test]
fn no_ray_is_sent_for_what_the_scene_does_not_call_for() {
    let rays = |stage: &Stage| {
        let world = World::new(stage.scene(), List::bare(stage.len()));
        let (_, counters) = picture::<_, Everything, 5>(&world, size(24, 16), Limits::DEFAULT, &mut Single);
        assert_eq!(counters.rays(RayKind::Camera), 24 * 16);
        RayKind::ALL.map(|kind| {
            let rays = counters.rays(kind);
            assert_eq!(counters.shapes(kind) > 0, rays > 0);
            rays > 0
        })
    };
    let stage = local();
    assert_eq!(rays(&stage), [true, false, false, false]);
    let mut with_shadows = stage.clone();
    with_shadows.lights[0].shadows = true;
    assert_eq!(rays(&with_shadows), [true, false, false, true]);
    // A light that is off is not asked for.
    with_shadows.lights[0].color = Rgb::BLACK;
    assert_eq!(rays(&with_shadows), [true, false, false, false]);
}
