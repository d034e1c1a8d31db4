//! Each effect alone. For each of them a scene beside this file requires it and what it depends on, and
//! nothing else.
//!
//! An effect that a scene does not require traces no ray and draws no random number. A tracer with exactly
//! the required effects gives the same bytes as one with all effects; so does a tracer without the effect for
//! the scene without it.

use std::path::Path;

use strahl_core::geometry::ShapeKindSet;
use strahl_core::image::StochasticSampler;
use strahl_core::scene::{EffectSet, Effects, LightKindSet, TextureKindSet};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{
    AllEffects, Camera, Limits, ListWithoutBounds, Resolution, Rgb, Tile, Tracer, Worker, World, render,
};
use strahl_engine::{NoProgress, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_scene::effects::{disable, plan};
use strahl_session::RenderOutput;
use strahl_session::tables::single::{camera_descriptor, scene_tables};
use strahl_settings::OptionalEffect;
use strahl_settings::{SamplerSettings, Settings};

const SIZE: Resolution = Resolution::new(48, 36).unwrap();

fn scene(name: &str) -> LoadedScene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/effects").join(name).with_extension("toml");
    strahl_scene::load(&path).unwrap_or_else(|failure| panic!("{failure}"))
}

/// The effects that a scene requires.
fn required_effects(description: &LoadedScene) -> Vec<OptionalEffect> {
    let tables = scene_tables(description);
    let lens = description.camera.projection.has_lens();
    let set = EffectSet { depth_of_field: lens, ..tables.scene().unwrap().required_effects() };
    let planned: Vec<OptionalEffect> = plan(description).iter().map(|it| it.effect).collect();
    // The planned effects are those that the tracer requires.
    assert_eq!(
        planned,
        OptionalEffect::ALL.into_iter().filter(|effect| effect.is_in(&set)).collect::<Vec<_>>()
    );
    planned
}

/// Effects that an effect depends on.
fn dependencies(effect: OptionalEffect) -> &'static [OptionalEffect] {
    match effect {
        OptionalEffect::ColoredShadows => &[OptionalEffect::Shadows, OptionalEffect::Transmission],
        OptionalEffect::Gloss => &[OptionalEffect::Reflection],
        _ => &[],
    }
}

/// Everything that is not an effect of the command line.
const PLAIN: EffectSet = EffectSet {
    shapes: ShapeKindSet::ALL,
    smooth_shading: true,
    lights: LightKindSet::ALL,
    textures: TextureKindSet::ALL,
    highlight: true,
    absorption: true,
    ..EffectSet::NONE
};

macro_rules! tracers {
    ($($Name:ident { $($effect:ident),* })*) => {$(
        struct $Name;

        impl Effects for $Name {
            const SET: EffectSet = EffectSet { $($effect: true,)* ..PLAIN };
        }
    )*};
}

tracers! {
    Nothing {}
    Shadows { shadows }
    Reflection { reflection }
    Transmission { transmission }
    Solid { shadows, transmission }
    ColoredShadows { shadows, transmission, colored_shadows }
    SoftShadows { soft_shadows }
    Lens { depth_of_field }
    Gloss { reflection, gloss }
    Motion { motion_blur }
}

/// The bits of a picture with four samples per pixel.
fn rendered<E: Effects>(description: &LoadedScene) -> Vec<u32> {
    let tables = scene_tables(description);
    let scene = tables.scene().unwrap();
    let world = World::new(scene, ListWithoutBounds(scene.descriptor().material_ids.len() as u32));
    let camera = Camera::new(&camera_descriptor(&description.camera), SIZE).unwrap();
    let tracer = Tracer::<_, E, 5>::new(&world, camera, Limits::DEFAULT).unwrap();
    let mut bits = Vec::new();
    let mut sink = |_, color: Rgb| bits.extend([color.r, color.g, color.b].map(f32::to_bits));
    let mut sampler = StochasticSampler::new(4).unwrap();
    let Ok(()) = render(
        &mut tracer.with_worker(&mut Worker::new(())),
        &mut sampler,
        Tile::full(SIZE).pixels(),
        &mut sink,
    );
    bits
}

/// Renders a scene with one effect set.
type RenderFunction = fn(&LoadedScene) -> Vec<u32>;

/// Renders with an effect and its dependencies, and with its dependencies only.
fn smallest(effect: OptionalEffect) -> [RenderFunction; 2] {
    match effect {
        OptionalEffect::Shadows => [rendered::<Shadows>, rendered::<Nothing>],
        OptionalEffect::Reflection => [rendered::<Reflection>, rendered::<Nothing>],
        OptionalEffect::Transmission => [rendered::<Transmission>, rendered::<Nothing>],
        OptionalEffect::ColoredShadows => [rendered::<ColoredShadows>, rendered::<Solid>],
        OptionalEffect::SoftShadows => [rendered::<SoftShadows>, rendered::<Nothing>],
        OptionalEffect::Lens => [rendered::<Lens>, rendered::<Nothing>],
        OptionalEffect::Gloss => [rendered::<Gloss>, rendered::<Reflection>],
        OptionalEffect::Motion => [rendered::<Motion>, rendered::<Nothing>],
    }
}

fn counted(description: &LoadedScene, seed: u32) -> (RenderOutput, Counters) {
    let settings = Settings { size: SIZE, seed, sampler: SamplerSettings::Regular(2), ..Settings::default() };
    let frame =
        strahl_session::render(description, &settings, &RenderOptions::COUNT_TESTS, &NoProgress).unwrap();
    let counts = frame.counters;
    (frame, counts)
}

#[test]
fn each_effect_has_a_scene_that_requires_exactly_this_effect() {
    for effect in OptionalEffect::ALL {
        let mut want: Vec<OptionalEffect> = dependencies(effect).iter().copied().chain([effect]).collect();
        want.sort_by_key(|effect| *effect as u8);
        assert_eq!(required_effects(&scene(effect.name())), want, "{effect}");
    }
    assert_eq!(required_effects(&scene("nothing")), []);
    assert_eq!(required_effects(&scene("all")), OptionalEffect::ALL);
}

#[test]
fn effects_that_a_scene_does_not_require_trace_no_ray_and_draw_no_random_number() {
    for name in OptionalEffect::ALL.map(OptionalEffect::name).into_iter().chain(["nothing"]) {
        let description = scene(name);
        let required = required_effects(&description);
        let has = |effect| required.contains(&effect);
        let (frame, counts) = counted(&description, 0);
        assert_eq!(counts.rays[RayKind::Camera], 4 * 48 * 36, "{name}");
        let reflects = has(OptionalEffect::Reflection);
        assert_eq!(counts.rays[RayKind::Reflected] > 0, reflects, "{name}");
        assert_eq!(counts.rays[RayKind::Transmitted] > 0, has(OptionalEffect::Transmission), "{name}");
        for count in [counts.rays[RayKind::Shadow], counts.shape_tests[RayKind::Shadow]] {
            assert_eq!(count > 0, has(OptionalEffect::Shadows), "{name}");
        }
        // The shadow cache is not used with colored shadows.
        let caches = has(OptionalEffect::Shadows) && !has(OptionalEffect::ColoredShadows);
        assert_eq!(counts.shadow_cache_tests > 0, caches, "{name}");
        // With regular sampling only these effects are random.
        let is_random = [
            OptionalEffect::SoftShadows,
            OptionalEffect::Lens,
            OptionalEffect::Gloss,
            OptionalEffect::Motion,
        ]
        .into_iter()
        .any(has);
        assert_eq!(frame.picture != counted(&description, 1).0.picture, is_random, "{name}");
    }
}

#[test]
fn a_tracer_with_one_effect_and_one_with_all_give_the_same_bytes() {
    for effect in OptionalEffect::ALL {
        let [with, without] = smallest(effect);
        let mut description = scene(effect.name());
        let all = rendered::<AllEffects>(&description);
        assert!(with(&description) == all, "with {effect}");
        let steps = disable(&mut description, &[effect]);
        assert_eq!(steps.iter().map(|step| step.effect).collect::<Vec<_>>(), [effect]);
        let left = rendered::<AllEffects>(&description);
        assert!(without(&description) == left, "without {effect}");
        assert!(left != all, "{effect} is visible");
    }
    let plain = scene("nothing");
    assert!(rendered::<Nothing>(&plain) == rendered::<AllEffects>(&plain));
}
