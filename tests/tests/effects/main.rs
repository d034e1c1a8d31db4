//! The effects, each alone: for each of them a scene beside this file that asks for it and for
//! nothing that it can do without. What such a scene does not ask for sends no ray and takes no
//! number of chance, a tracer that can do nothing else gives the same bytes as one that can do
//! everything, and so does, of the scene without the effect, a tracer that cannot do it.

use std::path::Path;

use strahl_core::geometry::ShapeSet;
use strahl_core::image::Stochastic;
use strahl_core::scene::{EffectSet, Effects, LightSet, TextureSet};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{
    AllEffects, BareList, Camera, Limits, Resolution, Rgb, Tile, Tracer, Worker, World, render,
};
use strahl_engine::{NoProgress, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_scene::effects::{disable, plan};
use strahl_session::RenderOutput;
use strahl_session::tables::single::{scene_tables, view};
use strahl_settings::Effect;
use strahl_settings::{SamplerSettings, Settings};

const SIZE: Resolution = Resolution::new(48, 36).unwrap();

fn scene(name: &str) -> LoadedScene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/effects").join(name).with_extension("toml");
    strahl_scene::load(&path).unwrap_or_else(|failure| panic!("{failure}"))
}

/// What a scene asks for, by the names of the command line.
fn asks(description: &LoadedScene) -> Vec<Effect> {
    let tables = scene_tables(description);
    let lens = description.camera.projection.has_lens();
    let set = EffectSet { depth_of_field: lens, ..tables.scene().unwrap().required_effects() };
    let planned: Vec<Effect> = plan(description).iter().map(|it| it.effect).collect();
    // The plan is what the tracer is asked for.
    assert_eq!(planned, Effect::ALL.into_iter().filter(|effect| effect.is_in(&set)).collect::<Vec<_>>());
    planned
}

/// What an effect is nothing without.
fn needs(effect: Effect) -> &'static [Effect] {
    match effect {
        Effect::ColoredShadows => &[Effect::Shadows, Effect::Transmission],
        Effect::Gloss => &[Effect::Reflection],
        _ => &[],
    }
}

/// Everything that is no effect in the sense of the command line.
const PLAIN: EffectSet = EffectSet {
    shapes: ShapeSet::ALL,
    smooth_shading: true,
    lights: LightSet::ALL,
    textures: TextureSet::ALL,
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
    Penumbra { penumbra }
    Lens { depth_of_field }
    Gloss { reflection, gloss }
    Motion { motion_blur }
}

/// The bits of a picture, four rays in each pixel.
fn seen_by<E: Effects>(description: &LoadedScene) -> Vec<u32> {
    let stock = scene_tables(description);
    let scene = stock.scene().unwrap();
    let world = World::new(scene, BareList(scene.descriptor().material_ids.len() as u32));
    let camera = Camera::new(&view(&description.camera), SIZE).unwrap();
    let tracer = Tracer::<_, E, 5>::new(&world, camera, Limits::DEFAULT).unwrap();
    let mut bits = Vec::new();
    let mut sink = |_, color: Rgb| bits.extend([color.r, color.g, color.b].map(f32::to_bits));
    let mut sampler = Stochastic::new(4).unwrap();
    let Ok(()) = render(
        &mut tracer.with_worker(&mut Worker::new(())),
        &mut sampler,
        Tile::whole(SIZE).pixels(),
        &mut sink,
    );
    bits
}

/// The pictures of a tracer.
type Seen = fn(&LoadedScene) -> Vec<u32>;

/// The tracer that can do an effect and what it needs, and the one that can do what it needs.
fn smallest(effect: Effect) -> [Seen; 2] {
    match effect {
        Effect::Shadows => [seen_by::<Shadows>, seen_by::<Nothing>],
        Effect::Reflection => [seen_by::<Reflection>, seen_by::<Nothing>],
        Effect::Transmission => [seen_by::<Transmission>, seen_by::<Nothing>],
        Effect::ColoredShadows => [seen_by::<ColoredShadows>, seen_by::<Solid>],
        Effect::Penumbra => [seen_by::<Penumbra>, seen_by::<Nothing>],
        Effect::Lens => [seen_by::<Lens>, seen_by::<Nothing>],
        Effect::Gloss => [seen_by::<Gloss>, seen_by::<Reflection>],
        Effect::Motion => [seen_by::<Motion>, seen_by::<Nothing>],
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
fn each_effect_has_a_scene_that_asks_for_exactly_this_one() {
    for effect in Effect::ALL {
        let mut want: Vec<Effect> = needs(effect).iter().copied().chain([effect]).collect();
        want.sort_by_key(|effect| *effect as u8);
        assert_eq!(asks(&scene(effect.name())), want, "{effect}");
    }
    assert_eq!(asks(&scene("nothing")), []);
    assert_eq!(asks(&scene("all")), Effect::ALL);
}

#[test]
fn what_a_scene_does_not_ask_for_sends_no_ray_and_takes_no_number_of_chance() {
    for name in Effect::ALL.map(Effect::name).into_iter().chain(["nothing"]) {
        let description = scene(name);
        let asks = asks(&description);
        let has = |effect| asks.contains(&effect);
        let (frame, counts) = counted(&description, 0);
        assert_eq!(counts.rays[RayKind::Camera], 4 * 48 * 36, "{name}");
        let reflects = has(Effect::Reflection);
        assert_eq!(counts.rays[RayKind::Reflected] > 0, reflects, "{name}");
        assert_eq!(counts.rays[RayKind::Transmitted] > 0, has(Effect::Transmission), "{name}");
        for happened in [counts.rays[RayKind::Shadow], counts.shape_tests[RayKind::Shadow]] {
            assert_eq!(happened > 0, has(Effect::Shadows), "{name}");
        }
        // Where light passes through glass the shadow cache is not asked.
        let caches = has(Effect::Shadows) && !has(Effect::ColoredShadows);
        assert_eq!(counts.shadow_cache_lookups > 0, caches, "{name}");
        // Of a raster's rays nothing is left to chance but by these.
        let by_chance = [Effect::Penumbra, Effect::Lens, Effect::Gloss, Effect::Motion].into_iter().any(has);
        assert_eq!(frame.picture != counted(&description, 1).0.picture, by_chance, "{name}");
    }
}

#[test]
fn a_tracer_for_one_effect_and_one_for_all_give_the_same_bytes() {
    for effect in Effect::ALL {
        let [with, without] = smallest(effect);
        let mut description = scene(effect.name());
        let all = seen_by::<AllEffects>(&description);
        assert!(with(&description) == all, "with {effect}");
        let steps = disable(&mut description, &[effect]);
        assert_eq!(steps.iter().map(|step| step.effect).collect::<Vec<_>>(), [effect]);
        let left = seen_by::<AllEffects>(&description);
        assert!(without(&description) == left, "without {effect}");
        assert!(left != all, "{effect} can be seen");
    }
    let plain = scene("nothing");
    assert!(seen_by::<Nothing>(&plain) == seen_by::<AllEffects>(&plain));
}
