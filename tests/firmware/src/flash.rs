//! What effects cost in flash: the same small scene, traced by tracers that can do more and more.
//!
//! The smallest firmware that draws a picture and hands it to somebody: rows of linear floats go
//! out of the serial port as they are made. No file, no text, nothing that a product would not have.

// Who includes this file may use a part of it.
#![allow(dead_code)]

use core::hint::black_box;

use strahl_core::geometry::{ItemId, ShapeKind, ShapeSet};
use strahl_core::image::Pixel;
use strahl_core::scene::{EffectSet, Effects, FresnelModel, LightKind, LightSet};
use strahl_core::{
    Background, BareList, Camera, CameraDescriptor, CenterSampler, Falloff, Geometry, Light, LightSource,
    Limits, Material, MaterialId, Plane, Projection, Resolution, Rgb, Scene, SceneDescriptor, Shape, Sphere,
    Tile, Tracer, Vec3, Worker, World, render, vec3,
};

/// A step of the table: what the tracer can do, and a scene that asks for exactly that.
pub trait Step: Effects {
    /// The scene, not yet checked.
    const PARTS: SceneDescriptor<'static>;
    /// How it is looked at.
    const VIEW: CameraDescriptor = CameraDescriptor {
        position: vec3(0.0, 1.5, 5.0),
        target: vec3(0.0, 0.7, 0.0),
        up: Vec3::Y,
        projection: Projection::Perspective { field_of_view: 0.6 },
    };
}

/// How large the picture is.
pub const SIZE: Resolution = Resolution::new(64, 48).unwrap();

/// Levels of rays.
pub const LEVELS: usize = 5;

/// Which picture is wanted.
pub const LIMITS: Limits = Limits::DEFAULT;

const ITEMS: usize = 4;

static SHAPES: [Shape; ITEMS] = [
    Shape::Plane(0),
    Shape::Sphere(Sphere { center: vec3(-1.1, 0.7, 0.0), radius: 0.7 }),
    Shape::Sphere(Sphere { center: vec3(0.35, 0.6, 0.4), radius: 0.6 }),
    Shape::Sphere(Sphere { center: vec3(1.3, 0.4, -0.4), radius: 0.4 }),
];

const FLOOR: Plane = Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(0) };

const fn paint(r: f32, g: f32, b: f32) -> Material {
    let color = Rgb::new(r, g, b);
    Material { ambient: color, diffuse: color, ..Material::MATTE }
}

const MATTE: [Material; ITEMS] =
    [paint(0.6, 0.6, 0.55), paint(0.8, 0.25, 0.2), paint(0.2, 0.5, 0.6), paint(0.9, 0.7, 0.2)];

const MIRROR: Material = Material { reflection: Rgb::gray(0.9), ..paint(0.05, 0.05, 0.05) };

const GLASS: Material = Material {
    transmission: Rgb::gray(0.95),
    refractive_index: 1.5,
    fresnel: FresnelModel::Dielectric,
    ..paint(0.0, 0.0, 0.0)
};

const fn lamp(source: LightSource, shadows: bool) -> [Light; 1] {
    [Light { source, color: Rgb::gray(0.8), casts_shadows: shadows }]
}

const PLACE: Vec3 = vec3(3.0, 5.0, 4.0);
const POINT: LightSource = LightSource::Point { position: PLACE, falloff: Falloff::NONE };

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

/// Spheres and a plane under a light that nothing stands in the way of.
pub struct Local;

impl Effects for Local {
    const SET: EffectSet = EffectSet {
        shapes: ShapeSet::of(&[ShapeKind::Plane, ShapeKind::Sphere]),
        lights: LightSet::of(&[LightKind::Point]),
        ..EffectSet::NONE
    };
}

impl Step for Local {
    const PARTS: SceneDescriptor<'static> = parts(&MATTE, &lamp(POINT, false));
}

/// And shadows.
pub struct Shadows;

impl Effects for Shadows {
    const SET: EffectSet = EffectSet { shadows: true, ..Local::SET };
}

impl Step for Shadows {
    const PARTS: SceneDescriptor<'static> = parts(&MATTE, &lamp(POINT, true));
}

/// And mirrors.
pub struct Mirrors;

impl Effects for Mirrors {
    const SET: EffectSet = EffectSet { reflection: true, ..Shadows::SET };
}

impl Step for Mirrors {
    const PARTS: SceneDescriptor<'static> =
        parts(&[MATTE[0], MIRROR, MATTE[2], MATTE[3]], &lamp(POINT, true));
}

/// And glass.
pub struct Glass;

impl Effects for Glass {
    const SET: EffectSet = EffectSet { transmission: true, ..Mirrors::SET };
}

impl Step for Glass {
    const PARTS: SceneDescriptor<'static> = parts(&[MATTE[0], MIRROR, GLASS, MATTE[3]], &lamp(POINT, true));
}

/// And what is left to chance: soft shadows, rough mirrors, a lens.
pub struct Distributed;

impl Effects for Distributed {
    const SET: EffectSet = EffectSet {
        lights: LightSet::of(&[LightKind::Sphere]),
        penumbra: true,
        gloss: true,
        depth_of_field: true,
        ..Glass::SET
    };
}

impl Step for Distributed {
    const PARTS: SceneDescriptor<'static> = parts(
        &[MATTE[0], Material { roughness: 0.3, ..MIRROR }, GLASS, MATTE[3]],
        &lamp(LightSource::Sphere { position: PLACE, radius: 0.5, falloff: Falloff::NONE }, true),
    );
    const VIEW: CameraDescriptor = CameraDescriptor {
        projection: Projection::ThinLens { field_of_view: 0.6, lens_radius: 0.05, focus_distance: 5.0 },
        ..Local::VIEW
    };
}

/// Draws the picture of a step and hands its floats over, pixel by pixel.
///
/// None when the scene is not the tracer's, which it is. Not inlined, so that what the core takes can
/// be told from the rest by names.
#[inline(never)]
pub fn picture<S: Step>(mut send: impl FnMut([u8; 4])) -> Option<()> {
    // As if it came from elsewhere: no number of the scene is folded into the code.
    let world = World::new(Scene::new(black_box(S::PARTS)).ok()?, BareList(ITEMS as u32));
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

/// The data register of the serial port USART1 of an STM32F405, whose clock and pins a product
/// would set up first; QEMU's needs none.
#[cfg(target_arch = "arm")]
const SERIAL: *mut u32 = 0x4001_1004 as *mut u32;

/// The whole firmware of a step.
#[cfg(target_arch = "arm")]
pub fn run<S: Step>() -> ! {
    let drawn = picture::<S>(|bytes| {
        for byte in bytes {
            // SAFETY: a 32-bit peripheral register of this machine.
            unsafe { SERIAL.write_volatile(u32::from(byte)) };
        }
    });
    for byte in crate::stack::used().to_le_bytes() {
        // SAFETY: as above.
        unsafe { SERIAL.write_volatile(u32::from(byte)) };
    }
    semihosting::process::exit(i32::from(drawn.is_none()))
}
