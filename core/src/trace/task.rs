//! What is still to be traced, and the stack that holds it.

use heapless::Vec;

use crate::math::{Rgb, Vec3};
use crate::shade::MediumStack;
use crate::tally::{RayKind, TraceEvent};

/// A ray that is still to be traced.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Task {
    /// Where it starts.
    pub(crate) origin: Vec3,
    /// Where it goes, of length one.
    pub(crate) direction: Vec3,
    /// How much of what it finds counts in the pixel.
    pub(crate) weight: Rgb,
    /// The camera ray has level 1.
    pub(crate) level: u8,
    /// Why it was sent.
    pub(crate) kind: RayKind,
    /// The bodies that it starts inside of.
    pub(crate) media: MediumStack,
}

impl Task {
    /// What is told when it is followed.
    pub(crate) fn start_event(&self) -> TraceEvent {
        let Task { origin, direction, weight, level, kind, .. } = *self;
        TraceEvent::RayStart { kind, level, origin, direction, weight }
    }
}

/// Room for everything that can be waiting in a tree of `LEVELS` levels.
///
/// The last task in is the first out, and a task of level `l` leaves at most two of level
/// `l + 1`. So while a task of level `l` is worked on, at most one waits from each of the levels
/// `2..=l`; its two children make that `l + 1` at most, and there are children only where `l` is
/// less than `LEVELS`.
#[derive(Debug)]
pub(crate) struct TaskStack<const LEVELS: usize>(Vec<Task, LEVELS>);

impl<const LEVELS: usize> TaskStack<LEVELS> {
    pub(crate) const fn new() -> Self {
        const { assert!(LEVELS >= 1 && LEVELS <= 64) };
        TaskStack(Vec::new())
    }

    pub(crate) fn push(&mut self, task: Task) {
        let pushed = self.0.push(task);
        debug_assert!(pushed.is_ok(), "more tasks than levels");
    }

    pub(crate) fn pop(&mut self) -> Option<Task> {
        self.0.pop()
    }

    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }
}
