//! `explain`: the ray tree of a pixel adds up to the pixel, bit for bit.

use std::path::{Path, PathBuf};

use serde_json::Value;
use strahl_core::image::Pixel;
use strahl_core::{Resolution, Rgb, Tile};
use strahl_engine::{NoProgress, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_scene::load;
use strahl_session::explain::pixel::{TracedPixel, trace_pixel};
use strahl_settings::{SamplerSettings, Settings, SettingsOverrides};

fn scene(name: &str) -> LoadedScene {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join("scenes").join(name);
    load(&path).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn settings(description: &LoadedScene, sampling: SamplerSettings) -> Settings {
    let given = SettingsOverrides {
        size: Resolution::new(40, 30),
        sampler: Some(sampling),
        ..SettingsOverrides::default()
    };
    Settings::resolve(&given, &description.settings).unwrap()
}

/// The pixel as `render` traces it.
fn rendered(description: &LoadedScene, settings: &Settings, pixel: Pixel) -> Rgb {
    let region = Some(Tile { top_left: pixel, width: 1, height: 1 });
    let settings = Settings { region, ..settings.clone() };
    let output =
        strahl_session::render(description, &settings, &RenderOptions::default(), &NoProgress).unwrap();
    output.picture.colors[0]
}

/// The channels of a color in JSON.
fn rgb(value: &Value) -> [f32; 3] {
    std::array::from_fn(|channel| value[channel].as_f64().unwrap() as f32)
}

fn added([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    [a + x, b + y, c + z]
}

fn times([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    [a * x, b * y, c * z]
}

/// Repeats every sum of one sample's tree from its printed numbers.
fn sample_of(sample: &Value) -> [f32; 3] {
    let rays = sample["rays"].as_array().unwrap();
    let mut sum = [0.0; 3];
    for ray in rays {
        let weight_there = if ray["hit"].is_null() {
            rgb(&ray["weight"])
        } else {
            times(rgb(&ray["weight"]), rgb(&ray["hit"]["left"]))
        };
        assert_eq!(weight_there, rgb(&ray["weight_there"]), "{ray}");
        if !ray["ambient"].is_null() {
            let lights = ray["lights"].as_array().unwrap().iter().filter(|light| !light["adds"].is_null());
            let light = lights.fold(rgb(&ray["ambient"]), |sum, light| added(sum, rgb(&light["adds"])));
            assert_eq!(light, rgb(&ray["light"]), "{ray}");
        }
        assert_eq!(times(weight_there, rgb(&ray["light"])), rgb(&ray["adds"]), "{ray}");
        for sent in ray["sends"].as_array().unwrap() {
            assert_eq!(times(weight_there, rgb(&sent["share"])), rgb(&sent["weight"]), "{ray}");
            // A ray is traced, or the reason why not is given.
            assert_ne!(sent["ray"].is_null(), sent["cut"].is_null(), "{ray}");
            if let Some(number) = sent["ray"].as_u64() {
                let child = &rays[number as usize - 1];
                assert_eq!((&child["number"], &child["parent"]), (&sent["ray"], &ray["number"]));
                assert_eq!(rgb(&child["weight"]), rgb(&sent["weight"]));
                assert_eq!(child["level"].as_u64(), ray["level"].as_u64().map(|level| level + 1));
            }
        }
        sum = added(sum, rgb(&ray["adds"]));
    }
    assert_eq!(sum, rgb(&sample["color"]));
    sum
}

/// Repeats the sum of the samples.
fn pixel_of(sum: &Value, samples: &Value) -> [f32; 3] {
    let samples: Vec<_> = samples.as_array().unwrap().iter().map(sample_of).collect();
    if let Some(parts) = sum["parts"].as_array() {
        parts.iter().fold([0.0; 3], |sum, part| {
            let corner = |i: usize| samples[part["samples"][i].as_u64().unwrap() as usize - 1];
            let side = part["side"].as_f64().unwrap() as f32;
            let mean = times(added(added(corner(0), corner(1)), added(corner(2), corner(3))), [0.25; 3]);
            added(sum, times(mean, [side * side; 3]))
        })
    } else {
        let weight = sum["mean"]["share"].as_f64().unwrap() as f32;
        times(samples.into_iter().fold([0.0; 3], added), [weight; 3])
    }
}

fn bits(color: [f32; 3]) -> [u32; 3] {
    color.map(f32::to_bits)
}

/// Compares some pixels of a scene. Returns the numbers of traced and of discarded rays.
fn assert_tree_sums_to_pixel(name: &str, sampler: &str) -> (usize, usize) {
    let description = scene(name);
    let settings = settings(&description, sampler.parse().unwrap());
    let (mut rays, mut cut) = (0, 0);
    for (x, y) in [(0, 0), (39, 29), (20, 15), (13, 18), (27, 12), (9, 22), (31, 21), (22, 24)] {
        let pixel = Pixel { x, y };
        let TracedPixel { color, sum, samples } = trace_pixel(&description, &settings, pixel).unwrap();
        let expected = rendered(&description, &settings, pixel);
        let [expected, color] = [expected, color].map(|c| [c.r, c.g, c.b]);
        assert_eq!(bits(color), bits(expected), "{name} {sampler} {pixel:?}");

        // The printed numbers.
        let text = serde_json::to_string(&(&sum, &samples)).unwrap();
        let printed: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(bits(pixel_of(&printed[0], &printed[1])), bits(expected), "{name} {sampler} {pixel:?}");
        for ray in samples.iter().flat_map(|sample| &sample.rays) {
            rays += 1;
            cut += ray.sends.iter().filter(|sent| sent.cut.is_some()).count();
        }
    }
    (rays, cut)
}

#[test]
fn the_tree_of_one_sample_adds_up_to_the_pixel() {
    let (mut rays, mut cut) = (0, 0);
    for name in [
        "classic.toml",
        "glass.toml",
        "marbles.toml",
        "stained.toml",
        "still-life.toml",
        "gloss.toml",
        "rotunda.nff",
        "knot.toml",
        "sphereflake.toml",
    ] {
        let (more, more_cut) = assert_tree_sums_to_pixel(name, "single");
        rays += more;
        cut += more_cut;
    }
    // Trees with more than one ray, and some discarded branches.
    assert!(rays > 150 && cut > 15, "{rays} rays, {cut} cut");
}

#[test]
fn the_trees_of_many_samples_add_up_to_the_pixel() {
    for (name, sampler) in [
        ("glass.toml", "regular:3"),
        ("penumbra.toml", "stochastic:5"),
        ("lens.toml", "stochastic:2..40:0.9:0.01"),
        ("classic.toml", "adaptive:0:0"),
        ("glass.toml", "adaptive:3:0.02"),
    ] {
        assert_tree_sums_to_pixel(name, sampler);
    }
}

#[test]
fn an_occluded_light_has_an_occluder() {
    let description = scene("classic.toml");
    let settings = settings(&description, SamplerSettings::Single);
    let mut outcomes = std::collections::BTreeMap::new();
    for y in 0..30 {
        for x in 0..40 {
            let TracedPixel { samples, .. } = trace_pixel(&description, &settings, Pixel { x, y }).unwrap();
            for light in samples.iter().flat_map(|sample| &sample.rays).flat_map(|ray| &ray.lights) {
                *outcomes.entry(light.outcome).or_insert(0) += 1;
                assert_eq!(light.occluder.is_some(), light.outcome == "blocked");
                if let Some(occluder) = &light.occluder {
                    assert!(occluder.distance > 0.0 && occluder.item.line > 0);
                }
            }
        }
    }
    assert!(outcomes["seen"] > 100 && outcomes["blocked"] > 20 && outcomes["behind"] > 20, "{outcomes:?}");
}
