//! What pixels cost is the same for any number of threads.

use std::path::Path;
use std::sync::Arc;

use strahl::cost_map::{CostMap, PixelCost};
use strahl::load::load;
use strahl::progress::NoProgress;
use strahl::session;
use strahl::wanted::{Cut, Wanted};
use strahl_core::Size;

const SIZE: Size = Size::new(50, 41).unwrap();

fn costs(wanted: &Wanted) -> Vec<PixelCost> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join("scenes/glass.toml");
    let cost_map = Arc::new(CostMap::new(SIZE));
    let wanted = Wanted { cost_map: Some(Arc::clone(&cost_map)), ..wanted.clone() };
    session::render(&load(&path).unwrap(), &wanted, &NoProgress).unwrap();
    cost_map.costs()
}

#[test]
fn threads_change_no_pixels_cost() {
    let samplers = ["single", "regular:2", "adaptive:2:0.05", "stochastic:2..16:0.9:0.02"];
    let mut pictures: Vec<Wanted> =
        samplers.map(|it| Wanted { sampling: it.parse().unwrap(), ..Wanted::of(SIZE) }).to_vec();
    pictures.push(Wanted { selecting: Some("8:0.05".parse().unwrap()), ..Wanted::of(SIZE) });
    for wanted in pictures {
        let by = |threads| costs(&Wanted { cut: Cut::threads(threads), ..wanted.clone() });
        assert!(by(1) == by(3), "{} {:?}", wanted.sampling, wanted.selecting);
    }
}

#[test]
fn one_ray_in_each_pixel_costs_a_camera_ray_and_what_follows() {
    let costs = costs(&Wanted::of(SIZE));
    assert!(costs.iter().all(|cost| cost.rays[0] == 1 && cost.level >= 1));
    let deep = costs.iter().filter(|cost| cost.level > 3).count();
    assert!(deep > 50 && deep < costs.len() / 2, "{deep}");
    // No deeper than there are rays.
    assert!(costs.iter().all(|cost| cost.rays[..3].iter().sum::<u32>() >= cost.level.into()));
}
