//! Settings of the acceleration structure, and their resolution for a scene.
//!
//! `auto` selects the BVH, and the list for few items (`tests/reports/auto.md`).

use std::fmt;

use crate::choice::Choice;
use crate::choices;

/// The available mailbox sizes, in slots; 0 means no mailbox.
pub const MAILBOX_SLOTS: [usize; 3] = [0, 8, DEFAULT_MAILBOX_SLOTS];

/// The default mailbox size, in slots.
pub const DEFAULT_MAILBOX_SLOTS: usize = 64;

/// The available capacities of the priority queue, in entries.
pub const HEAP_ENTRIES: [usize; 4] = [0, 1, 4, DEFAULT_HEAP_ENTRIES];

/// The default capacity of the priority queue, in entries.
pub const DEFAULT_HEAP_ENTRIES: usize = 64;

/// The capacity of the traversal stack, in entries; no BVH is deeper.
pub const STACK_ENTRIES: usize = 64;

/// The maximum number of items for which the list is selected: building a BVH does not pay for them.
const MAX_ITEMS_FOR_LIST: usize = 8;

choices! {
    /// An acceleration structure, or `auto`.
    pub enum Accel {
        /// Selected for the scene.
        Auto = "auto",
        /// List: every item is tested.
        List = "list",
        /// Uniform grid.
        Grid = "grid",
        /// Octree.
        Octree = "octree",
        /// Bounding volume hierarchy.
        Bvh = "bvh",
    }

    /// An acceleration structure.
    pub enum AccelKind {
        /// List: every item is tested.
        List = "list",
        /// Uniform grid.
        Grid = "grid",
        /// Octree.
        Octree = "octree",
        /// Bounding volume hierarchy.
        Bvh = "bvh",
    }

    /// The traversal order of the BVH.
    pub enum Walk {
        /// Nearest node first, with a priority queue (Kay and Kajiya 1986).
        Heap = "heap",
        /// Nearer child first, with a stack.
        Stack = "stack",
    }

    /// The bounding volumes of the list, for items and groups of items.
    pub enum Bounds {
        /// None: every item is tested against every ray.
        None = "none",
        /// Spheres around their boxes.
        Sphere = "sphere",
        /// Axis-aligned boxes.
        Box = "box",
    }
}

impl Accel {
    /// The structure; `None` for `auto`.
    pub fn explicit_kind(self) -> Option<AccelKind> {
        AccelKind::from_name(self.name())
    }

    /// The option that makes settings of these structures unused, if any.
    pub(crate) fn rules_out(self, kinds: &[AccelKind]) -> Option<String> {
        self.explicit_kind().filter(|kind| !kinds.contains(kind)).map(|kind| format!("--accel {kind}"))
    }
}

impl Walk {
    /// The option that makes the capacity of the priority queue unused, if any.
    pub(crate) fn rules_out_heap(self) -> Option<String> {
        (self != Walk::Heap).then(|| format!("--walk {self}"))
    }
}

impl From<AccelKind> for Accel {
    fn from(kind: AccelKind) -> Self {
        Accel::from_name(kind.name()).unwrap_or(Accel::Auto)
    }
}

/// The settings of the acceleration structure. They change the time, never the picture. All fields have a value, also
/// those that the structure does not use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AccelSettings {
    /// The acceleration structure.
    pub accel: Accel,
    /// The traversal order of the BVH.
    pub walk: Walk,
    /// The capacity of the priority queue of [`Walk::Heap`]: one of [`HEAP_ENTRIES`].
    pub heap: usize,
    /// The bounding volumes of the list.
    pub bounds: Bounds,
    /// The slots of the mailbox of grid and octree: one of [`MAILBOX_SLOTS`].
    pub mailbox: usize,
}

impl AccelSettings {
    /// `auto`, with default settings.
    pub const DEFAULT: AccelSettings = AccelSettings {
        accel: Accel::Auto,
        walk: Walk::Stack,
        heap: DEFAULT_HEAP_ENTRIES,
        bounds: Bounds::Box,
        mailbox: DEFAULT_MAILBOX_SLOTS,
    };

    /// This structure, with default settings.
    pub fn with_kind(kind: AccelKind) -> Self {
        AccelSettings { accel: kind.into(), ..AccelSettings::DEFAULT }
    }

    /// A BVH that is traversed with a priority queue of this capacity.
    pub fn with_heap(heap: usize) -> Self {
        AccelSettings { walk: Walk::Heap, heap, ..AccelSettings::with_kind(AccelKind::Bvh) }
    }

    /// Every structure with every value of the settings that it uses.
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

    /// Selects the structure for a scene with `items` bounded items.
    pub fn resolve(&self, items: usize) -> ResolvedAccel {
        let (kind, reason) = match self.accel.explicit_kind() {
            Some(kind) => (kind, "as requested"),
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

/// A selected acceleration structure with its settings. All fields have a value, also those that it does not use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ResolvedAccel {
    /// The acceleration structure.
    pub kind: AccelKind,
    /// Why it was selected.
    pub reason: &'static str,
    /// The traversal order of the BVH.
    pub walk: Walk,
    /// The capacity of the priority queue.
    pub heap: usize,
    /// The bounding volumes of the list.
    pub bounds: Bounds,
    /// The slots of the mailbox.
    pub mailbox: usize,
}

/// Shows the structure with the setting that it uses.
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
    fn every_structure_can_be_requested() {
        for kind in AccelKind::ALL {
            assert_eq!(Accel::from(kind).explicit_kind(), Some(kind));
        }
        assert_eq!(Accel::Auto.explicit_kind(), None);
        assert_eq!(AccelSettings::all_variants().len(), 3 + 3 + 3 + 5);
    }

    #[test]
    fn auto_selects_the_list_for_few_items_and_the_bvh_for_many() {
        let kind = |items| AccelSettings::DEFAULT.resolve(items).kind;
        assert_eq!([0, 8, 9].map(kind), [AccelKind::List, AccelKind::List, AccelKind::Bvh]);
        assert_eq!(AccelSettings::with_kind(AccelKind::Grid).resolve(0).kind, AccelKind::Grid);
    }
}
