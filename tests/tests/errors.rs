//! Errors of the core name the field, its value and what it must be.

use strahl_core::geometry::{ItemId, Torus};
use strahl_core::scene::{EffectSet, Effects, SceneError};
use strahl_core::trace::TracerError;
use strahl_core::*;

const SPOT_LIGHT: Light = Light {
    source: LightSource::Spot {
        position: vec3(0.0, 5.0, 0.0),
        direction: vec3(0.0, -1.0, 0.0),
        cos_inner: 0.9,
        cos_outer: 0.8,
        falloff: Falloff::NONE,
    },
    color: Rgb::WHITE,
    casts_shadows: true,
};

fn error(parts: SceneDescriptor<'_>) -> String {
    Scene::new(parts).unwrap_err().to_string()
}

fn lit(change: impl Fn(&mut LightSource)) -> String {
    let mut light = SPOT_LIGHT;
    change(&mut light.source);
    error(SceneDescriptor { lights: &[SPOT_LIGHT, light], ..SceneDescriptor::EMPTY })
}

#[test]
fn a_light_out_of_range_is_named_with_its_field() {
    let spot = |bright, dark| {
        lit(|source| {
            let LightSource::Spot { cos_inner, cos_outer, .. } = source else { unreachable!() };
            (*cos_inner, *cos_outer) = (bright, dark);
        })
    };
    assert_eq!(spot(1.5, 0.5), "light 1: `cos_inner` is 1.5, must be at most 1 and at least `cos_outer`");
    assert_eq!(spot(0.25, 0.5), "light 1: `cos_inner` is 0.25, must be at most 1 and at least `cos_outer`");
    assert_eq!(spot(0.5, -2.0), "light 1: `cos_outer` is -2, must be in -1..=1");
    let aimed = |toward| lit(|source| *source = LightSource::Directional { to_light: toward });
    assert_eq!(aimed(vec3(0.0, 2.0, 0.0)), "light 1: `to_light` has the length 2, must be 1");
    let far = vec3(0.0, f32::NAN, 0.0);
    let point = |falloff, position| lit(|source| *source = LightSource::Point { position, falloff });
    assert_eq!(
        point(Falloff::NONE, far),
        "light 1: `position` has a coordinate of NaN, must be in -1e15..=1e15"
    );
    let nothing = Falloff { constant: 0.0, ..Falloff::NONE };
    assert_eq!(point(nothing, Vec3::ZERO), "light 1: `falloff` has the sum 0, must be more than 0");
    let bright = [Light { color: Rgb::new(0.0, -1.0, 0.0), ..SPOT_LIGHT }];
    let parts = SceneDescriptor { lights: &bright, ..SceneDescriptor::EMPTY };
    assert_eq!(error(parts), "light 0: `color` has a channel of -1, must be in 0..=1e6");
}

#[test]
fn materials_textures_and_surroundings_out_of_range_are_named_with_their_field() {
    let of = |material: Material| error(SceneDescriptor { materials: &[material], ..SceneDescriptor::EMPTY });
    let glass = Material { transmission: Rgb::WHITE, refractive_index: 0.0, ..Material::MATTE };
    assert_eq!(of(glass), "material 0: `refractive_index` is 0, must be in 0.01..=100");
    let mirror = Material { reflection: Rgb::gray(1.5), ..Material::MATTE };
    assert_eq!(of(mirror), "material 0: `reflection` has a channel of 1.5, must be in 0..=1");
    let tiles = Material { texture: scene::TextureId(2), ..Material::MATTE };
    let must_be = "must be an index of the table of textures, or `TextureId::NONE`";
    assert_eq!(of(tiles), format!("material 0: `texture` is 2, {must_be}"));
    let plate = scene::Texture::ZonePlate {
        start_color: Rgb::BLACK,
        end_color: Rgb::WHITE,
        origin: Vec3::ZERO,
        frequency: -1.0,
    };
    let parts = SceneDescriptor { textures: &[plate], ..SceneDescriptor::EMPTY };
    assert_eq!(error(parts), "texture 0: `frequency` is -1, must be in 0..=1e15");
    let parts = SceneDescriptor { ambient: Rgb::gray(2e6), ..SceneDescriptor::EMPTY };
    assert_eq!(error(parts), "scene: `ambient` has a channel of 2000000, must be in 0..=1e6");
    let (below, above) = (Rgb::BLACK, Rgb::WHITE);
    let parts = SceneDescriptor {
        background: Background::Gradient { up: Vec3::ZERO, below, above },
        ..SceneDescriptor::EMPTY
    };
    assert_eq!(error(parts), "background: `up` has the length 0, must be 1");
    let sphere = [Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 })];
    let geometry = Geometry { shapes: &sphere, ..Geometry::EMPTY };
    let parts = SceneDescriptor {
        geometry,
        material_ids: &[MaterialId(1)],
        materials: &[Material::MATTE],
        ..SceneDescriptor::EMPTY
    };
    assert_eq!(Scene::new(parts).unwrap_err(), SceneError::MissingMaterial(ItemId(0)));
    assert_eq!(error(parts), "item 0: `material_ids` names no entry of `materials`");
}

/// Spheres only.
#[derive(Debug)]
struct Spheres;

impl Effects for Spheres {
    const SET: EffectSet =
        EffectSet { shapes: geometry::ShapeKindSet::of(&[geometry::ShapeKind::Sphere]), ..EffectSet::NONE };
}

#[test]
fn a_tracer_error_names_the_missing_effects_and_the_remedy() {
    let mut tables = SceneTables::new();
    let shiny = Material { reflection: Rgb::WHITE, roughness: 0.5, ..Material::MATTE };
    let shiny = tables.add_material(shiny);
    tables
        .add_torus(Torus { center: Vec3::ZERO, axis: Vec3::Y, major_radius: 2.0, minor_radius: 0.5 }, shiny);
    let world = World::new(tables.scene().unwrap(), ListWithoutBounds(1));
    let projection = Projection::Perspective { field_of_view: 1.0 };
    let view =
        CameraDescriptor { position: vec3(0.0, 0.0, 5.0), target: Vec3::ZERO, up: Vec3::Y, projection };
    let camera = Camera::new(&view, Resolution::new(1, 1).unwrap()).unwrap();
    let error = |limits| Tracer::<_, Spheres, 5>::new(&world, camera, limits).unwrap_err();
    let missing = error(Limits::DEFAULT);
    assert!(matches!(missing, TracerError::MissingEffects { .. }));
    assert_eq!(
        missing.to_string(),
        "the scene needs effects that the tracer leaves out: torus shapes, reflection, gloss; add them to \
         `Effects::SET`, or use `AllEffects`"
    );
    let error = |limits| Tracer::<_, AllEffects, 5>::new(&world, camera, limits).unwrap_err().to_string();
    let levels = error(Limits { levels: 6, ..Limits::DEFAULT });
    assert_eq!(levels, "`levels` is 6, must be in 1..=5: `LEVELS` of the tracer");
    let cutoff = error(Limits { cutoff: 2.0, ..Limits::DEFAULT });
    assert_eq!(cutoff, "`cutoff` is 2, must be in 0..=1");
    let wide = CameraDescriptor { projection: Projection::Perspective { field_of_view: 4.0 }, ..view };
    let error = Camera::new(&wide, Resolution::new(1, 1).unwrap()).unwrap_err();
    assert_eq!(error.to_string(), "`field_of_view` is 4, must be more than 0 and less than pi (radians)");
}
