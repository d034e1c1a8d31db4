//! The stack of rays that are still to be traced.

use heapless::Vec;

use crate::math::{Rgb, Vec3};
use crate::shade::MediumStack;
use crate::tally::{RayKind, TraceEvent};

/// A ray that is still to be traced, with its weight in the sample.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Task {
    /// Origin, world space.
    pub(crate) origin: Vec3,
    /// Direction, unit.
    pub(crate) direction: Vec3,
    /// Weight of its radiance in the sample: the product of the factors along its path.
    pub(crate) weight: Rgb,
    /// Level in the ray tree; the camera ray has level 1.
    pub(crate) level: u8,
    /// Kind of the ray.
    pub(crate) kind: RayKind,
    /// Bodies that it starts inside.
    pub(crate) media: MediumStack,
}

impl Task {
    /// The event that reports its start.
    pub(crate) fn start_event(&self) -> TraceEvent {
        let Task { origin, direction, weight, level, kind, .. } = *self;
        TraceEvent::RayStart { kind, level, origin, direction, weight }
    }
}

/// A reflected or transmitted ray that starts at a hit.
pub(crate) struct SecondaryRay {
    /// Origin, world space.
    pub(crate) origin: Vec3,
    /// Direction, unit.
    pub(crate) direction: Vec3,
    /// Fraction of the radiance along this ray that the surface returns.
    pub(crate) factor: Rgb,
    /// [`RayKind::Reflected`] or [`RayKind::Transmitted`].
    pub(crate) kind: RayKind,
    /// Bodies that it starts inside.
    pub(crate) media: MediumStack,
}

/// A stack with the capacity for every ray tree of `LEVELS` levels, 1 to 64.
///
/// Proof: the stack is last in, first out, and tracing a task of level `l` pushes at most two tasks, of level
/// `l + 1`. So while a task of level `l` is traced, at most one task of each of the levels `2..=l` is on the
/// stack. With its two secondary rays these are at most `l + 1` tasks, and secondary rays are pushed only if
/// `l < LEVELS`.
#[derive(Debug)]
pub(crate) struct TaskStack<const LEVELS: usize>(Vec<Task, LEVELS>);

impl<const LEVELS: usize> TaskStack<LEVELS> {
    /// An empty stack.
    pub(crate) const fn new() -> Self {
        const { assert!(LEVELS >= 1 && LEVELS <= 64) };
        TaskStack(Vec::new())
    }

    /// Pushes a task. The capacity suffices, see above.
    pub(crate) fn push(&mut self, task: Task) {
        let pushed = self.0.push(task);
        debug_assert!(pushed.is_ok(), "more tasks than levels");
    }

    /// Removes and returns the task that was pushed last.
    pub(crate) fn pop(&mut self) -> Option<Task> {
        self.0.pop()
    }

    /// Removes all tasks.
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }
}
