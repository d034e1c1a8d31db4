//! Accelerators: what can be asked for, and what is chosen.
//!
//! `auto` takes the hierarchy, and for few items the list (`tests/reports/auto.md`).

use std::fmt;

use crate::choice::Choice;
use crate::choices;

/// The sizes of mailboxes that there are, in entries; 0 is none.
pub const MAILBOX_SLOTS: [usize; 3] = [0, 8, DEFAULT_MAILBOX_SLOTS];

/// The usual size of a mailbox.
pub const DEFAULT_MAILBOX_SLOTS: usize = 64;

/// The capacities of heaps that there are.
pub const HEAP_ENTRIES: [usize; 4] = [0, 1, 4, DEFAULT_HEAP_ENTRIES];

/// The usual capacity of a heap.
pub const DEFAULT_HEAP_ENTRIES: usize = 64;

/// The capacity of a stack: no hierarchy is deeper.
pub const STACK_ENTRIES: usize = 64;

/// For so many items a hierarchy is not worth its making.
const MAX_ITEMS_FOR_LIST: usize = 8;

choices! {
    /// An accelerator, or the one that suits.
    pub enum Accel {
        /// What suits the scene.
        Auto = "auto",
        /// Every item in turn.
        List = "list",
        /// Equal cells, walked one by one.
        Grid = "grid",
        /// Space cut into eighths where there are many items.
        Octree = "octree",
        /// A hierarchy of boxes.
        Bvh = "bvh",
    }

    /// An accelerator.
    pub enum AccelKind {
        /// Every item in turn.
        List = "list",
        /// Equal cells, walked one by one.
        Grid = "grid",
        /// Space cut into eighths where there are many items.
        Octree = "octree",
        /// A hierarchy of boxes.
        Bvh = "bvh",
    }

    /// How a hierarchy is walked.
    pub enum Walk {
        /// The nearest of all that waits comes next.
        Heap = "heap",
        /// The nearer of two halves comes next.
        Stack = "stack",
    }

    /// What the list puts around items and groups of them.
    pub enum Bounds {
        /// Nothing: every item is tested against every ray.
        None = "none",
        /// Spheres around their boxes.
        Sphere = "sphere",
        /// Boxes.
        Box = "box",
    }
}

impl Accel {
    /// Which; none when the scene decides.
    pub fn explicit_kind(self) -> Option<AccelKind> {
        AccelKind::from_name(self.name())
    }

    /// The option that leaves no use for a setting of these accelerators, if it does.
    pub(crate) fn rules_out(self, kinds: &[AccelKind]) -> Option<String> {
        self.explicit_kind().filter(|kind| !kinds.contains(kind)).map(|kind| format!("--accel {kind}"))
    }
}

impl Walk {
    /// The option that leaves no use for the capacity of a heap, if it does.
    pub(crate) fn rules_out_heap(self) -> Option<String> {
        (self != Walk::Heap).then(|| format!("--walk {self}"))
    }
}

impl From<AccelKind> for Accel {
    fn from(kind: AccelKind) -> Self {
        Accel::from_name(kind.name()).unwrap_or(Accel::Auto)
    }
}

/// How items are found. None of it changes an answer, all of it the time. What has no use for the accelerator is there
/// all the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AccelSettings {
    /// The accelerator.
    pub accel: Accel,
    /// How a hierarchy is walked.
    pub walk: Walk,
    /// The capacity of the heap of that walk: one of [`HEAP_ENTRIES`].
    pub heap: usize,
    /// What the list puts around items and groups of them.
    pub bounds: Bounds,
    /// The size of the mailbox of grid and octree: one of [`MAILBOX_SLOTS`].
    pub mailbox: usize,
}

impl AccelSettings {
    /// What suits the scene, everything as usual.
    pub const DEFAULT: AccelSettings = AccelSettings {
        accel: Accel::Auto,
        walk: Walk::Stack,
        heap: DEFAULT_HEAP_ENTRIES,
        bounds: Bounds::Box,
        mailbox: DEFAULT_MAILBOX_SLOTS,
    };

    /// This accelerator, everything else as usual.
    pub fn with_kind(kind: AccelKind) -> Self {
        AccelSettings { accel: kind.into(), ..AccelSettings::DEFAULT }
    }

    /// A hierarchy that is walked by a heap of this capacity.
    pub fn with_heap(heap: usize) -> Self {
        AccelSettings { walk: Walk::Heap, heap, ..AccelSettings::with_kind(AccelKind::Bvh) }
    }

    /// All ways to find the same.
    pub fn all_variants() -> Vec<Self> {
        let each = |kind| {
            let by = AccelSettings::with_kind(kind);
            match kind {
                AccelKind::List => Bounds::ALL.map(|bounds| AccelSettings { bounds, ..by }).to_vec(),
                AccelKind::Grid | AccelKind::Octree => {
                    MAILBOX_SLOTS.map(|mailbox| AccelSettings { mailbox, ..by }).to_vec()
                }
                AccelKind::Bvh => [&[by], &HEAP_ENTRIES.map(AccelSettings::with_heap)[..]].concat(),
            }
        };
        AccelKind::ALL.into_iter().flat_map(each).collect()
    }

    /// The choice for a scene with so many bounded items.
    pub fn resolve(&self, items: usize) -> ResolvedAccel {
        let (kind, reason) = match self.accel.explicit_kind() {
            Some(kind) => (kind, "as asked for"),
            None if items <= MAX_ITEMS_FOR_LIST => (AccelKind::List, "few items"),
            None => (AccelKind::Bvh, "many items"),
        };
        let AccelSettings { walk, heap, bounds, mailbox, .. } = *self;
        ResolvedAccel { kind, reason, walk, heap, bounds, mailbox }
    }
}

impl Default for AccelSettings {
    fn default() -> Self {
        AccelSettings::DEFAULT
    }
}

/// An accelerator with everything about it. What has no use for it is there all the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ResolvedAccel {
    /// The accelerator.
    pub kind: AccelKind,
    /// Why it was taken.
    pub reason: &'static str,
    /// How a hierarchy is walked.
    pub walk: Walk,
    /// The capacity of the heap.
    pub heap: usize,
    /// What the list puts around items.
    pub bounds: Bounds,
    /// The size of the mailbox.
    pub mailbox: usize,
}

/// With what has a use for it.
impl fmt::Display for ResolvedAccel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = self.kind;
        match kind {
            AccelKind::List => match self.bounds {
                Bounds::None => write!(f, "{kind} without bounds"),
                Bounds::Sphere => write!(f, "{kind} with spheres"),
                Bounds::Box => write!(f, "{kind} with boxes"),
            },
            AccelKind::Grid | AccelKind::Octree => match self.mailbox {
                0 => write!(f, "{kind} without mailbox"),
                slots => write!(f, "{kind} with a mailbox of {slots}"),
            },
            AccelKind::Bvh => match self.walk {
                Walk::Heap => write!(f, "{kind} with a heap of {}", self.heap),
                Walk::Stack => write!(f, "{kind} with a stack"),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_is_one_that_can_be_asked_for() {
        for kind in AccelKind::ALL {
            assert_eq!(Accel::from(kind).explicit_kind(), Some(kind));
        }
        assert_eq!(Accel::Auto.explicit_kind(), None);
        assert_eq!(AccelSettings::all_variants().len(), 3 + 3 + 3 + 5);
    }

    #[test]
    fn few_items_are_found_by_a_list_and_many_by_a_hierarchy() {
        let kind = |items| AccelSettings::DEFAULT.resolve(items).kind;
        assert_eq!([0, 8, 9].map(kind), [AccelKind::List, AccelKind::List, AccelKind::Bvh]);
        assert_eq!(AccelSettings::with_kind(AccelKind::Grid).resolve(0).kind, AccelKind::Grid);
    }
}
