//! What was counted while a picture was traced.
//!
//! Counts are integers, and weights are summed in fixed point, so that the sum of what several workers
//! have counted does not depend on their order.

use core::ops::{AddAssign, Index, IndexMut};

use super::ray_kind::RayKind;
use crate::geometry::ShapeKind;

/// One count for each value of an enum, indexed by that value.
macro_rules! counts_per {
    ($(#[$doc:meta])* $Counts:ident of $Kind:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct $Counts([u64; $Kind::ALL.len()]);

        impl $Counts {
            /// The sum over all kinds.
            pub fn sum(&self) -> u64 {
                self.0.iter().sum()
            }
        }

        impl Index<$Kind> for $Counts {
            type Output = u64;

            #[inline(always)]
            #[expect(clippy::indexing_slicing, reason = "there are as many counts as kinds")]
            fn index(&self, kind: $Kind) -> &u64 {
                // The compiler leaves the check out.
                &self.0[kind as usize]
            }
        }

        impl IndexMut<$Kind> for $Counts {
            #[inline(always)]
            #[expect(clippy::indexing_slicing, reason = "there are as many counts as kinds")]
            fn index_mut(&mut self, kind: $Kind) -> &mut u64 {
                &mut self.0[kind as usize]
            }
        }

        impl AddAssign for $Counts {
            fn add_assign(&mut self, other: Self) {
                for (count, other) in self.0.iter_mut().zip(other.0) {
                    *count += other;
                }
            }
        }
    };
}

counts_per! {
    /// One count for each kind of ray.
    PerRayKind of RayKind
}

counts_per! {
    /// One count for each kind of shape.
    PerShapeKind of ShapeKind
}

/// How often everything happened.
///
/// ```
/// use strahl_core::tally::{Counters, RayKind};
///
/// let mut counters = Counters::new();
/// counters.rays[RayKind::Camera] += 2;
/// assert_eq!((counters.rays[RayKind::Camera], counters.rays.sum()), (2, 2));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Rays sent. Shadow rays: lights asked for.
    pub rays: PerRayKind,
    /// Camera rays that met something.
    pub camera_hits: u64,
    /// The level of the deepest ray; the camera ray has level 1. Zero where there was none.
    pub max_level: u8,
    /// Tests of rays against boxes.
    pub box_tests: PerRayKind,
    /// Tests of rays against shapes.
    pub shape_tests: PerRayKind,
    /// Tests of rays against shapes, by the kind of the shape.
    pub shape_tests_by_kind: PerShapeKind,
    /// Regions of the accelerator entered.
    pub leaf_visits: PerRayKind,
    /// Tests of rays against shapes that mailboxes have saved.
    pub mailbox_hits: PerRayKind,
    /// How often a shadow cache was asked.
    pub shadow_cache_lookups: u64,
    /// How often it answered: its occluder still stood in the way.
    pub shadow_cache_hits: u64,
    /// Rays that were not sent because the levels ended.
    pub level_limit: UnsentRays,
    /// Rays that were not sent because their weight was not above the cutoff.
    pub cutoff: UnsentRays,
    /// Rays that went into a fifth body at once, and were taken to stay in the fourth.
    pub medium_stack_full: u64,
}

impl Counters {
    /// Nothing counted yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds what another worker has counted.
    pub fn merge(&mut self, other: &Counters) {
        self.rays += other.rays;
        self.camera_hits += other.camera_hits;
        self.max_level = self.max_level.max(other.max_level);
        self.box_tests += other.box_tests;
        self.shape_tests += other.shape_tests;
        self.shape_tests_by_kind += other.shape_tests_by_kind;
        self.leaf_visits += other.leaf_visits;
        self.mailbox_hits += other.mailbox_hits;
        self.shadow_cache_lookups += other.shadow_cache_lookups;
        self.shadow_cache_hits += other.shadow_cache_hits;
        self.level_limit.merge(&other.level_limit);
        self.cutoff.merge(&other.cutoff);
        self.medium_stack_full += other.medium_stack_full;
    }

    /// Which share of the light was cut, by the levels and by the cutoff: of what all camera rays
    /// could have brought if everything were equally bright. In `[0, 1]`.
    pub fn cut_fractions(&self) -> [f64; 2] {
        let rays = self.rays[RayKind::Camera];
        let whole = if rays > 0 { rays as f64 } else { 1.0 };
        [self.level_limit.weight() / whole, self.cutoff.weight() / whole]
    }
}

/// Rays that were not sent, and the sum of their weights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnsentRays {
    /// How many.
    pub rays: u64,
    /// The mean of the three channels of each weight, in units of one over
    /// [`UnsentRays::WEIGHT_ONE`], summed. Saturates.
    pub weight_units: u64,
}

impl UnsentRays {
    /// The weight of a camera ray in `weight_steps`.
    pub const WEIGHT_ONE: u32 = 1 << 24;

    /// The sum of their weights. Unit: weights of camera rays.
    pub fn weight(&self) -> f64 {
        self.weight_units as f64 / f64::from(Self::WEIGHT_ONE)
    }

    /// Adds the rays that another worker has counted.
    pub fn merge(&mut self, other: &UnsentRays) {
        self.rays += other.rays;
        self.weight_units = self.weight_units.saturating_add(other.weight_units);
    }
}

/// Counts rays and what was cut, but no tests, no regions and no caches: next to nothing for each
/// ray, where [`Counters`] take a part of the whole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounters {
    /// What was counted; zero for the rest.
    pub counters: Counters,
}

impl RayCounters {
    /// Nothing counted yet.
    pub fn new() -> Self {
        Self::default()
    }
}
