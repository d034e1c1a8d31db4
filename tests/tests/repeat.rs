//! Memory and order buy time, never truth: threads, tiles and tallies change no bit.

use strahl_core::image::Pixel;
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{Resolution, Rgb, Tile};
use strahl_engine::{Mask, NoProgress, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_session::RenderOutput;
use strahl_settings::{AccelKind, AccelSettings, Bounds, Settings};

/// Every sampler and pixel-selected tracing in the words of the command line, and whether its
/// tiles share anything but what is traced before them: then the number of rays depends on the
/// tiles.
const WAYS: [(&str, Option<&str>, bool); 9] = [
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

// Neither side a multiple of a tile.
const SIZE: Resolution = Resolution::new(61, 37).unwrap();

fn loaded(name: &str) -> LoadedScene {
    strahl_scene::load(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

/// Many objects, and nothing that is left to chance.
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
    for (scene, way) in both().iter().flat_map(|scene| WAYS.map(|way| (scene, way))) {
        let one = rendered(scene, &Settings { threads: 1, ..settings(way) });
        for threads in [2, 7] {
            let many = rendered(scene, &Settings { threads, ..settings(way) });
            assert_eq!(many.picture, one.picture, "{way:?}, {threads} threads");
            assert_eq!(many.counters, one.counters, "{way:?}, {threads} threads");
        }
    }
}

#[test]
fn tiles_do_not_change_the_picture() {
    for (scene, way) in both().iter().flat_map(|scene| WAYS.map(|way| (scene, way))) {
        // What a cache saves depends on what was traced before it in the same tile.
        let by = |threads, tile_side| {
            let settings = Settings { shadow_cache: false, threads, ..settings(way) };
            rendered_with(scene, &settings, RenderOptions { tile_side, ..RenderOptions::COUNT_TESTS })
        };
        let whole = by(1, 1000);
        for tile in [1, 5, 32] {
            let cut = by(2, tile);
            assert_eq!(cut.picture, whole.picture, "{way:?}, tiles of {tile}");
            if !way.2 {
                assert_eq!(cut.counters, whole.counters, "{way:?}, tiles of {tile}");
            }
        }
    }
}

#[test]
fn a_region_is_the_same_as_in_the_whole_picture() {
    for (scene, way) in both().iter().flat_map(|scene| WAYS.map(|way| (scene, way))) {
        let whole = rendered(scene, &settings(way)).picture;
        for (x, y, width, height) in [(0, 0, 61, 37), (7, 11, 30, 13), (60, 36, 1, 1)] {
            let region = Tile { first: Pixel { x, y }, width, height };
            let part = rendered(scene, &Settings { region: Some(region), ..settings(way) }).picture;
            assert_eq!((part.size.width(), part.size.height()), (width, height));
            for (color, pixel) in part.colors.iter().zip(region.pixels()) {
                let place = Tile::whole(SIZE).place(pixel).unwrap();
                assert_eq!(*color, whole.colors[place], "{way:?}, {pixel:?} of {region:?}");
            }
        }
    }
}

#[test]
fn the_pixels_of_a_mask_are_the_same_and_the_others_cost_nothing() {
    let scene = scene();
    for way in WAYS {
        let all = rendered(&scene, &settings(way));
        // A ring.
        let is_white =
            |Pixel { x, y }: Pixel| (100..300).contains(&((x as i32 - 30).pow(2) + (y as i32 - 18).pow(2)));
        let pixels: Vec<bool> = Tile::whole(SIZE).pixels().map(is_white).collect();
        let mask = Mask { size: SIZE, pixels: pixels.clone() };
        let options = RenderOptions { mask: Some(&mask), ..RenderOptions::COUNT_TESTS };
        let some = rendered_with(&scene, &settings(way), options);
        for ((some, all), is_white) in some.picture.colors.iter().zip(&all.picture.colors).zip(&pixels) {
            assert_eq!(*some, if *is_white { *all } else { Rgb::BLACK }, "{way:?}");
        }
        let rays = |frame: &RenderOutput| frame.counters.rays[RayKind::Camera];
        let most = match way.1 {
            None => 0.45, // a little more than the share of the ring, for corners that are not shared
            Some(_) => 0.9,
        };
        assert!(
            (rays(&some) as f64) < most * rays(&all) as f64,
            "{way:?}: {} of {}",
            rays(&some),
            rays(&all)
        );
    }
}

#[test]
fn accelerators_do_not_change_the_picture() {
    let scene = effects();
    for way in WAYS {
        let by = |accel| rendered(&scene, &settings(way).with_acceleration(accel)).picture;
        let truth = by(AccelSettings { bounds: Bounds::None, ..AccelSettings::with_kind(AccelKind::List) });
        assert!(truth.colors.iter().all(|color| color.is_in_range(f32::MAX)), "{way:?}");
        for accel in AccelKind::ALL.map(AccelSettings::with_kind) {
            assert_eq!(by(accel), truth, "{way:?}, {accel:?}");
        }
    }
    // With every mailbox, heap and stack.
    let truth = rendered(&scene, &settings(WAYS[0])).picture;
    for accel in AccelSettings::all_variants() {
        let picture = rendered(&scene, &settings(WAYS[0]).with_acceleration(accel)).picture;
        assert_eq!(picture, truth, "{accel:?}");
    }
}

#[test]
fn seeds_change_what_is_left_to_chance_and_nothing_else() {
    let scene = scene();
    for way in WAYS {
        let (one, other) =
            (rendered(&scene, &settings(way)), rendered(&scene, &Settings { seed: 1, ..settings(way) }));
        assert_eq!(one.picture != other.picture, way.0.starts_with("stochastic"), "{way:?}");
    }
}

#[test]
fn counting_changes_nothing() {
    let scene = scene();
    let counted = rendered(&scene, &settings(WAYS[0]));
    let silent = rendered_with(&scene, &settings(WAYS[0]), RenderOptions::default());
    assert_eq!(counted.picture, silent.picture);
    let [all, few] = [counted, silent].map(|frame| frame.counters);
    let tests = |counts: &Counters| RayKind::ALL.map(|kind| counts.shape_tests[kind]);
    assert!(tests(&all).iter().all(|count| *count > 0) && tests(&few) == [0; 4]);
    // Rays and what was cut are counted either way.
    let rays = |counts: &Counters| (RayKind::ALL.map(|kind| counts.rays[kind]), counts.cut_fractions());
    assert_eq!(rays(&all), rays(&few));
    assert_eq!((all.camera_hits, all.max_level), (few.camera_hits, few.max_level));
}

#[test]
fn a_digest_tells_pictures_apart_by_one_bit() {
    let mut picture = rendered(&scene(), &settings(WAYS[0])).picture;
    let digest = picture.digest();
    assert_eq!(picture.clone().digest(), digest);
    picture.colors[100].g = picture.colors[100].g.next_up();
    assert_ne!(picture.digest(), digest);
}

#[test]
fn a_shadow_cache_answers_often_and_changes_no_bit() {
    let scene = scene();
    let with = rendered(&scene, &settings(WAYS[0]));
    let without = rendered(&scene, &Settings { shadow_cache: false, ..settings(WAYS[0]) });
    assert_eq!(with.picture, without.picture);
    let [with, without] = [with, without].map(|frame| frame.counters);
    assert_eq!((without.shadow_cache_lookups, without.shadow_cache_hits), (0, 0));
    let (asked, hits) = (with.shadow_cache_lookups, with.shadow_cache_hits);
    // Of pixels this large, neighbours often lie in the shadows of different things.
    assert!(asked > hits && 3 * hits > asked, "{hits} of {asked}");
    let boxes = |counts: &Counters| counts.box_tests[RayKind::Shadow];
    assert!(boxes(&with) < boxes(&without), "{} of {}", boxes(&with), boxes(&without));
}
