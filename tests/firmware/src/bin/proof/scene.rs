//! Scenes, materials, lights, effects and cameras.

use strahl_core::accel::Accelerator;
use strahl_core::geometry::{Aabb, Hit, ItemId, ShapeError, ShapeKind, ShapeKindSet};
use strahl_core::math::SobolSequence;
use strahl_core::scene::{
    CameraError, CameraSample, EffectSet, Effects, Field, FieldError, FilmPoint, FresnelModel,
    LevelLimitRadiance, LightKindSet, SceneError, Texture,
};
use strahl_core::tally::RayKind;
use strahl_core::{
    AllEffects, Background, Camera, CameraDescriptor, Falloff, Light, LightSource, Material, MaterialId,
    Projection, Real, Resolution, Rgb, Scene, SceneDescriptor, Vec3, World,
};

use crate::accel::{ArbitraryAccelerator, lists};
use crate::any::{any, any_item, any_ray, color, number, slice, used, vector};
use crate::geometry::any_geometry;
use crate::tally::DiscardingTally;
use crate::text::displayed;

pub fn entry_points() {
    described();
    looked_at();
    displayed(any(CameraError::UpParallelToView));
    displayed(any(FieldError { field: Field::Color, value: -1.0 }));
    displayed(any(SceneError::Shape(ItemId(0), ShapeError::Radius)));
}

pub static MATERIALS: [Material; 1] = [Material::MATTE];

/// Tables with anything in them, whether they fit together or not.
pub fn any_parts() -> SceneDescriptor<'static> {
    const CHECKER: Texture =
        Texture::Checker { even: Rgb::WHITE, odd: Rgb::BLACK, origin: Vec3::ZERO, frequency: Vec3::ONE };
    const LAMP: Light = Light {
        source: LightSource::Point { position: Vec3::ZERO, falloff: Falloff::INVERSE_SQUARE },
        color: Rgb::WHITE,
        casts_shadows: true,
    };
    SceneDescriptor {
        geometry: any_geometry(),
        material_ids: slice(&[MaterialId(0)]),
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
    used((Scene::descriptor(&scene), Scene::required_effects(&scene), Scene::material(&scene, any_item())));
    used(SceneDescriptor::size_in_bytes(Scene::descriptor(&scene)));
    used((
        Scene::new(any(SceneDescriptor::EMPTY)).is_ok(),
        Background::radiance(&any(Background::Color(Rgb::BLACK)), vector()),
    ));

    used((
        Material::matte(color()),
        Light::point(vector(), color()),
        CameraDescriptor::perspective(vector(), vector(), number()),
    ));

    let material = any(Material { fresnel: any(FresnelModel::Dielectric), ..Material::MATTE });
    used((
        Material::is_transmitting(&material),
        Material::has_highlight(&material),
        Material::is_absorbing(&material),
        Material::is_lit(&material),
        Material::is_glossy(&material),
    ));
    if let (Some(light), Some(texture)) = (any_parts().lights.first(), any_parts().textures.first()) {
        used((
            Light::kind(light),
            Light::has_soft_shadows(light),
            Texture::kind(texture),
            any(Falloff::NONE),
        ));
    }

    let mut buffers = [Aabb::EMPTY];
    let [list, ..] = lists(&mut buffers, [&mut [], &mut []]);
    query_world::<_, AllEffects>(World::new(scene, list));
    query_world::<_, SpheresOnly>(World::new(scene, ArbitraryAccelerator));
}

/// Spheres only.
pub struct SpheresOnly;

impl Effects for SpheresOnly {
    const SET: EffectSet = EffectSet { shapes: ShapeKindSet::of(&[ShapeKind::Sphere]), ..EffectSet::NONE };
}

/// The background beyond a distance and below the last level.
pub struct LimitedDistanceEffects;

impl Effects for LimitedDistanceEffects {
    const SET: EffectSet =
        EffectSet { lights: LightKindSet::ALL, reflection: true, transmission: true, ..SpheresOnly::SET };
    const MAX_DISTANCE: Real = 10.0;
    const LEVEL_LIMIT_RADIANCE: LevelLimitRadiance = LevelLimitRadiance::Background;
}

fn query_world<A: Accelerator, E: Effects>(world: World<'_, A>) {
    let (kind, mut scratch) = (any(RayKind::Shadow), A::Scratch::default());
    used((World::scene(&world), World::accelerator(&world)));
    used(World::nearest_hit::<E, _>(&world, &any_ray(), number(), kind, &mut scratch, &mut DiscardingTally));
    used(World::occluder::<E, _>(&world, &any_ray(), number(), kind, &mut scratch, &mut DiscardingTally));
    used(World::is_occluded_by::<E, _>(&world, any_item(), &any_ray(), number(), kind, &mut DiscardingTally));
    used(World::surface_interaction::<E>(&world, &any_ray(), any(Hit { t: 1.0, item: ItemId(0) })));
}

pub fn any_size() -> Resolution {
    any(Resolution::new(any(1), any(1))).unwrap_or(const { Resolution::new(1, 1).unwrap() })
}

pub fn any_camera() -> Option<Camera> {
    let projection = any(Projection::Perspective { field_of_view: 1.0 });
    Camera::new(
        &CameraDescriptor { position: vector(), target: vector(), up: vector(), projection },
        any_size(),
    )
    .ok()
}

fn looked_at() {
    used((Resolution::width(any_size()), Resolution::height(any_size())));
    let point = any(FilmPoint { x: 0.0, y: 0.0 });
    used(any_camera().map(|camera| (Camera::ray(&camera, point), Camera::has_depth_of_field(&camera))));
}

pub fn any_sample() -> CameraSample {
    any(CameraSample { point: FilmPoint { x: 0.0, y: 0.0 }, sequence: SobolSequence::new(0, 0, 0, 0) })
}
