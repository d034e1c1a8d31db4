//! Tallies that count.

use strahl_core::*;

use crate::any::{any, used};

pub fn doors() {
    let mut counters = any(Counters::new());
    counters.count(any(Event::MediaFull));
    counters.add(&any(Counters::default()));
    let (kind, shape) = (any(RayKind::Camera), any(ShapeKind::Sphere));
    used((counters.rays(kind), counters.camera_hits(), counters.boxes(kind), counters.shapes(kind)));
    used((
        counters.regions(kind),
        counters.skipped(kind),
        counters.shadow_cache_asked(),
        counters.shadow_cache_hits(),
        counters.by_shape(shape),
        counters.media_full(),
        counters.level_limit_weight(),
        counters.cutoff_weight(),
    ));
    used((counters.level_limit(), counters.cutoff(), counters.deepest()));
    let mut rays = any(RayCounters::new());
    rays.count(any(Event::MediaFull));
    used(rays.counters());
}
