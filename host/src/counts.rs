//! How often everything happened, whatever precision was computed with.

use strahl_core::{RayKind, ShapeKind};

/// How often everything happened; the arrays are by kind of ray, or of shape.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Counts {
    pub(crate) rays: [u64; RayKind::ALL.len()],
    pub(crate) camera_hits: u64,
    pub(crate) boxes: [u64; RayKind::ALL.len()],
    pub(crate) shapes: [u64; RayKind::ALL.len()],
    pub(crate) regions: [u64; RayKind::ALL.len()],
    pub(crate) skipped: [u64; RayKind::ALL.len()],
    pub(crate) by_shape: [u64; ShapeKind::ALL.len()],
    pub(crate) shadow_cache_asked: u64,
    pub(crate) shadow_cache_hits: u64,
    pub(crate) deepest: u8,
    pub(crate) level_limit: u64,
    pub(crate) level_limit_weight: f64,
    pub(crate) cutoff: u64,
    pub(crate) cutoff_weight: f64,
    pub(crate) media_full: u64,
}

/// Each as [`strahl_core::Counters`] says.
#[allow(missing_docs)]
impl Counts {
    pub fn rays(&self, kind: RayKind) -> u64 {
        self.rays[kind as usize]
    }

    pub fn camera_hits(&self) -> u64 {
        self.camera_hits
    }

    pub fn boxes(&self, kind: RayKind) -> u64 {
        self.boxes[kind as usize]
    }

    pub fn shapes(&self, kind: RayKind) -> u64 {
        self.shapes[kind as usize]
    }

    pub fn regions(&self, kind: RayKind) -> u64 {
        self.regions[kind as usize]
    }

    pub fn skipped(&self, kind: RayKind) -> u64 {
        self.skipped[kind as usize]
    }

    pub fn by_shape(&self, kind: ShapeKind) -> u64 {
        self.by_shape[kind as usize]
    }

    pub fn shadow_cache_asked(&self) -> u64 {
        self.shadow_cache_asked
    }

    pub fn shadow_cache_hits(&self) -> u64 {
        self.shadow_cache_hits
    }

    pub fn deepest(&self) -> u8 {
        self.deepest
    }

    pub fn level_limit(&self) -> u64 {
        self.level_limit
    }

    pub fn level_limit_weight(&self) -> f64 {
        self.level_limit_weight
    }

    pub fn cutoff(&self) -> u64 {
        self.cutoff
    }

    pub fn cutoff_weight(&self) -> f64 {
        self.cutoff_weight
    }

    pub fn media_full(&self) -> u64 {
        self.media_full
    }

    /// Which share of the light was cut, by the levels and by the cutoff: of what all camera rays
    /// could have brought, if everything were equally bright.
    pub fn cut(&self) -> [f64; 2] {
        let whole = (self.rays(RayKind::Camera) as f64).max(1.0);
        [self.level_limit_weight / whole, self.cutoff_weight / whole]
    }
}
