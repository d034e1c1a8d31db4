//! The cost of effects that a scene does not use: a scene with local illumination only, traced with the
//! smallest effect set, and with larger ones.
//!
//! ```text
//! cargo build --release -p strahl-core --example local_light
//! valgrind --tool=callgrind target/release/examples/local_light smallest
//! valgrind --tool=callgrind target/release/examples/local_light local
//! valgrind --tool=callgrind target/release/examples/local_light everything
//! valgrind --tool=callgrind target/release/examples/local_light local-shapes
//! valgrind --tool=callgrind target/release/examples/local_light everything-shapes
//! ```
//!
//! All print the same hash of the picture; callgrind counts the instructions
//! (`tests/reports/local-light.md`).

use std::process::ExitCode;

use strahl_core::geometry::{ItemId, ShapeKind, ShapeKindSet};
use strahl_core::image::Pixel;
use strahl_core::scene::{EffectSet, Effects, LightKind, LightKindSet};
use strahl_core::{
    AllEffects, Camera, CameraDescriptor, CenterSampler, Falloff, Geometry, Light, LightSource, Limits,
    ListWithoutBounds, Material, MaterialId, Plane, Projection, Resolution, Rgb, Scene, SceneDescriptor,
    Shape, Sphere, Tile, Tracer, Vec3, Worker, World, render, vec3,
};

/// Exactly the effects that the scene requires.
struct MinimalEffects;

impl Effects for MinimalEffects {
    const SET: EffectSet = EffectSet {
        shapes: ShapeKindSet::of(&[ShapeKind::Sphere, ShapeKind::Plane]),
        lights: LightKindSet::of(&[LightKind::Point]),
        shadows: true,
        ..EffectSet::NONE
    };
}

/// All effects except secondary rays and distributed effects.
struct LocalEffects;

impl Effects for LocalEffects {
    const SET: EffectSet = EffectSet {
        reflection: false,
        transmission: false,
        absorption: false,
        colored_shadows: false,
        soft_shadows: false,
        depth_of_field: false,
        gloss: false,
        motion_blur: false,
        ..EffectSet::ALL
    };
}

/// [`LocalEffects`] with the shapes of the scene only.
struct LocalEffectsOfScene;

impl Effects for LocalEffectsOfScene {
    const SET: EffectSet = EffectSet { shapes: MinimalEffects::SET.shapes, ..LocalEffects::SET };
}

/// All effects with the shapes of the scene only.
struct AllEffectsOfScene;

impl Effects for AllEffectsOfScene {
    const SET: EffectSet = EffectSet { shapes: MinimalEffects::SET.shapes, ..EffectSet::ALL };
}

const ITEMS: usize = 26;

/// Renders the scene and returns an FNV-1a hash of the bits of its pixels.
fn hash<E: Effects>() -> u64 {
    let mut shapes = [Shape::Plane(0); ITEMS];
    for (index, shape) in shapes.iter_mut().enumerate().skip(1) {
        let (x, z) = ((index % 5) as f32 - 2.0, -((index / 5) as f32));
        *shape = Shape::Sphere(Sphere { center: vec3(x, 0.4, z), radius: 0.4 });
    }
    let floor = Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(0) };
    let planes = [floor];
    let source = LightSource::Point { position: vec3(3.0, 6.0, 4.0), falloff: Falloff::NONE };
    let lights = [Light { source, color: Rgb::gray(0.8), casts_shadows: true }];
    let scene = Scene::new(SceneDescriptor {
        geometry: Geometry { shapes: &shapes, planes: &planes, ..Geometry::EMPTY },
        material_ids: &[MaterialId(0); ITEMS],
        materials: &[Material { ambient: Rgb::WHITE, ..Material::MATTE }],
        lights: &lights,
        ambient: Rgb::gray(0.1),
        ..SceneDescriptor::EMPTY
    })
    .expect("a valid scene");
    let camera = CameraDescriptor {
        position: vec3(0.0, 3.0, 6.0),
        target: vec3(0.0, 0.0, -2.0),
        up: Vec3::Y,
        projection: Projection::Perspective { field_of_view: 0.7 },
    };
    let resolution = Resolution::new(160, 120).expect("a valid resolution");
    let world = World::new(scene, ListWithoutBounds(ITEMS as u32));
    let camera = Camera::new(&camera, resolution).expect("a valid camera");
    let tracer = Tracer::<_, E, 5>::new(&world, camera, Limits::DEFAULT).expect("all effects in the set");
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut sink = |_: Pixel, color: Rgb| {
        for channel in [color.r, color.g, color.b] {
            hash = (hash ^ u64::from(channel.to_bits())).wrapping_mul(0x100_0000_01b3);
        }
    };
    let Ok(()) = render(
        &mut tracer.with_worker(&mut Worker::new(())),
        &mut CenterSampler,
        Tile::full(resolution).pixels(),
        &mut sink,
    );
    hash
}

fn main() -> ExitCode {
    let hash = match std::env::args().nth(1).as_deref() {
        Some("smallest") => hash::<MinimalEffects>(),
        Some("local") => hash::<LocalEffects>(),
        Some("everything") => hash::<AllEffects>(),
        Some("local-shapes") => hash::<LocalEffectsOfScene>(),
        Some("everything-shapes") => hash::<AllEffectsOfScene>(),
        _ => {
            eprintln!("usage: local_light smallest|local|everything|local-shapes|everything-shapes");
            return ExitCode::from(2);
        }
    };
    println!("{hash:016x}");
    ExitCode::SUCCESS
}
