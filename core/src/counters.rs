//! The tallies that count.

use crate::geometry::ShapeKind;
use crate::math::{Real, Rgb};
use crate::tally::{Event, RayKind, Tally};

/// How often everything happened, by kind of ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    rays: [u64; 4],
    camera_hits: u64,
    deepest: u8,
    boxes: [u64; 4],
    shapes: [u64; 4],
    regions: [u64; 4],
    skipped: [u64; 4],
    by_shape: [u64; ShapeKind::ALL.len()],
    shadow_cache: [u64; 2],
    level_limit: u64,
    level_limit_weight: u64,
    cutoff: u64,
    cutoff_weight: u64,
    media_full: u64,
}

impl Counters {
    /// Nothing counted yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Rays sent. Shadow rays: lights asked for.
    pub fn rays(&self, kind: RayKind) -> u64 {
        of(&self.rays, kind as usize)
    }

    /// Camera rays that met something.
    pub fn camera_hits(&self) -> u64 {
        self.camera_hits
    }

    /// The level of the deepest ray; the camera ray has level 1. Zero where there was none.
    pub fn deepest(&self) -> u8 {
        self.deepest
    }

    /// Tests of rays against boxes.
    pub fn boxes(&self, kind: RayKind) -> u64 {
        of(&self.boxes, kind as usize)
    }

    /// Tests of rays against shapes.
    pub fn shapes(&self, kind: RayKind) -> u64 {
        of(&self.shapes, kind as usize)
    }

    /// Regions of the accelerator entered.
    pub fn regions(&self, kind: RayKind) -> u64 {
        of(&self.regions, kind as usize)
    }

    /// Tests of rays against shapes that mailboxes have saved.
    pub fn skipped(&self, kind: RayKind) -> u64 {
        of(&self.skipped, kind as usize)
    }

    /// Tests of rays against shapes of one kind.
    pub fn by_shape(&self, kind: ShapeKind) -> u64 {
        of(&self.by_shape, kind as usize)
    }

    /// How often a shadow cache was asked.
    pub fn shadow_cache_asked(&self) -> u64 {
        self.shadow_cache.iter().sum()
    }

    /// How often it answered: who was remembered still stood in the way.
    pub fn shadow_cache_hits(&self) -> u64 {
        of(&self.shadow_cache, 1)
    }

    /// Rays that were not sent, because the levels ended.
    pub fn level_limit(&self) -> u64 {
        self.level_limit
    }

    /// Rays that were not sent, because too little of what they find would have counted.
    pub fn cutoff(&self) -> u64 {
        self.cutoff
    }

    /// The weight of the rays that were not sent, because the levels ended: one is a camera ray.
    pub fn level_limit_weight(&self) -> f64 {
        weight(self.level_limit_weight)
    }

    /// The weight of the rays that were not sent, because too little of what they find would
    /// have counted: one is a camera ray.
    pub fn cutoff_weight(&self) -> f64 {
        weight(self.cutoff_weight)
    }

    /// Rays that went into a fifth body at once, and were taken to stay in the fourth.
    pub fn media_full(&self) -> u64 {
        self.media_full
    }

    /// Adds what another worker has counted.
    pub fn add(&mut self, other: &Counters) {
        let pairs = [
            (&mut self.rays[..], &other.rays[..]),
            (&mut self.boxes, &other.boxes),
            (&mut self.shapes, &other.shapes),
            (&mut self.regions, &other.regions),
            (&mut self.skipped, &other.skipped),
            (&mut self.by_shape, &other.by_shape),
            (&mut self.shadow_cache, &other.shadow_cache),
        ];
        for (mine, others) in pairs {
            for (mine, other) in mine.iter_mut().zip(others) {
                *mine += other;
            }
        }
        self.camera_hits += other.camera_hits;
        self.deepest = self.deepest.max(other.deepest);
        self.level_limit += other.level_limit;
        self.level_limit_weight = self.level_limit_weight.saturating_add(other.level_limit_weight);
        self.cutoff += other.cutoff;
        self.cutoff_weight = self.cutoff_weight.saturating_add(other.cutoff_weight);
        self.media_full += other.media_full;
    }
}

/// Weights are added in whole steps, so that the sum does not depend on the order.
const STEPS: u32 = 1 << 24;

/// The mean of the channels, in steps.
fn steps(weight: Rgb) -> u64 {
    ((weight.r + weight.g + weight.b) * (STEPS as Real / 3.0)) as u64
}

fn weight(steps: u64) -> f64 {
    steps as f64 / f64::from(STEPS)
}

fn of(counts: &[u64], place: usize) -> u64 {
    counts.get(place).copied().unwrap_or(0)
}

fn bump(counts: &mut [u64], place: usize, by: u32) {
    if let Some(count) = counts.get_mut(place) {
        *count += u64::from(by);
    }
}

impl Tally for Counters {
    fn count(&mut self, event: Event) {
        match event {
            Event::Ray(kind) => bump(&mut self.rays, kind as usize, 1),
            Event::Level(level) => self.deepest = self.deepest.max(level),
            Event::CameraHit => self.camera_hits += 1,
            Event::Boxes(kind, count) => bump(&mut self.boxes, kind as usize, count),
            Event::Shape(kind, shape) => {
                bump(&mut self.shapes, kind as usize, 1);
                bump(&mut self.by_shape, shape as usize, 1);
            }
            Event::Region(kind) => bump(&mut self.regions, kind as usize, 1),
            Event::Skipped(kind) => bump(&mut self.skipped, kind as usize, 1),
            Event::ShadowCache { hit } => bump(&mut self.shadow_cache, usize::from(hit), 1),
            Event::LevelLimit(weight) => {
                self.level_limit += 1;
                self.level_limit_weight = self.level_limit_weight.saturating_add(steps(weight));
            }
            Event::Cutoff(weight) => {
                self.cutoff += 1;
                self.cutoff_weight = self.cutoff_weight.saturating_add(steps(weight));
            }
            Event::MediaFull => self.media_full += 1,
        }
    }
}

/// Counts rays and what was cut, but no tests, no regions and no caches: next to nothing for each
/// ray, where [`Counters`] take a part of the whole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounters(Counters);

impl RayCounters {
    /// Nothing counted yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// What was counted; nothing of the rest.
    pub fn counters(&self) -> &Counters {
        &self.0
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
            | Event::MediaFull => self.0.count(event),
            Event::Boxes(..)
            | Event::Shape(..)
            | Event::ShadowCache { .. }
            | Event::Region(_)
            | Event::Skipped(_) => {}
        }
    }
}
