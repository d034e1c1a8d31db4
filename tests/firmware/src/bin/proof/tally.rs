//! Counters, trace events and tallies.

use strahl_core::geometry::ShapeKind;
use strahl_core::tally::{
    CountedEvent, Counters, LightOutcome, PerRayKind, PerShapeKind, RayCounters, RayKind, RayOutcome, Tally,
    TraceEvent, UnsentRays,
};

use crate::any::{any, used};

pub fn entry_points() {
    RayKind::ALL.into_iter().for_each(used);
    used(RayKind::name(any(RayKind::Camera)));
    ().count(any(CountedEvent::MediumStackFull));
    ().trace_event(any(TraceEvent::TotalInternalReflection));
    used((any(RayOutcome::Sent), any(LightOutcome::NoEmission)));
    counters();
}

/// Tallies that count.
fn counters() {
    let mut counters = any(Counters::new());
    counters.count(any(CountedEvent::MediumStackFull));
    Counters::merge(&mut counters, &any(Counters::default()));
    let (kind, shape) = (any(RayKind::Camera), any(ShapeKind::Sphere));
    let (by_ray, by_shape): (PerRayKind, PerShapeKind) = (counters.rays, counters.shape_tests_by_kind);
    used((by_ray[kind], PerRayKind::sum(&by_ray), by_shape[shape], PerShapeKind::sum(&by_shape)));
    let mut unsent = any(counters.cutoff);
    UnsentRays::merge(&mut unsent, &any(counters.cutoff));
    used((UnsentRays::weight(&unsent), Counters::cut_fractions(&counters)));
    let mut rays = any(RayCounters::new());
    rays.count(any(CountedEvent::MediumStackFull));
    used(rays.counters);
}

/// Receives all events and discards them.
pub struct DiscardingTally;

impl Tally for DiscardingTally {
    fn count(&mut self, event: CountedEvent) {
        used(event);
    }

    fn trace_event(&mut self, step: TraceEvent) {
        used(step);
    }
}
