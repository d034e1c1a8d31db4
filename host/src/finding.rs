//! How items are found: what can be asked for, what is chosen, and what comes of it.
//!
//! `auto` takes the hierarchy, and for few items the list (`tests/reports/auto.md`).

use std::fmt;

use clap::ValueEnum;

/// The slots of mailboxes that there are; 0 is none.
pub const MAILBOXES: [usize; 3] = [0, 8, MAILBOX];

/// The usual slots of a mailbox.
pub const MAILBOX: usize = 64;

/// The places of heaps that there are.
pub const HEAPS: [usize; 4] = [0, 1, 4, HEAP];

/// The usual places of a heap.
pub const HEAP: usize = 64;

/// The places of a stack: no hierarchy is deeper.
pub const STACK: usize = 64;

/// For so many items a hierarchy is not worth its making.
const FEW: usize = 8;

/// Those whose walk is a choice.
const WALKED: &[Kind] = &[Kind::Bvh];
/// Those that may do without bounds.
const BOUNDED: &[Kind] = &[Kind::List];
/// Those that have a mailbox.
const REMEMBERING: &[Kind] = &[Kind::Grid, Kind::Octree];

/// How items are found. None of it changes an answer, all of it the time. What is not said is
/// chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Finding {
    /// The accelerator.
    pub accel: Option<Accel>,
    /// How a hierarchy is walked.
    pub walk: Option<Walk>,
    /// The places of the heap: one of [`HEAPS`].
    pub heap: Option<usize>,
    /// What the list puts round items and groups of them.
    pub bounds: Option<Bounds>,
    /// The slots of the mailbox of grid and octree: one of [`MAILBOXES`].
    pub mailbox: Option<usize>,
}

impl Finding {
    /// By this accelerator, everything else as usual.
    pub fn by(kind: Kind) -> Finding {
        Finding { accel: Some(kind.into()), ..Finding::default() }
    }

    /// All ways to find the same.
    pub fn every() -> Vec<Finding> {
        let each = |kind| match kind {
            Kind::List => [Bounds::None, Bounds::Sphere, Bounds::Box]
                .map(|bounds| Finding { bounds: Some(bounds), ..Finding::by(kind) })
                .to_vec(),
            Kind::Grid | Kind::Octree => {
                MAILBOXES.map(|slots| Finding { mailbox: Some(slots), ..Finding::by(kind) }).to_vec()
            }
            Kind::Bvh => {
                let heaps = HEAPS.map(|places| Finding { heap: Some(places), ..Finding::by(kind) });
                [&[Finding { walk: Some(Walk::Stack), ..Finding::by(kind) }], &heaps[..]].concat()
            }
        };
        Kind::ALL.into_iter().flat_map(each).collect()
    }

    /// This, and where it says nothing, `other`; without what the accelerator has no use for.
    pub fn or(self, other: Finding) -> Finding {
        // Who asks for another walk does not ask for the places of that one.
        let heap = if self.walk.is_some() { self.heap } else { self.heap.or(other.heap) };
        let walk = if self.heap.is_some() { self.walk } else { self.walk.or(other.walk) };
        let accel = self.accel.or(other.accel);
        let is_for = |kinds: &[Kind]| accel.and_then(Accel::kind).is_none_or(|kind| kinds.contains(&kind));
        Finding {
            accel,
            walk: walk.filter(|_| is_for(WALKED)),
            heap: heap.filter(|_| is_for(WALKED)),
            bounds: self.bounds.or(other.bounds).filter(|_| is_for(BOUNDED)),
            mailbox: self.mailbox.or(other.mailbox).filter(|_| is_for(REMEMBERING)),
        }
    }

    /// The same with everything said that has a meaning.
    pub fn in_force(&self) -> Finding {
        let Choice { walk, heap, bounds, mailbox, .. } = self.choice(0);
        let all = Finding {
            accel: self.accel.or(Some(Accel::Auto)),
            walk: Some(walk),
            heap: (walk == Walk::Heap).then_some(heap),
            bounds: Some(bounds),
            mailbox: Some(mailbox),
        };
        all.or(Finding::default())
    }

    /// What is asked for that the accelerator has no use for.
    pub fn misfit(&self) -> Option<String> {
        if self.walk == Some(Walk::Stack) && self.heap.is_some() {
            return Some("the places of a heap are for --walk heap".into());
        }
        let kind = self.accel?.kind()?;
        let asked = [
            ("walk", self.walk.is_some(), WALKED),
            ("heap", self.heap.is_some(), WALKED),
            ("bounds", self.bounds.is_some(), BOUNDED),
            ("mailbox", self.mailbox.is_some(), REMEMBERING),
        ];
        let (name, ..) =
            asked.into_iter().find(|(_, is_asked, kinds)| *is_asked && !kinds.contains(&kind))?;
        Some(format!("--{name} has no meaning for --accel {kind}"))
    }

    /// The choice for a scene with so many items that have an end.
    pub fn choice(&self, items: usize) -> Choice {
        let (kind, reason) = match self.accel.and_then(Accel::kind) {
            Some(kind) => (kind, "as asked for"),
            None if items <= FEW => (Kind::List, "few items"),
            None => (Kind::Bvh, "many items"),
        };
        let walk = self.walk.unwrap_or(if self.heap.is_some() { Walk::Heap } else { Walk::Stack });
        Choice {
            kind,
            reason,
            walk,
            heap: self.heap.unwrap_or(HEAP),
            bounds: self.bounds.unwrap_or(Bounds::Box),
            mailbox: self.mailbox.unwrap_or(MAILBOX),
        }
    }
}

/// An accelerator, or the wish for one that suits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Accel {
    /// What suits the scene.
    Auto,
    /// Every item in turn.
    List,
    /// Equal cells, walked one by one.
    Grid,
    /// Space cut into eighths where there are many items.
    Octree,
    /// A hierarchy of boxes.
    Bvh,
}

impl Accel {
    /// Which; none when it is to be found out.
    pub fn kind(self) -> Option<Kind> {
        match self {
            Accel::Auto => None,
            Accel::List => Some(Kind::List),
            Accel::Grid => Some(Kind::Grid),
            Accel::Octree => Some(Kind::Octree),
            Accel::Bvh => Some(Kind::Bvh),
        }
    }
}

/// An accelerator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // as of `Accel`
pub enum Kind {
    List,
    Grid,
    Octree,
    Bvh,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Kind; 4] = [Kind::List, Kind::Grid, Kind::Octree, Kind::Bvh];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Kind::List => "list",
            Kind::Grid => "grid",
            Kind::Octree => "octree",
            Kind::Bvh => "bvh",
        }
    }
}

impl From<Kind> for Accel {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::List => Accel::List,
            Kind::Grid => Accel::Grid,
            Kind::Octree => Accel::Octree,
            Kind::Bvh => Accel::Bvh,
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// How a hierarchy is walked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Walk {
    /// The nearest of all that waits comes next.
    Heap,
    /// The nearer of two halves comes next.
    Stack,
}

/// What the list puts round items and groups of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Bounds {
    /// Nothing: every item is held against every ray.
    None,
    /// Spheres round their boxes.
    Sphere,
    /// Boxes.
    Box,
}

/// A choice of everything. What has no meaning for the accelerator is there all the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The accelerator.
    pub kind: Kind,
    /// Why it was taken.
    pub reason: &'static str,
    /// How a hierarchy is walked.
    pub walk: Walk,
    /// The places of the heap.
    pub heap: usize,
    /// What the list puts round items.
    pub bounds: Bounds,
    /// The slots of the mailbox.
    pub mailbox: usize,
}

/// With what has a meaning for it.
impl fmt::Display for Choice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = self.kind;
        match kind {
            Kind::List => match self.bounds {
                Bounds::None => write!(f, "{kind} without bounds"),
                Bounds::Sphere => write!(f, "{kind} with spheres"),
                Bounds::Box => write!(f, "{kind} with boxes"),
            },
            Kind::Grid | Kind::Octree => match self.mailbox {
                0 => write!(f, "{kind} without mailbox"),
                slots => write!(f, "{kind} with a mailbox of {slots}"),
            },
            Kind::Bvh => match self.walk {
                Walk::Heap => write!(f, "{kind} with a heap of {}", self.heap),
                Walk::Stack => write!(f, "{kind} with a stack"),
            },
        }
    }
}
