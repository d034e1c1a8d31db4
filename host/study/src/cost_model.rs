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
pub struct EventCounts {
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
pub struct EventWeights {
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
    pub list: TraversalWeights,
    /// The same.
    pub grid: TraversalWeights,
    /// The same.
    pub octree: TraversalWeights,
    /// The same.
    pub bvh: TraversalWeights,
}

/// What the steps of an accelerator take, in instructions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TraversalWeights {
    /// A test of a box.
    pub boxes: f64,
    /// A region entered.
    pub region: f64,
}

/// Measured on x86-64, over the pictures that `tests/examples/weights.rs` names.
pub const WEIGHTS: EventWeights = EventWeights {
    camera: 1227.0,
    secondary: 246.0,
    shadow: 629.0,
    shape: 193.0,
    skipped: 273.0,
    list: TraversalWeights { boxes: 64.0, region: 272.0 },
    grid: TraversalWeights { boxes: 107.0, region: 83.0 },
    octree: TraversalWeights { boxes: 98.0, region: 570.0 },
    bvh: TraversalWeights { boxes: 32.0, region: 378.0 },
};

/// As `study.json` has it.
pub fn event_counts(counts: &Counters) -> EventCounts {
    EventCounts {
        rays: RayKind::ALL.map(|kind| counts.rays[kind]),
        boxes: RayKind::ALL.map(|kind| counts.box_tests[kind]),
        shapes: RayKind::ALL.map(|kind| counts.shape_tests[kind]),
        regions: RayKind::ALL.map(|kind| counts.leaf_visits[kind]),
        skipped: RayKind::ALL.map(|kind| counts.mailbox_hits[kind]),
        cache_asked: counts.shadow_cache_lookups,
        cache_hits: counts.shadow_cache_hits,
    }
}

impl EventWeights {
    /// What the steps of an accelerator take, by the name of its kind.
    fn traversal(&self, kind: &str) -> TraversalWeights {
        match kind {
            "list" => self.list,
            "grid" => self.grid,
            "octree" => self.octree,
            _ => self.bvh,
        }
    }

    /// Instructions for each kind of ray (camera, reflected, transmitted, shadow), by a kind of
    /// accelerator.
    pub fn instructions_by_ray_kind(&self, counts: &EventCounts, kind: &str) -> [f64; 4] {
        let rays = [self.camera, self.secondary, self.secondary, self.shadow];
        let steps = self.traversal(kind);
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
    pub fn map_instructions(&self, costs: &CostMap, kind: AccelKind) -> f64 {
        costs.costs().iter().map(|cost| self.pixel_instructions(cost, kind)).sum()
    }

    /// The same for one pixel.
    pub fn pixel_instructions(&self, cost: &PixelCost, kind: AccelKind) -> f64 {
        let [rays, boxes, shapes, regions, skipped] =
            [cost.rays, cost.boxes, cost.shapes, cost.regions, cost.skipped]
                .map(|by_kind| by_kind.map(u64::from));
        self.instructions(
            &EventCounts { rays, boxes, shapes, regions, skipped, cache_asked: 0, cache_hits: 0 },
            kind.name(),
        )
    }

    /// Instructions in all.
    pub fn instructions(&self, counts: &EventCounts, kind: &str) -> f64 {
        self.instructions_by_ray_kind(counts, kind).iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_the_weighted_sum_of_the_counts() {
        let grid = TraversalWeights { boxes: 0.5, region: 3.0 };
        let none = TraversalWeights { boxes: 0.0, region: 0.0 };
        let weights = EventWeights {
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
        let counts = EventCounts {
            rays: [1, 2, 3, 4],
            boxes: [2, 0, 0, 2],
            shapes: [0, 5, 0, 0],
            regions: [0, 0, 1, 0],
            skipped: [4, 0, 0, 0],
            ..EventCounts::default()
        };
        assert_eq!(weights.instructions_by_ray_kind(&counts, "grid"), [3.0, 30.0, 33.0, 401.0]);
        assert_eq!(weights.instructions(&counts, "grid"), 467.0);
        assert_eq!(weights.instructions_by_ray_kind(&counts, "list"), [2.0, 30.0, 30.0, 400.0]);
    }
}
