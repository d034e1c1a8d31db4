//! A scene written as Rust constants, as a device keeps it in flash.
//!
//! No file is read and nothing is allocated; the size of the worker is checked at compile time.
//!
//! ```text
//! cargo run -p strahl-core --example constants
//! ```
//!
//! prints the picture as text. `strahl bake SCENE -o FILE.rs` writes such constants for any scene.

use strahl_core::geometry::{Aabb, Polygon, ShapeKind, ShapeKindSet};
use strahl_core::image::Pixel;
use strahl_core::scene::{EffectSet, Effects, LightKind, LightKindSet};
use strahl_core::{
    Background, Camera, CameraDescriptor, CenterSampler, Falloff, Geometry, Light, LightSource, Limits,
    ListWithoutBounds, Material, MaterialId, Projection, Resolution, Rgb, Scene, SceneDescriptor, Shape,
    Sphere, Tile, Tracer, Vec3, Worker, World, render, vec3,
};

/// A floor, and two spheres on it.
static SHAPES: [Shape; 3] = [
    Shape::Polygon(0),
    Shape::Sphere(Sphere { center: vec3(-0.8, 1.0, 0.0), radius: 1.0 }),
    Shape::Sphere(Sphere { center: vec3(1.1, 0.6, 0.8), radius: 0.6 }),
];

/// The vertices of the floor, counterclockwise as seen from above.
static VERTICES: [Vec3; 4] =
    [vec3(-3.0, 0.0, 2.0), vec3(3.0, 0.0, 2.0), vec3(3.0, 0.0, -2.0), vec3(-3.0, 0.0, -2.0)];

static FLOOR: [Polygon; 1] = [Polygon {
    first_vertex: 0,
    vertex_count: 4,
    point: Vec3::ZERO,
    normal: Vec3::Y,
    bounds: Aabb::from_points(&VERTICES),
    smooth: false,
}];

/// One material per item, by index.
static MATERIALS: [Material; 3] = [
    Material { diffuse: Rgb::gray(0.5), ambient: Rgb::WHITE, ..Material::MATTE },
    Material { diffuse: Rgb::gray(0.9), ambient: Rgb::WHITE, ..Material::MATTE },
    Material { diffuse: Rgb::gray(0.1), reflection: Rgb::gray(0.8), ambient: Rgb::WHITE, ..Material::MATTE },
];

static LIGHTS: [Light; 1] = [Light {
    source: LightSource::Point { position: vec3(4.0, 7.0, 5.0), falloff: Falloff::NONE },
    color: Rgb::gray(0.9),
    casts_shadows: true,
}];

const SCENE: SceneDescriptor<'static> = SceneDescriptor {
    geometry: Geometry { shapes: &SHAPES, vertices: &VERTICES, polygons: &FLOOR, ..Geometry::EMPTY },
    material_ids: &[MaterialId(0), MaterialId(1), MaterialId(2)],
    materials: &MATERIALS,
    lights: &LIGHTS,
    ambient: Rgb::gray(0.08),
    background: Background::Color(Rgb::gray(0.3)),
    ..SceneDescriptor::EMPTY
};

/// Exactly the effects that the scene requires; nothing else is compiled.
struct RequiredEffects;

impl Effects for RequiredEffects {
    const SET: EffectSet = EffectSet {
        shapes: ShapeKindSet::of(&[ShapeKind::Polygon, ShapeKind::Sphere]),
        lights: LightKindSet::of(&[LightKind::Point]),
        shadows: true,
        reflection: true,
        ..EffectSet::NONE
    };
}

const CAMERA: CameraDescriptor = CameraDescriptor {
    position: vec3(0.0, 2.2, 7.0),
    target: vec3(0.0, 0.6, 0.0),
    up: Vec3::Y,
    projection: Projection::Perspective { field_of_view: 0.5 },
};

/// Characters are about twice as high as wide, so only every other row is printed.
const RESOLUTION: Resolution = Resolution::new(72, 44).unwrap();

const LEVELS: usize = 3;

/// Fails to compile if the worker needs more memory.
const _: () = assert!(Worker::<ListWithoutBounds, (), LEVELS>::SIZE_IN_BYTES <= 512);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Scene::new(SCENE)?;
    assert_eq!(scene.required_effects(), RequiredEffects::SET);
    let world = World::new(scene, ListWithoutBounds(SHAPES.len() as u32));
    let limits = Limits { levels: LEVELS as u8, ..Limits::DEFAULT };
    let tracer =
        Tracer::<_, RequiredEffects, LEVELS>::new(&world, Camera::new(&CAMERA, RESOLUTION)?, limits)?;
    let mut print_pixel = |pixel: Pixel, color: Rgb| {
        let [_, gray, _] = color.to_srgb8();
        let ramp = b" .:-=+*#%@";
        let character = ramp.get(usize::from(gray) * ramp.len() / 256).copied().unwrap_or(b'@');
        match pixel.y % 2 {
            0 if pixel.x + 1 == RESOLUTION.width() => println!("{}", char::from(character)),
            0 => print!("{}", char::from(character)),
            _ => {}
        }
    };
    let Ok(()) = render(
        &mut tracer.with_worker(&mut Worker::new(())),
        &mut CenterSampler,
        Tile::full(RESOLUTION).pixels(),
        &mut print_pixel,
    );
    Ok(())
}
