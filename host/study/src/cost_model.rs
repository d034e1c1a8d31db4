//! The work of a picture in instructions, from what was counted: the same on every machine.
//!
//! Time on a machine with other work is noise, and it is the time of that machine only. The
//! counts are the same everywhere and every time; each event is weighed with what it takes in the
//! mean. `tests/examples/weights.rs` measures the weights anew, under callgrind, over all scenes of
//! `scenes/` and the Standard Procedural Databases, and how well they fit (`tests/reports/weights.md`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use strahl_core::tally::{Counters, RayKind};
use strahl_engine::CostMap;
use strahl_engine::cost_map::PixelCost;
use strahl_settings::AccelKind;

/// What was counted; the lists are by kind of ray: camera, reflected, transmitted, shadow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Counts {
    /// Rays.
    pub rays: [u64; 4],
    /// Tests of boxes.
    pub boxes: [u64; 4],
    /// Tests of shapes.
    pub shapes: [u64; 4],
    /// Regions entered.
    pub regions: [u64; 4],
    /// Tests that mailboxes saved.
    pub skipped: [u64; 4],
    /// How often a shadow cache was asked.
    pub cache_asked: u64,
    /// How often it answered.
    pub cache_hits: u64,
}

/// What one event costs, in instructions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Weights {
    /// A camera ray, with what is done for its place in the picture.
    pub camera: f64,
    /// A reflected or transmitted ray.
    pub secondary: f64,
    /// A question to a light, with the light that comes of it.
    pub shadow: f64,
    /// A test of a shape.
    pub shape: f64,
    /// A test that a mailbox saved.
    pub skipped: f64,
    /// What the steps of each accelerator take.
    pub list: Steps,
    /// The same.
    pub grid: Steps,
    /// The same.
    pub octree: Steps,
    /// The same.
    pub bvh: Steps,
}

/// What the steps of an accelerator take, in instructions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Steps {
    /// A test of a box.
    pub boxes: f64,
    /// A region entered.
    pub region: f64,
}

/// Measured on x86-64, over the pictures that `tests/examples/weights.rs` names.
pub const WEIGHTS: Weights = Weights {
    camera: 1227.0,
    secondary: 246.0,
    shadow: 629.0,
    shape: 193.0,
    skipped: 273.0,
    list: Steps { boxes: 64.0, region: 272.0 },
    grid: Steps { boxes: 107.0, region: 83.0 },
    octree: Steps { boxes: 98.0, region: 570.0 },
    bvh: Steps { boxes: 32.0, region: 378.0 },
};

/// As `study.json` has it.
pub fn recorded(counts: &Counters) -> Counts {
    Counts {
        rays: RayKind::ALL.map(|kind| counts.rays[kind]),
        boxes: RayKind::ALL.map(|kind| counts.box_tests[kind]),
        shapes: RayKind::ALL.map(|kind| counts.shape_tests[kind]),
        regions: RayKind::ALL.map(|kind| counts.leaf_visits[kind]),
        skipped: RayKind::ALL.map(|kind| counts.mailbox_hits[kind]),
        cache_asked: counts.shadow_cache_lookups,
        cache_hits: counts.shadow_cache_hits,
    }
}

impl Weights {
    /// What the steps of an accelerator take, by the name of its kind.
    fn steps(&self, kind: &str) -> Steps {
        match kind {
            "list" => self.list,
            "grid" => self.grid,
            "octree" => self.octree,
            _ => self.bvh,
        }
    }

    /// Instructions for each kind of ray (camera, reflected, transmitted, shadow), by a kind of
    /// accelerator.
    pub fn by_ray(&self, counts: &Counts, kind: &str) -> [f64; 4] {
        let rays = [self.camera, self.secondary, self.secondary, self.shadow];
        let steps = self.steps(kind);
        std::array::from_fn(|ray| {
            let count = |of: &[u64; 4]| of[ray] as f64;
            rays[ray] * count(&counts.rays)
                + self.shape * count(&counts.shapes)
                + self.skipped * count(&counts.skipped)
                + steps.boxes * count(&counts.boxes)
                + steps.region * count(&counts.regions)
        })
    }

    /// About how many instructions the pixels of a cost map take on a workstation, by an accelerator of this kind.
    pub fn work_of_map(&self, costs: &CostMap, kind: AccelKind) -> f64 {
        costs.costs().iter().map(|cost| self.work_of_pixel(cost, kind)).sum()
    }

    /// The same for one pixel.
    pub fn work_of_pixel(&self, cost: &PixelCost, kind: AccelKind) -> f64 {
        let [rays, boxes, shapes, regions, skipped] =
            [cost.rays, cost.boxes, cost.shapes, cost.regions, cost.skipped]
                .map(|by_kind| by_kind.map(u64::from));
        self.work(
            &Counts { rays, boxes, shapes, regions, skipped, cache_asked: 0, cache_hits: 0 },
            kind.name(),
        )
    }

    /// Instructions in all.
    pub fn work(&self, counts: &Counts, kind: &str) -> f64 {
        self.by_ray(counts, kind).iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_the_weighted_sum_of_the_counts() {
        let grid = Steps { boxes: 0.5, region: 3.0 };
        let none = Steps { boxes: 0.0, region: 0.0 };
        let weights = Weights {
            camera: 1.0,
            secondary: 10.0,
            shadow: 100.0,
            shape: 2.0,
            skipped: 0.25,
            list: none,
            grid,
            octree: none,
            bvh: none,
        };
        let counts = Counts {
            rays: [1, 2, 3, 4],
            boxes: [2, 0, 0, 2],
            shapes: [0, 5, 0, 0],
            regions: [0, 0, 1, 0],
            skipped: [4, 0, 0, 0],
            ..Counts::default()
        };
        assert_eq!(weights.by_ray(&counts, "grid"), [3.0, 30.0, 33.0, 401.0]);
        assert_eq!(weights.work(&counts, "grid"), 467.0);
        assert_eq!(weights.by_ray(&counts, "list"), [2.0, 30.0, 30.0, 400.0]);
    }
}
