//! What happens while a picture is traced, and who hears of it.

use strahl_core::geometry::ShapeKind;
use strahl_core::tally::{
    Counters, Event, Fate, Lit, PerRayKind, PerShapeKind, RayCounters, RayKind, Step, Tally, UnsentRays,
};

use crate::any::{any, used};

pub fn doors() {
    RayKind::ALL.into_iter().for_each(used);
    used(RayKind::name(any(RayKind::Camera)));
    ().count(any(Event::MediaFull));
    ().tell(any(Step::ThrownBack));
    used((any(Fate::Sent), any(Lit::Dark)));
    counters();
}

/// Tallies that count.
fn counters() {
    let mut counters = any(Counters::new());
    counters.count(any(Event::MediaFull));
    Counters::add(&mut counters, &any(Counters::default()));
    let (kind, shape) = (any(RayKind::Camera), any(ShapeKind::Sphere));
    let (by_ray, by_shape): (PerRayKind, PerShapeKind) = (counters.rays, counters.by_shape);
    used((by_ray[kind], PerRayKind::sum(&by_ray), by_shape[shape], PerShapeKind::sum(&by_shape)));
    let mut unsent = any(counters.cutoff);
    UnsentRays::add(&mut unsent, &any(counters.cutoff));
    used((UnsentRays::weight(&unsent), Counters::cut(&counters)));
    let mut rays = any(RayCounters::new());
    rays.count(any(Event::MediaFull));
    used(rays.counters);
}

/// Hears of everything and remembers nothing.
pub struct Told;

impl Tally for Told {
    fn count(&mut self, event: Event) {
        used(event);
    }

    fn tell(&mut self, step: Step) {
        used(step);
    }
}
