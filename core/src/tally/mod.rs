//! What a tracer reports about its work, and counters of it.
//!
//! A tracer reports [`CountedEvent`]s (rays, tests, cache lookups) for statistics, and [`TraceEvent`]s (the
//! ray tree of one camera sample, step by step) for explanations. A [`Tally`] receives both; [`Counters`] and
//! [`RayCounters`] are tallies that count. The tally `()` ignores everything, and the reports are optimized
//! away (`tests/reports/local-light.md`). No tally changes a pixel.

mod count;
#[cfg(not(feature = "double"))]
mod counters;
#[cfg(not(feature = "double"))]
mod ray_kind;
mod trace_event;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::tally::{self as counters, self as ray_kind};

pub use counters::{Counters, PerRayKind, PerShapeKind, RayCounters, UnsentRays};
pub use ray_kind::{RayKind, RayOutcome};
pub use trace_event::{LightOutcome, TraceEvent};

use crate::geometry::ShapeKind;
use crate::math::Rgb;

/// An event that a tracer counts in a [`Tally`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CountedEvent {
    /// A ray was traced. Of kind [`RayKind::Shadow`]: a light was tested for occlusion, also if the shadow
    /// cache answered and no ray traversed the accelerator.
    Ray(RayKind),
    /// A camera, reflected or transmitted ray of this level was traced. Camera rays have level 1, their
    /// secondary rays level 2.
    Level(u8),
    /// A camera ray hit an item.
    CameraHit,
    /// A ray of this kind was tested against this many bounding boxes or bounding spheres.
    BoxTests(RayKind, u32),
    /// A ray of this kind was tested against a shape of this kind.
    ShapeTest(RayKind, ShapeKind),
    /// The shadow cache held the last occluder of a light, and the shadow ray was tested against it before
    /// any traversal. Not counted if the cache held none.
    ShadowCacheTest {
        /// Whether it occludes this ray too; then the accelerator is not traversed.
        occluded: bool,
    },
    /// A ray of this kind visited a leaf or a cell of the accelerator; of a [`List`](crate::accel::List), a
    /// group of 16 items whose bounding volume it hits, or the whole list if it has no volumes.
    LeafVisit(RayKind),
    /// An item was not tested against a ray of this kind, because the mailbox held it: it had been tested
    /// before.
    MailboxHit(RayKind),
    /// A secondary ray of this weight was not sent, because the level limit was reached.
    LevelLimit(Rgb),
    /// A secondary ray of this weight was not sent, because no channel of it was above the cutoff.
    Cutoff(Rgb),
    /// A ray entered a body while its [`MediumStack`](crate::shade::MediumStack) was full. The body was not
    /// entered: the ray goes on in the medium that it was in.
    MediumStackFull,
}

/// Receives the events that a tracer reports: counts them, or records the ray tree.
///
/// ```
/// use strahl_core::tally::{CountedEvent, RayKind, Tally};
///
/// /// Counts shadow rays.
/// struct ShadowRays(u64);
///
/// impl Tally for ShadowRays {
///     const COUNTS_TESTS: bool = false;
///
///     fn count(&mut self, event: CountedEvent) {
///         if event == CountedEvent::Ray(RayKind::Shadow) {
///             self.0 += 1;
///         }
///     }
/// }
///
/// let mut tally = ShadowRays(0);
/// tally.count(CountedEvent::Ray(RayKind::Shadow));
/// tally.count(CountedEvent::CameraHit);
/// assert_eq!(tally.0, 1);
/// ```
pub trait Tally {
    /// Whether [`CountedEvent::ShapeTest`] is reported. If false, the kind of a tested shape is not
    /// determined.
    const COUNTS_TESTS: bool = true;

    /// Receives an event of the statistics.
    fn count(&mut self, event: CountedEvent);

    /// Receives a step of the ray tree. By default it is ignored, and nothing of it is left in the optimized
    /// loop.
    #[inline(always)]
    fn trace_event(&mut self, _: TraceEvent) {}

    /// Whether to stop tracing the current ray tree. Called before each of its rays except the camera ray; if
    /// true, the sample is what the rays traced so far contribute.
    ///
    /// A tree of many levels may take arbitrarily long. By default it is never cancelled, and nothing of the
    /// question is left in the optimized loop.
    #[inline(always)]
    fn is_cancelled(&mut self) -> bool {
        false
    }
}

/// Ignores all events, at no cost.
impl Tally for () {
    const COUNTS_TESTS: bool = false;

    #[inline(always)]
    fn count(&mut self, _: CountedEvent) {}
}
