//! Threads, tiles, accelerators and counters change no bit of a picture.

use strahl_core::image::Pixel;
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{Resolution, Rgb, Tile};
use strahl_engine::{Mask, NoProgress, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_session::RenderOutput;
use strahl_settings::{AccelKind, AccelSettings, Bounds, Settings};

/// Every sampler and pixel selection, as command-line text, and whether the number of rays depends on the
/// tiles, because neighboring pixels of a tile share samples.
const SAMPLINGS: [(&str, Option<&str>, bool); 9] = [
    ("single", None, false),
    ("regular:2", None, false),
    ("adaptive:0:0", None, false),
    ("adaptive:3:0.1", None, true),
    ("adaptive:2:0.1:items", None, true),
    ("stochastic:4", None, false),
    ("stochastic:2..8:0.9", None, false),
    ("single", Some("8:0.1"), true),
    ("adaptive:1:0.1", Some("4:0.05:items"), true),
];

// Neither side is a multiple of a tile.
const SIZE: Resolution = Resolution::new(61, 37).unwrap();

fn loaded(name: &str) -> LoadedScene {
    strahl_scene::load(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

/// Many objects, and no distributed effects.
fn scene() -> LoadedScene {
    loaded("../scenes/rotunda.nff")
}

/// Every effect.
fn effects() -> LoadedScene {
    loaded("tests/effects/all.toml")
}

fn both() -> [LoadedScene; 2] {
    [scene(), effects()]
}

fn settings((sampler, select, _): (&str, Option<&str>, bool)) -> Settings {
    let select = select.map(|words| words.parse().unwrap());
    Settings { size: SIZE, sampler: sampler.parse().unwrap(), select, ..Settings::default() }
}

fn rendered(scene: &LoadedScene, settings: &Settings) -> RenderOutput {
    rendered_with(scene, settings, RenderOptions::COUNT_TESTS)
}

fn rendered_with(scene: &LoadedScene, settings: &Settings, options: RenderOptions<'_>) -> RenderOutput {
    strahl_session::render(scene, settings, &options, &NoProgress).unwrap()
}

#[test]
fn threads_change_neither_picture_nor_counts() {
    for (scene, sampling) in both().iter().flat_map(|scene| SAMPLINGS.map(|sampling| (scene, sampling))) {
        let one = rendered(scene, &Settings { threads: 1, ..settings(sampling) });
        for threads in [2, 7] {
            let many = rendered(scene, &Settings { threads, ..settings(sampling) });
            assert_eq!(many.picture, one.picture, "{sampling:?}, {threads} threads");
            assert_eq!(many.counters, one.counters, "{sampling:?}, {threads} threads");
        }
    }
}

#[test]
fn tiles_do_not_change_the_picture() {
    for (scene, sampling) in both().iter().flat_map(|scene| SAMPLINGS.map(|sampling| (scene, sampling))) {
        // The hits of a cache depend on the rays before in the same tile.
        let by = |threads, tile_side| {
            let settings = Settings { shadow_cache: false, threads, ..settings(sampling) };
            rendered_with(scene, &settings, RenderOptions { tile_side, ..RenderOptions::COUNT_TESTS })
        };
        let whole = by(1, 1000);
        for tile in [1, 5, 32] {
            let tiled = by(2, tile);
            assert_eq!(tiled.picture, whole.picture, "{sampling:?}, tiles of {tile}");
            if !sampling.2 {
                assert_eq!(tiled.counters, whole.counters, "{sampling:?}, tiles of {tile}");
            }
        }
    }
}

#[test]
fn a_region_equals_that_part_of_the_whole_picture() {
    for (scene, sampling) in both().iter().flat_map(|scene| SAMPLINGS.map(|sampling| (scene, sampling))) {
        let whole = rendered(scene, &settings(sampling)).picture;
        for (x, y, width, height) in [(0, 0, 61, 37), (7, 11, 30, 13), (60, 36, 1, 1)] {
            let region = Tile { top_left: Pixel { x, y }, width, height };
            let part = rendered(scene, &Settings { region: Some(region), ..settings(sampling) }).picture;
            assert_eq!((part.size.width(), part.size.height()), (width, height));
            for (color, pixel) in part.colors.iter().zip(region.pixels()) {
                let index = Tile::full(SIZE).index_of(pixel).unwrap();
                assert_eq!(*color, whole.colors[index], "{sampling:?}, {pixel:?} of {region:?}");
            }
        }
    }
}

#[test]
fn the_pixels_of_a_mask_are_unchanged_and_the_others_cost_nothing() {
    let scene = scene();
    for sampling in SAMPLINGS {
        let all = rendered(&scene, &settings(sampling));
        // A ring.
        let is_white =
            |Pixel { x, y }: Pixel| (100..300).contains(&((x as i32 - 30).pow(2) + (y as i32 - 18).pow(2)));
        let pixels: Vec<bool> = Tile::full(SIZE).pixels().map(is_white).collect();
        let mask = Mask { size: SIZE, pixels: pixels.clone() };
        let options = RenderOptions { mask: Some(&mask), ..RenderOptions::COUNT_TESTS };
        let some = rendered_with(&scene, &settings(sampling), options);
        for ((some, all), is_white) in some.picture.colors.iter().zip(&all.picture.colors).zip(&pixels) {
            assert_eq!(*some, if *is_white { *all } else { Rgb::BLACK }, "{sampling:?}");
        }
        let rays = |frame: &RenderOutput| frame.counters.rays[RayKind::Camera];
        let max_fraction = match sampling.1 {
            None => 0.45, // slightly more than the fraction of the ring, because fewer corners are shared
            Some(_) => 0.9,
        };
        assert!(
            (rays(&some) as f64) < max_fraction * rays(&all) as f64,
            "{sampling:?}: {} of {}",
            rays(&some),
            rays(&all)
        );
    }
}

#[test]
fn accelerators_do_not_change_the_picture() {
    let scene = effects();
    for sampling in SAMPLINGS {
        let by = |accel| rendered(&scene, &settings(sampling).with_acceleration(accel)).picture;
        let expected =
            by(AccelSettings { bounds: Bounds::None, ..AccelSettings::with_kind(AccelKind::List) });
        assert!(expected.colors.iter().all(|color| color.is_in_range(f32::MAX)), "{sampling:?}");
        for accel in AccelKind::ALL.map(AccelSettings::with_kind) {
            assert_eq!(by(accel), expected, "{sampling:?}, {accel:?}");
        }
    }
    // With every mailbox, heap and stack.
    let expected = rendered(&scene, &settings(SAMPLINGS[0])).picture;
    for accel in AccelSettings::all_variants() {
        let picture = rendered(&scene, &settings(SAMPLINGS[0]).with_acceleration(accel)).picture;
        assert_eq!(picture, expected, "{accel:?}");
    }
}

#[test]
fn seeds_change_stochastic_samplers_only() {
    let scene = scene();
    for sampling in SAMPLINGS {
        let (one, other) = (
            rendered(&scene, &settings(sampling)),
            rendered(&scene, &Settings { seed: 1, ..settings(sampling) }),
        );
        assert_eq!(one.picture != other.picture, sampling.0.starts_with("stochastic"), "{sampling:?}");
    }
}

#[test]
fn counting_changes_nothing() {
    let scene = scene();
    let counted = rendered(&scene, &settings(SAMPLINGS[0]));
    let uncounted = rendered_with(&scene, &settings(SAMPLINGS[0]), RenderOptions::default());
    assert_eq!(counted.picture, uncounted.picture);
    let [all, rays_only] = [counted, uncounted].map(|frame| frame.counters);
    let tests = |counts: &Counters| RayKind::ALL.map(|kind| counts.shape_tests[kind]);
    assert!(tests(&all).iter().all(|count| *count > 0) && tests(&rays_only) == [0; 4]);
    // Rays, and those that are discarded, are always counted.
    let rays = |counts: &Counters| (RayKind::ALL.map(|kind| counts.rays[kind]), counts.cut_fractions());
    assert_eq!(rays(&all), rays(&rays_only));
    assert_eq!((all.camera_hits, all.max_level), (rays_only.camera_hits, rays_only.max_level));
}

#[test]
fn a_digest_depends_on_every_bit() {
    let mut picture = rendered(&scene(), &settings(SAMPLINGS[0])).picture;
    let digest = picture.digest();
    assert_eq!(picture.clone().digest(), digest);
    picture.colors[100].g = picture.colors[100].g.next_up();
    assert_ne!(picture.digest(), digest);
}

#[test]
fn a_shadow_cache_saves_tests_and_changes_no_bit() {
    let scene = scene();
    let with = rendered(&scene, &settings(SAMPLINGS[0]));
    let without = rendered(&scene, &Settings { shadow_cache: false, ..settings(SAMPLINGS[0]) });
    assert_eq!(with.picture, without.picture);
    let [with, without] = [with, without].map(|frame| frame.counters);
    assert_eq!((without.shadow_cache_tests, without.shadow_cache_hits), (0, 0));
    let (tests, hits) = (with.shadow_cache_tests, with.shadow_cache_hits);
    // At this resolution neighboring pixels often have different occluders.
    assert!(tests > hits && 3 * hits > tests, "{hits} of {tests}");
    let boxes = |counts: &Counters| counts.box_tests[RayKind::Shadow];
    assert!(boxes(&with) < boxes(&without), "{} of {}", boxes(&with), boxes(&without));
}
