//! The scene of a well-known small ray tracer: four spheres and a checkered floor under three lights (Dmitry
//! Sokolov's *tinyraytracer*, from a description).
//!
//! Its conventions are options of the tracer and of the sink: the background is shown beyond a distance and
//! in place of rays below the last level, and colors brighter than white are scaled down.

use strahl_core::geometry::{Aabb, Polygon, ShapeKind, ShapeKindSet};
use strahl_core::scene::{
    EffectSet, Effects, LevelLimitRadiance, LightKind, LightKindSet, Texture, TextureId, TextureKind,
    TextureKindSet,
};
use strahl_core::{
    Background, CameraDescriptor, Falloff, Geometry, Light, LightSource, Limits, Material, MaterialId,
    Projection, Resolution, Rgb, SceneDescriptor, Shape, Sphere, Vec3, vec3,
};

/// Resolution of the picture.
pub const SIZE: Resolution = Resolution::new(160, 120).unwrap();

/// Camera along -z, with an angle of 1.05 from the top edge of the picture to the bottom edge. Between the
/// centers of the first and the last row it is `2 atan(tan(1.05 / 2) * 119 / 120)`.
pub const VIEW: CameraDescriptor = CameraDescriptor {
    position: Vec3::ZERO,
    target: vec3(0.0, 0.0, -1.0),
    up: Vec3::Y,
    projection: Projection::Perspective { field_of_view: 1.042_756_3 },
};

/// Levels of rays.
pub const LEVELS: usize = 5;

/// Levels and cutoff.
pub const LIMITS: Limits = Limits { levels: LEVELS as u8, cutoff: Limits::DEFAULT.cutoff };

/// Exactly the effects that the scene requires.
#[derive(Clone, Copy, Debug)]
pub struct PeerEffects;

impl Effects for PeerEffects {
    const SET: EffectSet = EffectSet {
        shapes: ShapeKindSet::of(&[ShapeKind::Sphere, ShapeKind::Polygon]),
        lights: LightKindSet::of(&[LightKind::Point]),
        textures: TextureKindSet::of(&[TextureKind::Checker]),
        highlight: true,
        shadows: true,
        reflection: true,
        transmission: true,
        ..EffectSet::NONE
    };
    const MAX_DISTANCE: f32 = 1000.0;
    const LEVEL_LIMIT_RADIANCE: LevelLimitRadiance = LevelLimitRadiance::Background;
}

/// Quantizes a color to eight bits per channel: colors brighter than white are scaled down, then truncated.
/// No gamma.
pub fn quantized(color: Rgb) -> [u8; 3] {
    let brightest = color.max_component();
    let scale = if brightest > 1.0 { 255.0 / brightest } else { 255.0 };
    [color.r, color.g, color.b].map(|channel| (channel * scale) as i32 as u8)
}

/// The scene, not validated.
pub const PARTS: SceneDescriptor<'static> = SceneDescriptor {
    geometry: Geometry { shapes: &SHAPES, vertices: &VERTICES, polygons: &[FLOOR], ..Geometry::EMPTY },
    material_ids: &[MaterialId(0), MaterialId(1), MaterialId(2), MaterialId(3), MaterialId(4)],
    materials: &MATERIALS,
    textures: &[TILES],
    lights: &LIGHTS,
    ambient: Rgb::BLACK,
    background: Background::Color(Rgb::new(0.2, 0.7, 0.8)),
    ..SceneDescriptor::EMPTY
};

/// Number of items.
pub const ITEMS: usize = 5;

static SHAPES: [Shape; ITEMS] = [
    Shape::Sphere(Sphere { center: vec3(-3.0, 0.0, -16.0), radius: 2.0 }),
    Shape::Sphere(Sphere { center: vec3(-1.0, -1.5, -12.0), radius: 2.0 }),
    Shape::Sphere(Sphere { center: vec3(1.5, -0.5, -18.0), radius: 3.0 }),
    Shape::Sphere(Sphere { center: vec3(7.0, 5.0, -18.0), radius: 4.0 }),
    Shape::Polygon(0),
];

/// No ambient light, and one-sided.
const BASE: Material = Material { ambient: Rgb::BLACK, two_sided: false, ..Material::MATTE };

/// One material for each item.
static MATERIALS: [Material; ITEMS] = [
    // Ivory.
    Material {
        diffuse: Rgb::new(0.9 * 0.4, 0.9 * 0.4, 0.9 * 0.3),
        highlight: Rgb::gray(0.5),
        highlight_exponent: 50.0,
        reflection: Rgb::gray(0.1),
        ..BASE
    },
    // Glass.
    Material {
        diffuse: Rgb::BLACK,
        highlight: Rgb::gray(0.9),
        highlight_exponent: 125.0,
        reflection: Rgb::gray(0.1),
        transmission: Rgb::gray(0.8),
        refractive_index: 1.5,
        ..BASE
    },
    // Red rubber.
    Material {
        diffuse: Rgb::new(1.4 * 0.3, 1.4 * 0.1, 1.4 * 0.1),
        highlight: Rgb::gray(0.3),
        highlight_exponent: 10.0,
        ..BASE
    },
    // A mirror.
    Material {
        diffuse: Rgb::BLACK,
        highlight: Rgb::gray(16.0),
        highlight_exponent: 1425.0,
        reflection: Rgb::gray(0.8),
        ..BASE
    },
    // The floor.
    Material { diffuse: Rgb::gray(2.0), texture: TextureId(0), ..BASE },
];

/// Vertices of the floor, in the order that makes its normal point up.
static VERTICES: [Vec3; 4] =
    [vec3(-10.0, -4.0, -10.0), vec3(10.0, -4.0, -10.0), vec3(10.0, -4.0, -30.0), vec3(-10.0, -4.0, -30.0)];

const FLOOR: Polygon = Polygon {
    first_vertex: 0,
    vertex_count: 4,
    point: vec3(0.0, -4.0, -20.0),
    normal: Vec3::Y,
    bounds: Aabb::from_points(&VERTICES),
    smooth: false,
};

const TILES: Texture = Texture::Checker {
    even: Rgb::new(0.3, 0.3, 0.3),
    odd: Rgb::new(0.3, 0.2, 0.1),
    origin: Vec3::ZERO,
    frequency: vec3(0.5, 0.0, 0.5),
};

static LIGHTS: [Light; 3] =
    [light(vec3(-20.0, 20.0, 20.0)), light(vec3(30.0, 50.0, -25.0)), light(vec3(30.0, 20.0, 30.0))];

const fn light(position: Vec3) -> Light {
    Light {
        source: LightSource::Point { position, falloff: Falloff::NONE },
        color: Rgb::WHITE,
        casts_shadows: true,
    }
}
