//! Cost model: the work of a picture in instructions, computed from event counts.
//!
//! Measured time depends on the machine and its load. Event counts are the same on every machine and in every run; each
//! event is weighted with its mean number of instructions. `tests/examples/weights.rs` measures the weights with callgrind
//! over all scenes of `scenes/` and the Standard Procedural Databases; `tests/reports/weights.md` has their accuracy.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use strahl_core::tally::{Counters, RayKind};
use strahl_engine::CostMap;
use strahl_engine::cost_map::PixelCost;
use strahl_settings::AccelKind;

/// Event counts; arrays are indexed by ray kind: camera, reflected, transmitted, shadow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EventCounts {
    /// Rays.
    pub rays: [u64; 4],
    /// Box tests.
    pub boxes: [u64; 4],
    /// Shape tests.
    pub shapes: [u64; 4],
    /// Visits of leaves and cells.
    pub regions: [u64; 4],
    /// Tests avoided by mailboxes.
    pub skipped: [u64; 4],
    /// Shadow cache queries.
    pub cache_asked: u64,
    /// Shadow cache hits.
    pub cache_hits: u64,
}

/// Mean number of instructions per event.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EventWeights {
    /// A camera ray, including its sample position.
    pub camera: f64,
    /// A reflected or transmitted ray.
    pub secondary: f64,
    /// A shadow ray, including the lighting.
    pub shadow: f64,
    /// A shape test.
    pub shape: f64,
    /// A test avoided by a mailbox.
    pub skipped: f64,
    /// Traversal of the list.
    pub list: TraversalWeights,
    /// Traversal of the grid.
    pub grid: TraversalWeights,
    /// Traversal of the octree.
    pub octree: TraversalWeights,
    /// Traversal of the BVH.
    pub bvh: TraversalWeights,
}

/// Mean number of instructions per traversal step of an accelerator.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TraversalWeights {
    /// A box test.
    pub boxes: f64,
    /// A visit of a leaf or cell.
    pub region: f64,
}

/// Weights measured on x86-64 by `tests/examples/weights.rs`.
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

/// The counts as in `study.json`.
pub fn event_counts(counts: &Counters) -> EventCounts {
    EventCounts {
        rays: RayKind::ALL.map(|kind| counts.rays[kind]),
        boxes: RayKind::ALL.map(|kind| counts.box_tests[kind]),
        shapes: RayKind::ALL.map(|kind| counts.shape_tests[kind]),
        regions: RayKind::ALL.map(|kind| counts.leaf_visits[kind]),
        skipped: RayKind::ALL.map(|kind| counts.mailbox_hits[kind]),
        cache_asked: counts.shadow_cache_tests,
        cache_hits: counts.shadow_cache_hits,
    }
}

impl EventWeights {
    /// The traversal weights of an accelerator, by the name of its kind.
    fn traversal(&self, kind: &str) -> TraversalWeights {
        match kind {
            "list" => self.list,
            "grid" => self.grid,
            "octree" => self.octree,
            _ => self.bvh,
        }
    }

    /// Instructions by ray kind (camera, reflected, transmitted, shadow), for a kind of accelerator.
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

    /// Estimated instructions of all pixels of a cost map, for a kind of accelerator.
    pub fn map_instructions(&self, costs: &CostMap, kind: AccelKind) -> f64 {
        costs.costs().iter().map(|cost| self.pixel_instructions(cost, kind)).sum()
    }

    /// Estimated instructions of one pixel.
    pub fn pixel_instructions(&self, cost: &PixelCost, kind: AccelKind) -> f64 {
        let [rays, boxes, shapes, regions, skipped] =
            [cost.rays, cost.boxes, cost.shapes, cost.regions, cost.skipped]
                .map(|by_kind| by_kind.map(u64::from));
        self.instructions(
            &EventCounts { rays, boxes, shapes, regions, skipped, cache_asked: 0, cache_hits: 0 },
            kind.name(),
        )
    }

    /// Total instructions.
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
