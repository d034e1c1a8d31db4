//! A scene written as Rust constants, without a host and without a file: as a device would keep it in
//! flash. Everything about it is known when compiling, the memory for a worker too.
//!
//! ```text
//! cargo run -p strahl-core --example constants
//! ```
//!
//! draws it in letters. `strahl bake SCENE -o FILE.rs` writes such a room from any scene.

use strahl_core::geometry::{Aabb, Polygon, ShapeKind, ShapeSet};
use strahl_core::image::Pixel;
use strahl_core::scene::{EffectSet, Effects, LightKind, LightSet};
use strahl_core::{
    Background, BareList, Camera, CameraDescriptor, Falloff, Geometry, Light, LightSource, Limits, Material,
    MaterialId, Projection, Resolution, Rgb, Scene, SceneDescriptor, Shape, Single, Sphere, Tile, Tracer,
    Vec3, Worker, World, render, vec3,
};

/// A floor, and two balls on it.
static SHAPES: [Shape; 3] = [
    Shape::Polygon(0),
    Shape::Sphere(Sphere { center: vec3(-0.8, 1.0, 0.0), radius: 1.0 }),
    Shape::Sphere(Sphere { center: vec3(1.1, 0.6, 0.8), radius: 0.6 }),
];

/// The corners of the floor, against the clock as seen from above.
static CORNERS: [Vec3; 4] =
    [vec3(-3.0, 0.0, 2.0), vec3(3.0, 0.0, 2.0), vec3(3.0, 0.0, -2.0), vec3(-3.0, 0.0, -2.0)];

static FLOOR: [Polygon; 1] = [Polygon {
    first_vertex: 0,
    vertex_count: 4,
    point: Vec3::ZERO,
    normal: Vec3::Y,
    bounds: Aabb::from_points(&CORNERS),
    smooth: false,
}];

/// The item of the same place is made of it.
static MATERIALS: [Material; 3] = [
    Material { diffuse: Rgb::gray(0.5), ..Material::MATTE },
    Material { diffuse: Rgb::gray(0.9), ..Material::MATTE },
    Material { diffuse: Rgb::gray(0.1), reflection: Rgb::gray(0.8), ..Material::MATTE },
];

static LIGHTS: [Light; 1] = [Light {
    source: LightSource::Point { position: vec3(4.0, 7.0, 5.0), falloff: Falloff::NONE },
    color: Rgb::gray(0.9),
    casts_shadows: true,
}];

const PARTS: SceneDescriptor<'static> = SceneDescriptor {
    geometry: Geometry { shapes: &SHAPES, vertices: &CORNERS, polygons: &FLOOR, ..Geometry::EMPTY },
    material_ids: &[MaterialId(0), MaterialId(1), MaterialId(2)],
    materials: &MATERIALS,
    lights: &LIGHTS,
    ambient: Rgb::gray(0.08),
    background: Background::Color(Rgb::gray(0.3)),
    ..SceneDescriptor::EMPTY
};

/// Exactly what the scene asks for: nothing else is compiled.
struct Asked;

impl Effects for Asked {
    const SET: EffectSet = EffectSet {
        shapes: ShapeSet::of(&[ShapeKind::Polygon, ShapeKind::Sphere]),
        lights: LightSet::of(&[LightKind::Point]),
        shadows: true,
        reflection: true,
        ..EffectSet::NONE
    };
}

const VIEW: CameraDescriptor = CameraDescriptor {
    position: vec3(0.0, 2.2, 7.0),
    target: vec3(0.0, 0.6, 0.0),
    up: Vec3::Y,
    projection: Projection::Perspective { field_of_view: 0.5 },
};

/// Letters are about twice as high as wide: of the lines every second is drawn.
const SIZE: Resolution = Resolution::new(72, 44).unwrap();

const LEVELS: usize = 3;

/// A device that has less finds it out when compiling.
const _: () = assert!(Worker::<BareList, (), LEVELS>::SIZE_IN_BYTES <= 512);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Scene::new(PARTS)?;
    assert_eq!(scene.required_effects(), Asked::SET);
    let world = World::new(scene, BareList(SHAPES.len() as u32));
    let limits = Limits { levels: LEVELS as u8, ..Limits::DEFAULT };
    let tracer = Tracer::<_, Asked, LEVELS>::new(&world, Camera::new(&VIEW, SIZE)?, limits)?;
    let mut letters = |pixel: Pixel, color: Rgb| {
        let [_, gray, _] = color.to_srgb8();
        let ramp = b" .:-=+*#%@";
        let letter = ramp.get(usize::from(gray) * ramp.len() / 256).copied().unwrap_or(b'@');
        match pixel.y % 2 {
            0 if pixel.x + 1 == SIZE.width() => println!("{}", char::from(letter)),
            0 => print!("{}", char::from(letter)),
            _ => {}
        }
    };
    let Ok(()) = render(
        &mut tracer.with_worker(&mut Worker::new(())),
        &mut Single,
        Tile::whole(SIZE).pixels(),
        &mut letters,
    );
    Ok(())
}
