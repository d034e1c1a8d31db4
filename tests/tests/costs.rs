//! Cost maps: independent of the number of threads, and the sum over all pixels is the cost of the picture.

use std::path::Path;

use strahl_core::Resolution;
use strahl_core::tally::{PerRayKind, RayKind};
use strahl_engine::cost_map::PixelCost;
use strahl_engine::{CostMap, NoProgress, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_scene::load;
use strahl_settings::{Precision, Settings};

const SIZE: Resolution = Resolution::new(50, 41).unwrap();

fn scene(name: &str) -> LoadedScene {
    load(&Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join("scenes").join(name)).unwrap()
}

fn costs(settings: &Settings) -> Vec<PixelCost> {
    let cost_map = CostMap::new(SIZE);
    let options = RenderOptions { cost_map: Some(&cost_map), ..RenderOptions::default() };
    strahl_session::render(&scene("glass.toml"), settings, &options, &NoProgress).unwrap();
    cost_map.costs()
}

fn settings() -> Settings {
    Settings { size: SIZE, ..Settings::default() }
}

#[test]
fn threads_do_not_change_the_cost_map() {
    let samplers = ["single", "regular:2", "adaptive:2:0.05", "stochastic:2..16:0.9:0.02"];
    let mut variants: Vec<Settings> =
        samplers.map(|it| Settings { sampler: it.parse().unwrap(), ..settings() }).to_vec();
    variants.push(Settings { select: Some("8:0.05".parse().unwrap()), ..settings() });
    for variant in variants {
        let by = |threads| costs(&Settings { threads, ..variant.clone() });
        assert!(by(1) == by(3), "{} {:?}", variant.sampler, variant.select);
    }
}

#[test]
fn with_one_sample_each_pixel_costs_a_camera_ray_and_its_descendants() {
    let costs = costs(&settings());
    assert!(costs.iter().all(|cost| cost.rays[0] == 1 && cost.level >= 1));
    let deep = costs.iter().filter(|cost| cost.level > 3).count();
    assert!(deep > 50 && deep < costs.len() / 2, "{deep}");
    // The level is at most the number of rays.
    assert!(costs.iter().all(|cost| cost.rays[..3].iter().sum::<u32>() >= cost.level.into()));
}

#[test]
fn the_sum_over_all_pixels_is_the_cost_of_the_picture() {
    let scene = scene("classic.toml");
    let size = Resolution::new(40, 30).unwrap();
    for (sampler, select, precision) in [
        ("single", None, Precision::Single),
        ("adaptive:2:0.1", None, Precision::Single),
        ("stochastic:3", Some("4:0.05"), Precision::Single),
        ("regular:2", None, Precision::Double),
    ] {
        let cost_map = CostMap::new(size);
        let settings = Settings {
            size,
            sampler: sampler.parse().unwrap(),
            select: select.map(|text: &str| text.parse().unwrap()),
            precision,
            ..Settings::default()
        };
        let options = RenderOptions { cost_map: Some(&cost_map), ..RenderOptions::default() };
        let output = strahl_session::render(&scene, &settings, &options, &NoProgress).unwrap();
        let (counts, costs) = (output.counters, cost_map.costs());
        for kind in RayKind::ALL {
            let sum = |of: fn(&PixelCost) -> [u32; RayKind::ALL.len()]| {
                costs.iter().map(|cost| u64::from(of(cost)[kind as usize])).sum::<u64>()
            };
            let sums = [sum(|it| it.rays), sum(|it| it.boxes), sum(|it| it.shapes), sum(|it| it.regions)];
            let total = |of: PerRayKind| of[kind];
            let totals = [counts.rays, counts.box_tests, counts.shape_tests, counts.leaf_visits].map(total);
            assert_eq!(sums, totals, "{sampler} {kind:?}");
        }
        assert_eq!(costs.iter().map(|cost| cost.level).max(), Some(counts.max_level), "{sampler}");
        assert!(counts.max_level > 2);
        let plain =
            strahl_session::render(&scene, &settings, &RenderOptions::default(), &NoProgress).unwrap();
        assert_eq!(plain.picture.digest(), output.picture.digest(), "{sampler}");
    }
}
