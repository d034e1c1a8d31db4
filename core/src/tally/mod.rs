//! What a tracer tells about its work.
//!
//! The tracer reports events to a [`Tally`], and the steps of the tree of rays. The tally `()`
//! counts nothing: nothing of the reports is left in the optimised loop (`tests/reports/local-light.md`).

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

/// Something that happened while a picture was traced.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CountedEvent {
    /// A ray was sent; for shadow rays, a light was asked for, whoever answered.
    Ray(RayKind),
    /// A ray of this level was sent that is no shadow ray; the camera ray has level 1.
    Level(u8),
    /// A camera ray met something.
    CameraHit,
    /// A ray was held against boxes, this many.
    BoxTests(RayKind, u32),
    /// A ray was held against a shape.
    ShapeTest(RayKind, ShapeKind),
    /// Who stood last in the way of a light was asked first, and still does so or not.
    ShadowCacheLookup {
        /// Whether he does.
        hit: bool,
    },
    /// A ray entered a region of the accelerator.
    LeafVisit(RayKind),
    /// A ray was not held against an item, because a mailbox remembered that it had been.
    MailboxHit(RayKind),
    /// A ray of this weight was not sent, because the levels end here.
    LevelLimit(Rgb),
    /// A ray of this weight was not sent, because too little of what it finds would count.
    Cutoff(Rgb),
    /// A ray went into a medium deeper than the list of media can tell, and was taken to stay
    /// in the one it was in.
    MediumStackFull,
}

/// Somebody who is told what happens.
pub trait Tally {
    /// Whether it hears of tests: for who does not, it is not asked which shape was tested.
    const COUNTS_TESTS: bool = true;

    /// Hears of one event.
    fn count(&mut self, event: CountedEvent);

    /// Hears of one step. Who only counts leaves this as it is, and nothing of it is left in the
    /// optimised loop.
    #[inline(always)]
    fn trace_event(&mut self, _: TraceEvent) {}

    /// Whether the tree of rays that is traced is to be given up, asked before each of its rays but
    /// the first: what they have brought so far is then the answer.
    ///
    /// A tree of many levels may take longer than anybody waits. Who never gives up leaves this as it
    /// is, and nothing of it is left in the optimised loop.
    #[inline(always)]
    fn is_cancelled(&mut self) -> bool {
        false
    }
}

/// Counts nothing and costs nothing.
impl Tally for () {
    const COUNTS_TESTS: bool = false;

    #[inline(always)]
    fn count(&mut self, _: CountedEvent) {}
}
