//! How counters count events.

use super::{Counters, Event, RayCounters, Tally, UnsentRays};
use crate::math::{Real, Rgb};

/// Counts a ray of this weight.
fn unsent(counter: &mut UnsentRays, weight: Rgb) {
    let steps = ((weight.r + weight.g + weight.b) * (UnsentRays::WEIGHT_ONE as Real / 3.0)) as u64;
    counter.add(&UnsentRays { rays: 1, weight_steps: steps });
}

impl Tally for Counters {
    fn count(&mut self, event: Event) {
        match event {
            Event::Ray(kind) => self.rays[kind] += 1,
            Event::Level(level) => self.deepest = self.deepest.max(level),
            Event::CameraHit => self.camera_hits += 1,
            Event::Boxes(kind, count) => self.boxes[kind] += u64::from(count),
            Event::Shape(kind, shape) => {
                self.shapes[kind] += 1;
                self.by_shape[shape] += 1;
            }
            Event::Region(kind) => self.regions[kind] += 1,
            Event::Skipped(kind) => self.skipped[kind] += 1,
            Event::ShadowCache { hit } => {
                self.shadow_cache_asked += 1;
                self.shadow_cache_hits += u64::from(hit);
            }
            Event::LevelLimit(weight) => unsent(&mut self.level_limit, weight),
            Event::Cutoff(weight) => unsent(&mut self.cutoff, weight),
            Event::MediaFull => self.media_full += 1,
        }
    }
}

impl Tally for RayCounters {
    const TESTS: bool = false;

    #[inline(always)]
    fn count(&mut self, event: Event) {
        match event {
            Event::Ray(_)
            | Event::Level(_)
            | Event::CameraHit
            | Event::LevelLimit(_)
            | Event::Cutoff(_)
            | Event::MediaFull => self.counters.count(event),
            Event::Boxes(..)
            | Event::Shape(..)
            | Event::ShadowCache { .. }
            | Event::Region(_)
            | Event::Skipped(_) => {}
        }
    }
}
