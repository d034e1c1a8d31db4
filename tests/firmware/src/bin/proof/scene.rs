//! Scenes, what they are made of and what they ask for, and how they are looked at.

use strahl_core::accel::Accelerator;
use strahl_core::geometry::{Aabb, Hit, ItemId, ShapeError, ShapeKind, ShapeSet};
use strahl_core::math::SobolSequence;
use strahl_core::scene::{
    CameraSample, EffectSet, Effects, Field, FieldError, FilmPoint, Interface, LastLevel, LightSet,
    SceneError, Texture, ViewFault,
};
use strahl_core::tally::RayKind;
use strahl_core::{
    AllEffects, Background, Camera, Falloff, Light, Material, MaterialId, Parts, Projection, Real,
    Resolution, Rgb, Scene, Source, Vec3, View, World,
};

use crate::accel::{Stranger, lists};
use crate::any::{any, any_item, any_ray, color, number, slice, used, vector};
use crate::geometry::any_geometry;
use crate::tally::Told;
use crate::text::displayed;

pub fn doors() {
    described();
    looked_at();
    displayed(any(ViewFault::NoUp));
    displayed(any(FieldError { field: Field::Color, value: -1.0 }));
    displayed(any(SceneError::Shape(ItemId(0), ShapeError::Radius)));
}

pub static MATERIALS: [Material; 1] = [Material::MATTE];

/// Parts with anything in them, whether they fit together or not.
pub fn any_parts() -> Parts<'static> {
    const CHECKER: Texture =
        Texture::Checker { even: Rgb::WHITE, odd: Rgb::BLACK, origin: Vec3::ZERO, frequency: Vec3::ONE };
    const LAMP: Light = Light {
        source: Source::Point { position: Vec3::ZERO, falloff: Falloff::SQUARE },
        color: Rgb::WHITE,
        shadows: true,
    };
    Parts {
        geometry: any_geometry(),
        made_of: slice(&[MaterialId(0)]),
        materials: slice(&MATERIALS),
        textures: slice(&[CHECKER]),
        lights: slice(&[LAMP]),
        ambient: color(),
        background: any(Background::Color(Rgb::BLACK)),
        colored_shadows: any(true),
    }
}

fn described() {
    let Ok(scene) = Scene::new(any_parts()) else { return };
    used((Scene::parts(&scene), Scene::effects(&scene), Scene::material(&scene, any_item())));
    used(Parts::bytes(Scene::parts(&scene)));
    used((
        Scene::new(any(Parts::EMPTY)).is_ok(),
        Background::toward(&any(Background::Color(Rgb::BLACK)), vector()),
    ));

    let material = any(Material { interface: any(Interface::Fresnel), ..Material::MATTE });
    used((
        Material::is_transmitting(&material),
        Material::is_shiny(&material),
        Material::is_absorbing(&material),
        Material::is_lit(&material),
        Material::is_rough(&material),
    ));
    if let (Some(light), Some(texture)) = (any_parts().lights.first(), any_parts().textures.first()) {
        used((Light::kind(light), Light::is_soft(light), Texture::kind(texture), any(Falloff::NONE)));
    }

    let mut lent = [Aabb::EMPTY];
    let [list, ..] = lists(&mut lent, [&mut [], &mut []]);
    asked::<_, AllEffects>(World::new(scene, list));
    asked::<_, Few>(World::new(scene, Stranger));
}

/// Spheres and nothing else.
pub struct Few;

impl Effects for Few {
    const SET: EffectSet = EffectSet { shapes: ShapeSet::of(&[ShapeKind::Sphere]), ..EffectSet::NONE };
}

/// What it does not see is the sky.
pub struct ShortSighted;

impl Effects for ShortSighted {
    const SET: EffectSet =
        EffectSet { lights: LightSet::ALL, reflection: true, transmission: true, ..Few::SET };
    const SIGHT: Real = 10.0;
    const LAST: LastLevel = LastLevel::Background;
}

fn asked<A: Accelerator, E: Effects>(world: World<'_, A>) {
    let (kind, mut scratch) = (any(RayKind::Shadow), A::Scratch::default());
    used((World::scene(&world), World::accelerator(&world)));
    used(World::nearest::<E, _>(&world, &any_ray(), number(), kind, &mut scratch, &mut Told));
    used(World::blocker::<E, _>(&world, &any_ray(), number(), kind, &mut scratch, &mut Told));
    used(World::blocks::<E, _>(&world, any_item(), &any_ray(), number(), kind, &mut Told));
    used(World::surface::<E>(&world, &any_ray(), any(Hit { t: 1.0, item: ItemId(0) })));
}

pub fn any_size() -> Resolution {
    any(Resolution::new(any(1), any(1))).unwrap_or(const { Resolution::new(1, 1).unwrap() })
}

pub fn any_camera() -> Option<Camera> {
    let projection = any(Projection::Perspective { angle: 1.0 });
    Camera::new(&View { from: vector(), at: vector(), up: vector(), projection }, any_size()).ok()
}

fn looked_at() {
    used((Resolution::width(any_size()), Resolution::height(any_size())));
    let place = any(FilmPoint { x: 0.0, y: 0.0 });
    used(any_camera().map(|camera| (Camera::ray(&camera, place), Camera::has_lens(&camera))));
}

pub fn any_sample() -> CameraSample {
    any(CameraSample { point: FilmPoint { x: 0.0, y: 0.0 }, stream: SobolSequence::new(0, 0, 0, 0) })
}
