//! Counts the cost of each camera ray and its ray tree, and adds it to a cost map.

use strahl_core::scene::CameraSample;
use strahl_core::tally::{Counters, PerRayKind, RayKind};
use strahl_core::trace::{PixelSample, RayTracer};

use crate::cost_map::{CostMap, PixelCost};
use crate::progress::Progress;
use crate::ray_tracer::{CountingRayTracer, RayTracerFactory};

/// Creates ray tracers that add their counts to a cost map.
pub struct CostCounting<'c> {
    /// The factory of the underlying ray tracers.
    pub ray_tracers: &'c dyn RayTracerFactory,
    /// The cost map.
    pub cost_map: &'c CostMap,
}

impl RayTracerFactory for CostCounting<'_> {
    fn ray_tracer<'t>(&'t self, progress: &'t dyn Progress) -> Box<dyn CountingRayTracer + 't> {
        let ray_tracer = self.ray_tracers.ray_tracer(progress);
        Box::new(CostCountingRayTracer { ray_tracer, cost_map: self.cost_map, sum: Counters::default() })
    }
}

struct CostCountingRayTracer<'c> {
    ray_tracer: Box<dyn CountingRayTracer + 'c>,
    cost_map: &'c CostMap,
    sum: Counters,
}

impl RayTracer for CostCountingRayTracer<'_> {
    fn trace(&mut self, sample: CameraSample) -> PixelSample {
        let result = self.ray_tracer.trace(sample);
        let counters = self.ray_tracer.take_counters();
        let count = |counts: PerRayKind| RayKind::ALL.map(|kind| counts[kind] as u32);
        let cost = PixelCost {
            rays: count(counters.rays),
            boxes: count(counters.box_tests),
            shapes: count(counters.shape_tests),
            regions: count(counters.leaf_visits),
            skipped: count(counters.mailbox_hits),
            level: counters.max_level,
        };
        #[allow(clippy::useless_conversion)] // in double precision
        self.cost_map.add(sample.point.x.into(), sample.point.y.into(), &cost);
        self.sum.merge(&counters);
        result
    }
}

impl CountingRayTracer for CostCountingRayTracer<'_> {
    fn take_counters(&mut self) -> Counters {
        std::mem::take(&mut self.sum)
    }
}
