//! Statistics of the tracing of a picture.
//!
//! Counts are integers and weights are summed in fixed point, so merging the counters of several workers
//! gives the same result in every order.

use core::ops::{AddAssign, Index, IndexMut};

use super::ray_kind::RayKind;
use crate::geometry::ShapeKind;

/// Declares `$Counts`: one count per value of the enum `$Kind`, indexed by that value.
macro_rules! counts_per {
    ($(#[$doc:meta])* $Counts:ident of $Kind:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct $Counts([u64; $Kind::ALL.len()]);

        impl $Counts {
            /// Sum over all kinds.
            pub fn sum(&self) -> u64 {
                self.0.iter().sum()
            }
        }

        impl Index<$Kind> for $Counts {
            type Output = u64;

            #[inline(always)]
            #[expect(clippy::indexing_slicing, reason = "one count per kind")]
            fn index(&self, kind: $Kind) -> &u64 {
                // The bounds check is optimized away.
                &self.0[kind as usize]
            }
        }

        impl IndexMut<$Kind> for $Counts {
            #[inline(always)]
            #[expect(clippy::indexing_slicing, reason = "one count per kind")]
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
    /// One count per kind of ray.
    PerRayKind of RayKind
}

counts_per! {
    /// One count per kind of shape.
    PerShapeKind of ShapeKind
}

/// A [`Tally`](super::Tally) that counts all events.
///
/// [`RayCounters`] count less and cost almost nothing.
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
    /// Rays traced. Of shadow rays: lights tested for occlusion, including those that the shadow cache
    /// answered.
    pub rays: PerRayKind,
    /// Camera rays that hit an item.
    pub camera_hits: u64,
    /// Highest level of a ray; camera rays have level 1. Zero if no ray was traced.
    pub max_level: u8,
    /// Tests of rays against bounding boxes and bounding spheres.
    pub box_tests: PerRayKind,
    /// Tests of rays against shapes, by the kind of the ray.
    pub shape_tests: PerRayKind,
    /// Tests of rays against shapes, by the kind of the shape.
    pub shape_tests_by_kind: PerShapeKind,
    /// Leaves and cells of the accelerator, or groups of a list, that rays visited.
    pub leaf_visits: PerRayKind,
    /// Tests of rays against items that a mailbox saved, by the kind of the ray.
    pub mailbox_hits: PerRayKind,
    /// Shadow rays for which the shadow cache held an occluder, which was tested first.
    pub shadow_cache_tests: u64,
    /// Of those, the ones that this occluder occludes too.
    pub shadow_cache_hits: u64,
    /// Secondary rays that were not sent because of the level limit.
    pub level_limit: UnsentRays,
    /// Secondary rays that were not sent because their weight was not above the cutoff.
    pub cutoff: UnsentRays,
    /// Rays that entered a body while their medium stack was full, and stayed in their medium.
    pub medium_stack_full: u64,
}

impl Counters {
    /// Counters at zero.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the counts of another worker, and takes the larger `max_level`.
    pub fn merge(&mut self, other: &Counters) {
        self.rays += other.rays;
        self.camera_hits += other.camera_hits;
        self.max_level = self.max_level.max(other.max_level);
        self.box_tests += other.box_tests;
        self.shape_tests += other.shape_tests;
        self.shape_tests_by_kind += other.shape_tests_by_kind;
        self.leaf_visits += other.leaf_visits;
        self.mailbox_hits += other.mailbox_hits;
        self.shadow_cache_tests += other.shadow_cache_tests;
        self.shadow_cache_hits += other.shadow_cache_hits;
        self.level_limit.merge(&other.level_limit);
        self.cutoff.merge(&other.cutoff);
        self.medium_stack_full += other.medium_stack_full;
    }

    /// Fractions of the light that were removed by the level limit and by the cutoff, in this order.
    ///
    /// Weight of the unsent rays over the number of camera rays: the fraction of the radiance if all points
    /// were equally bright. Zero without camera rays.
    pub fn cut_fractions(&self) -> [f64; 2] {
        let camera_rays = self.rays[RayKind::Camera];
        let divisor = if camera_rays > 0 { camera_rays as f64 } else { 1.0 };
        [self.level_limit.weight() / divisor, self.cutoff.weight() / divisor]
    }
}

/// Number and total weight of the rays that were not sent for one reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnsentRays {
    /// Number of rays.
    pub rays: u64,
    /// Sum of the rays' weights, each the mean of its three channels, in fixed point: a weight of 1 is
    /// [`UnsentRays::WEIGHT_ONE`] units. Saturates.
    pub weight_units: u64,
}

impl UnsentRays {
    /// A weight of 1, that of a camera ray, in units of `weight_units`.
    pub const WEIGHT_ONE: u32 = 1 << 24;

    /// Sum of the rays' weights. The weight of a camera ray is 1.
    pub fn weight(&self) -> f64 {
        self.weight_units as f64 / f64::from(Self::WEIGHT_ONE)
    }

    /// Adds the rays of another worker.
    pub fn merge(&mut self, other: &UnsentRays) {
        self.rays += other.rays;
        self.weight_units = self.weight_units.saturating_add(other.weight_units);
    }
}

/// A [`Tally`](super::Tally) that counts rays and cut light only: no tests, leaf visits or cache lookups.
///
/// It costs almost nothing; counting tests in the inner loop, as [`Counters`] do, has a measurable cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounters {
    /// The counts. Those of tests, leaf visits and caches are zero.
    pub counters: Counters,
}

impl RayCounters {
    /// Counters at zero.
    pub fn new() -> Self {
        Self::default()
    }
}
