//! The cost of effects in flash: a small scene, traced with growing effect sets.
//!
//! The smallest firmware that draws a picture and transmits it: linear floats are sent through the serial
//! port as they are computed. It contains no files, no text, and nothing that a product would not need.

use core::hint::black_box;

use strahl_core::geometry::{ItemId, ShapeKind, ShapeKindSet};
use strahl_core::image::Pixel;
use strahl_core::scene::{EffectSet, Effects, FresnelModel, LightKind, LightKindSet};
use strahl_core::{
    Background, Camera, CameraDescriptor, CenterSampler, Falloff, Geometry, Light, LightSource, Limits,
    ListWithoutBounds, Material, MaterialId, Plane, Projection, Resolution, Rgb, Scene, SceneDescriptor,
    Shape, Sphere, Tile, Tracer, Vec3, Worker, World, render, vec3,
};

/// A variant of the table: an effect set, and a scene that requires exactly these effects.
pub trait FlashVariant: Effects {
    /// The scene, not validated.
    const PARTS: SceneDescriptor<'static>;
    /// Camera.
    const VIEW: CameraDescriptor = CameraDescriptor {
        position: vec3(0.0, 1.5, 5.0),
        target: vec3(0.0, 0.7, 0.0),
        up: Vec3::Y,
        projection: Projection::Perspective { field_of_view: 0.6 },
    };
}

/// Resolution of the picture.
pub const SIZE: Resolution = Resolution::new(64, 48).unwrap();

/// Levels of rays.
pub const LEVELS: usize = 5;

/// Levels and cutoff.
pub const LIMITS: Limits = Limits::DEFAULT;

const ITEMS: usize = 4;

static SHAPES: [Shape; ITEMS] = [
    Shape::Plane(0),
    Shape::Sphere(Sphere { center: vec3(-1.1, 0.7, 0.0), radius: 0.7 }),
    Shape::Sphere(Sphere { center: vec3(0.35, 0.6, 0.4), radius: 0.6 }),
    Shape::Sphere(Sphere { center: vec3(1.3, 0.4, -0.4), radius: 0.4 }),
];

const FLOOR: Plane = Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(0) };

const fn matte(r: f32, g: f32, b: f32) -> Material {
    let color = Rgb::new(r, g, b);
    Material { ambient: color, diffuse: color, ..Material::MATTE }
}

const MATTE: [Material; ITEMS] =
    [matte(0.6, 0.6, 0.55), matte(0.8, 0.25, 0.2), matte(0.2, 0.5, 0.6), matte(0.9, 0.7, 0.2)];

const MIRROR: Material = Material { reflection: Rgb::gray(0.9), ..matte(0.05, 0.05, 0.05) };

const GLASS: Material = Material {
    transmission: Rgb::gray(0.95),
    refractive_index: 1.5,
    fresnel: FresnelModel::Dielectric,
    ..matte(0.0, 0.0, 0.0)
};

const fn light(source: LightSource, shadows: bool) -> [Light; 1] {
    [Light { source, color: Rgb::gray(0.8), casts_shadows: shadows }]
}

const LIGHT_POSITION: Vec3 = vec3(3.0, 5.0, 4.0);
const POINT: LightSource = LightSource::Point { position: LIGHT_POSITION, falloff: Falloff::NONE };

const fn parts(materials: &'static [Material], lights: &'static [Light]) -> SceneDescriptor<'static> {
    SceneDescriptor {
        geometry: Geometry { shapes: &SHAPES, planes: &[FLOOR], ..Geometry::EMPTY },
        material_ids: &[MaterialId(0), MaterialId(1), MaterialId(2), MaterialId(3)],
        materials,
        lights,
        ambient: Rgb::gray(0.25),
        background: Background::Color(Rgb::new(0.5, 0.7, 0.9)),
        ..SceneDescriptor::EMPTY
    }
}

/// Spheres and a plane under a light without shadows.
pub struct FlashLocal;

impl Effects for FlashLocal {
    const SET: EffectSet = EffectSet {
        shapes: ShapeKindSet::of(&[ShapeKind::Plane, ShapeKind::Sphere]),
        lights: LightKindSet::of(&[LightKind::Point]),
        ..EffectSet::NONE
    };
}

impl FlashVariant for FlashLocal {
    const PARTS: SceneDescriptor<'static> = parts(&MATTE, &light(POINT, false));
}

/// The previous variant with shadows.
pub struct FlashShadows;

impl Effects for FlashShadows {
    const SET: EffectSet = EffectSet { shadows: true, ..FlashLocal::SET };
}

impl FlashVariant for FlashShadows {
    const PARTS: SceneDescriptor<'static> = parts(&MATTE, &light(POINT, true));
}

/// The previous variant with a mirror.
pub struct FlashMirrors;

impl Effects for FlashMirrors {
    const SET: EffectSet = EffectSet { reflection: true, ..FlashShadows::SET };
}

impl FlashVariant for FlashMirrors {
    const PARTS: SceneDescriptor<'static> =
        parts(&[MATTE[0], MIRROR, MATTE[2], MATTE[3]], &light(POINT, true));
}

/// The previous variant with glass.
pub struct FlashGlass;

impl Effects for FlashGlass {
    const SET: EffectSet = EffectSet { transmission: true, ..FlashMirrors::SET };
}

impl FlashVariant for FlashGlass {
    const PARTS: SceneDescriptor<'static> = parts(&[MATTE[0], MIRROR, GLASS, MATTE[3]], &light(POINT, true));
}

/// The previous variant with distributed effects: soft shadows, a rough mirror, depth of field.
pub struct FlashDistributed;

impl Effects for FlashDistributed {
    const SET: EffectSet = EffectSet {
        lights: LightKindSet::of(&[LightKind::Sphere]),
        soft_shadows: true,
        gloss: true,
        depth_of_field: true,
        ..FlashGlass::SET
    };
}

impl FlashVariant for FlashDistributed {
    const PARTS: SceneDescriptor<'static> = parts(
        &[MATTE[0], Material { roughness: 0.3, ..MIRROR }, GLASS, MATTE[3]],
        &light(LightSource::Sphere { position: LIGHT_POSITION, radius: 0.5, falloff: Falloff::NONE }, true),
    );
    const VIEW: CameraDescriptor = CameraDescriptor {
        projection: Projection::ThinLens { field_of_view: 0.6, lens_radius: 0.05, focus_distance: 5.0 },
        ..FlashLocal::VIEW
    };
}

/// Draws the picture of a variant and sends its floats, pixel by pixel. `None` if the scene is invalid.
///
/// Not inlined, so that symbol names separate the core from the rest.
#[inline(never)]
pub fn picture<S: FlashVariant>(mut send: impl FnMut([u8; 4])) -> Option<()> {
    // Opaque to the optimizer: no constant of the scene is folded into the code.
    let world = World::new(Scene::new(black_box(S::PARTS)).ok()?, ListWithoutBounds(ITEMS as u32));
    let camera = Camera::new(&black_box(S::VIEW), SIZE).ok()?;
    let tracer = Tracer::<_, S, LEVELS>::new(&world, camera, LIMITS).ok()?;
    let mut worker = Worker::new(());
    let mut sink = |_: Pixel, color: Rgb| [color.r, color.g, color.b].map(f32::to_le_bytes).map(&mut send);
    let mut sink = |pixel, color| {
        sink(pixel, color);
    };
    let Ok(()) = render(
        &mut tracer.with_worker(&mut worker),
        &mut CenterSampler,
        Tile::full(SIZE).pixels(),
        &mut sink,
    );
    Some(())
}
