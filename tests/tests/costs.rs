//! What pixels cost is the same for any number of threads.

use std::path::Path;
use std::sync::Arc;

use strahl::cost_map::{CostMap, PixelCost};
use strahl::load::load;
use strahl::progress::NoProgress;
use strahl::render_request::RenderRequest;
use strahl::session;
use strahl_core::Size;
use strahl_settings::Settings;

const SIZE: Size = Size::new(50, 41).unwrap();

fn costs(settings: &Settings) -> Vec<PixelCost> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join("scenes/glass.toml");
    let cost_map = Arc::new(CostMap::new(SIZE));
    let cost_map_of = Some(Arc::clone(&cost_map));
    let request = RenderRequest { cost_map: cost_map_of, ..RenderRequest::new(settings.clone()) };
    session::render(&load(&path).unwrap(), &request, &NoProgress).unwrap();
    cost_map.costs()
}

#[test]
fn threads_change_no_pixels_cost() {
    let samplers = ["single", "regular:2", "adaptive:2:0.05", "stochastic:2..16:0.9:0.02"];
    let mut pictures: Vec<Settings> =
        samplers.map(|it| Settings { sampler: it.parse().unwrap(), ..Settings::of_size(SIZE) }).to_vec();
    pictures.push(Settings { select: Some("8:0.05".parse().unwrap()), ..Settings::of_size(SIZE) });
    for settings in pictures {
        let by = |threads| costs(&Settings { threads, ..settings.clone() });
        assert!(by(1) == by(3), "{} {:?}", settings.sampler, settings.select);
    }
}

#[test]
fn one_ray_in_each_pixel_costs_a_camera_ray_and_what_follows() {
    let costs = costs(&Settings::of_size(SIZE));
    assert!(costs.iter().all(|cost| cost.rays[0] == 1 && cost.level >= 1));
    let deep = costs.iter().filter(|cost| cost.level > 3).count();
    assert!(deep > 50 && deep < costs.len() / 2, "{deep}");
    // No deeper than there are rays.
    assert!(costs.iter().all(|cost| cost.rays[..3].iter().sum::<u32>() >= cost.level.into()));
}
