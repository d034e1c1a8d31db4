//! [`Counters`] and [`RayCounters`] as tallies.

use super::{CountedEvent, Counters, RayCounters, Tally, UnsentRays};
use crate::math::{Real, Rgb};

/// Adds an unsent ray of this weight. Not inlined, to keep the loop of a tracer small.
#[inline(never)]
fn add_unsent(unsent: &mut UnsentRays, weight: Rgb) {
    let weight_units = ((weight.r + weight.g + weight.b) * (UnsentRays::WEIGHT_ONE as Real / 3.0)) as u64;
    unsent.merge(&UnsentRays { rays: 1, weight_units });
}

impl Tally for Counters {
    /// Inlined: the event is known where it is counted, and one addition remains.
    #[inline(always)]
    fn count(&mut self, event: CountedEvent) {
        match event {
            CountedEvent::Ray(kind) => self.rays[kind] += 1,
            CountedEvent::Level(level) => self.max_level = self.max_level.max(level),
            CountedEvent::CameraHit => self.camera_hits += 1,
            CountedEvent::BoxTests(kind, count) => self.box_tests[kind] += u64::from(count),
            CountedEvent::ShapeTest(kind, shape) => {
                self.shape_tests[kind] += 1;
                self.shape_tests_by_kind[shape] += 1;
            }
            CountedEvent::LeafVisit(kind) => self.leaf_visits[kind] += 1,
            CountedEvent::MailboxHit(kind) => self.mailbox_hits[kind] += 1,
            CountedEvent::ShadowCacheTest { occluded } => {
                self.shadow_cache_tests += 1;
                self.shadow_cache_hits += u64::from(occluded);
            }
            CountedEvent::LevelLimit(weight) => add_unsent(&mut self.level_limit, weight),
            CountedEvent::Cutoff(weight) => add_unsent(&mut self.cutoff, weight),
            CountedEvent::MediumStackFull => self.medium_stack_full += 1,
        }
    }
}

impl Tally for RayCounters {
    const COUNTS_TESTS: bool = false;

    #[inline(always)]
    fn count(&mut self, event: CountedEvent) {
        match event {
            CountedEvent::Ray(_)
            | CountedEvent::Level(_)
            | CountedEvent::CameraHit
            | CountedEvent::LevelLimit(_)
            | CountedEvent::Cutoff(_)
            | CountedEvent::MediumStackFull => self.counters.count(event),
            CountedEvent::BoxTests(..)
            | CountedEvent::ShapeTest(..)
            | CountedEvent::ShadowCacheTest { .. }
            | CountedEvent::LeafVisit(_)
            | CountedEvent::MailboxHit(_) => {}
        }
    }
}
