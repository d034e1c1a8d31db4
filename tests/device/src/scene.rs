//! The golden scene: small, with most effects.
//!
//! Constants only, which a device keeps in flash.

use strahl_core::geometry::{Aabb, Cone, ItemId, Polygon, ShapeKind, ShapeKindSet, Torus};
use strahl_core::scene::{
    EffectSet, Effects, FresnelModel, LightKind, LightKindSet, Texture, TextureId, TextureKind,
    TextureKindSet,
};
use strahl_core::{
    Background, CameraDescriptor, Falloff, Geometry, Light, LightSource, Limits, Material, MaterialId, Plane,
    Projection, Real, Resolution, Rgb, SceneDescriptor, Shape, Sphere, Vec3, vec3,
};

/// Resolution of the picture.
pub const SIZE: Resolution = Resolution::new(64, 48).unwrap();

/// Camera.
pub const VIEW: CameraDescriptor = CameraDescriptor {
    position: vec3(0.6, 2.4, 7.5),
    target: vec3(0.15, 0.95, 0.0),
    up: vec3(0.0, 1.0, 0.0),
    projection: Projection::Perspective { field_of_view: 0.6 },
};

/// Levels of rays: glass takes two, and a mirror behind it a third.
pub const LEVELS: usize = 6;

/// Levels and cutoff.
pub const LIMITS: Limits = Limits { levels: LEVELS as u8, cutoff: 1.0 / 512.0 };

/// Exactly the effects that the scene requires.
#[derive(Clone, Copy, Debug)]
pub struct GoldenEffects;

impl Effects for GoldenEffects {
    const SET: EffectSet = EffectSet {
        shapes: ShapeKindSet::of(&[
            ShapeKind::Plane,
            ShapeKind::Sphere,
            ShapeKind::SmoothTriangle,
            ShapeKind::Polygon,
            ShapeKind::Cone,
            ShapeKind::Torus,
        ]),
        smooth_shading: true,
        lights: LightKindSet::of(&[LightKind::Point, LightKind::Spot]),
        textures: TextureKindSet::of(&[TextureKind::Checker]),
        highlight: true,
        shadows: true,
        reflection: true,
        transmission: true,
        absorption: true,
        ..EffectSet::NONE
    };
}

/// The scene, not validated.
pub fn parts() -> SceneDescriptor<'static> {
    SceneDescriptor {
        geometry: Geometry {
            shapes: &SHAPES,
            vertices: &POINTS,
            vertex_normals: &NORMALS,
            planes: &[FLOOR],
            polygons: &[DART],
            cones: &[CONE],
            tori: &[RING],
            ..Geometry::EMPTY
        },
        material_ids: &MATERIAL_IDS,
        materials: &MATERIALS,
        textures: &[TILES],
        lights: &LIGHTS,
        ambient: Rgb::gray(0.25),
        background: SKY,
        ..SceneDescriptor::EMPTY
    }
}

/// Number of items.
pub const ITEMS: usize = 7;

static SHAPES: [Shape; ITEMS] = [
    Shape::Plane(0),
    Shape::Sphere(Sphere { center: vec3(-0.95, 0.9, 1.5), radius: 0.9 }),
    Shape::Sphere(Sphere { center: vec3(0.75, 1.15, -0.9), radius: 1.15 }),
    Shape::SmoothTriangle([0, 1, 2]),
    Shape::Polygon(0),
    Shape::Cone(0),
    Shape::Torus(0),
];

/// One material for each item.
static MATERIALS: [Material; ITEMS] = [
    // The floor.
    Material { texture: TextureId(0), diffuse: Rgb::gray(0.8), ambient: Rgb::WHITE, ..Material::MATTE },
    // Green glass.
    Material {
        ambient: Rgb::BLACK,
        diffuse: Rgb::BLACK,
        highlight: Rgb::gray(0.7),
        highlight_exponent: 120.0,
        transmission: Rgb::WHITE,
        refractive_index: 1.5,
        fresnel: FresnelModel::Dielectric,
        attenuation_length: Rgb::new(4.0, 20.0, 9.0),
        ..Material::MATTE
    },
    // A mirror.
    Material {
        highlight: Rgb::gray(0.8),
        highlight_exponent: 200.0,
        reflection: Rgb::new(0.85, 0.87, 0.9),
        ..matte(0.05, 0.05, 0.06)
    },
    // A sail.
    matte(0.85, 0.25, 0.18),
    // A dart.
    matte(0.1, 0.5, 0.55),
    // A cone.
    Material { highlight: Rgb::gray(0.3), highlight_exponent: 20.0, ..matte(0.9, 0.6, 0.1) },
    // A ring.
    Material { highlight: Rgb::gray(0.6), highlight_exponent: 50.0, ..matte(0.45, 0.2, 0.65) },
];

static MATERIAL_IDS: [MaterialId; ITEMS] =
    [MaterialId(0), MaterialId(1), MaterialId(2), MaterialId(3), MaterialId(4), MaterialId(5), MaterialId(6)];

const fn matte(r: Real, g: Real, b: Real) -> Material {
    let color = Rgb::new(r, g, b);
    Material { ambient: color, diffuse: color, ..Material::MATTE }
}

const FLOOR: Plane = Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(0) };

/// Vertices of the sail, then of the dart.
static POINTS: [Vec3; 7] = [
    vec3(-3.1, 0.0, -1.6),
    vec3(-1.2, 0.0, -2.2),
    vec3(-2.0, 2.3, -2.4),
    vec3(2.2, 0.5, -1.5),
    vec3(2.9, 0.9, -1.5),
    vec3(3.6, 0.5, -1.5),
    vec3(2.9, 2.1, -1.5),
];

/// Vertex normals of the sail.
static NORMALS: [Vec3; 3] = [vec3(-0.6, 0.0, 0.8), vec3(0.6, 0.0, 0.8), vec3(0.0, 0.6, 0.8)];

/// Concave, in the plane z = -1.5.
const DART: Polygon = Polygon {
    first_vertex: 3,
    vertex_count: 4,
    point: vec3(2.9, 1.0, -1.5),
    normal: Vec3::Z,
    bounds: Aabb::from_points(POINTS.split_at(3).1),
    smooth: false,
};

const CONE: Cone = Cone {
    base: vec3(2.05, 0.0, 1.1),
    axis: Vec3::Y,
    height: 1.1,
    base_radius: 0.55,
    end_radius: 0.12,
    capped: true,
};

/// Tilted, and touching the floor.
const RING: Torus = Torus {
    center: vec3(0.55, 0.42, 2.3),
    axis: vec3(0.0, 0.8, 0.6),
    major_radius: 0.45,
    minor_radius: 0.15,
};

/// Cells are unbounded along y, so that rounding never chooses between two.
const TILES: Texture = Texture::Checker {
    even: Rgb::new(0.9, 0.87, 0.8),
    odd: Rgb::new(0.28, 0.3, 0.36),
    origin: Vec3::ZERO,
    frequency: vec3(0.6, 0.0, 0.6),
};

static LIGHTS: [Light; 2] = [
    Light {
        source: LightSource::Point { position: vec3(4.0, 6.0, 5.0), falloff: Falloff::NONE },
        color: Rgb::new(0.5, 0.48, 0.45),
        casts_shadows: true,
    },
    Light {
        source: LightSource::Spot {
            position: vec3(-2.0, 6.5, 3.0),
            // (2, -6, -3) / 7
            direction: vec3(0.285_714_3, -0.857_142_9, -0.428_571_4),
            cos_inner: 0.95,
            cos_outer: 0.88,
            falloff: Falloff { constant: 0.5, linear: 0.0, quadratic: 0.01 },
        },
        color: Rgb::new(0.65, 0.68, 0.75),
        casts_shadows: true,
    },
];

const SKY: Background =
    Background::Gradient { up: Vec3::Y, below: Rgb::new(0.85, 0.75, 0.65), above: Rgb::new(0.12, 0.3, 0.75) };
