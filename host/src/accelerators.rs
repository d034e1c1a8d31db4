//! The accelerators of this program, for either precision: what is asked for becomes a type.
//!
//! This is the one room that knows every accelerator. It lends each the memory that it needs,
//! builds it, and hands it to whoever has a use for one, so that whatever is done with it is
//! compiled for its type. For another accelerator: a name in [`finding`](crate::finding), and an
//! arm here.
//!
//! Sizes that are constants of a type come from short lists ([`MAILBOXES`], [`HEAPS`]). Only what is
//! taken where nobody asks for anything is handed to [`Purpose::with`]. What is asked for by name goes to
//! [`Purpose::asked`] and whatever is not of the usual size to [`Purpose::seldom`], which need not be
//! compiled in as many variants.
//!
//! [`MAILBOXES`]: crate::finding::MAILBOXES
//! [`HEAPS`]: crate::finding::HEAPS

use std::time::Instant;

use super::strahl::{
    Aabb, Accelerator, Ball, BvhRoom, Geometry, Grid, GridRoom, Grown, LastFirst, Leaves, List, NearestFirst,
    Node, Octree, OctreeNode, OctreeRoom, Run, Scene, Slot, Waiting, groups_of,
};
use crate::finding::{Bounds, Choice, Facts, Finding, Kind, MAILBOX, STACK, Walk};

/// A use for an accelerator, whatever its type.
pub trait Purpose: Sized {
    /// What comes of it.
    type Answer;

    /// Uses it.
    fn with<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> Self::Answer;

    /// Uses one that is only taken where it is asked for.
    fn asked<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> Self::Answer {
        self.with(accelerator, facts)
    }

    /// Uses one that only somebody asks for who compares.
    fn seldom<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> Self::Answer {
        self.with(accelerator, facts)
    }
}

/// Any use is one that is asked for.
struct Asked<P>(P);

impl<P: Purpose> Purpose for Asked<P> {
    type Answer = P::Answer;

    fn with<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> P::Answer {
        self.0.asked(accelerator, facts)
    }
}

/// Any use is a seldom one.
struct Seldom<P>(P);

impl<P: Purpose> Purpose for Seldom<P> {
    type Answer = P::Answer;

    fn with<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> P::Answer {
        self.0.seldom(accelerator, facts)
    }
}

/// Why there is no accelerator.
pub type NotBuilt = Box<dyn std::error::Error + Send + Sync>;

/// Builds the accelerator that is asked for, or one that suits the scene, and uses it.
pub fn build<P: Purpose>(scene: &Scene<'_>, finding: &Finding, purpose: P) -> Result<P::Answer, NotBuilt> {
    let clock = Instant::now();
    let boxes: Vec<Aabb> = scene.parts().geometry.all_bounds().collect();
    let choice = finding.choice(boxes.iter().filter(|aabb| !aabb.is_empty()).count());
    let building = Building { geometry: &scene.parts().geometry, boxes: &boxes, choice, clock };
    let (asked, seldom) = (Asked, Seldom);
    match (choice.kind, choice.mailbox, choice.walk, choice.heap) {
        (Kind::List, ..) => building.list(purpose),
        (Kind::Grid, MAILBOX, ..) => building.grid::<_, MAILBOX>(asked(purpose)),
        (Kind::Grid, 8, ..) => building.grid::<_, 8>(seldom(purpose)),
        (Kind::Grid, ..) => building.grid::<_, 0>(seldom(purpose)),
        (Kind::Octree, MAILBOX, ..) => building.octree::<_, MAILBOX>(asked(purpose)),
        (Kind::Octree, 8, ..) => building.octree::<_, 8>(seldom(purpose)),
        (Kind::Octree, ..) => building.octree::<_, 0>(seldom(purpose)),
        (Kind::Bvh, _, Walk::Stack, _) => building.bvh::<P, LastFirst<STACK>>(purpose),
        (Kind::Bvh, _, Walk::Heap, 64) => building.bvh::<_, NearestFirst<64>>(seldom(purpose)),
        (Kind::Bvh, _, Walk::Heap, 4) => building.bvh::<_, NearestFirst<4>>(seldom(purpose)),
        (Kind::Bvh, _, Walk::Heap, 1) => building.bvh::<_, NearestFirst<1>>(seldom(purpose)),
        (Kind::Bvh, _, Walk::Heap, _) => building.bvh::<_, NearestFirst<0>>(seldom(purpose)),
    }
}

/// What an accelerator is built of.
struct Building<'b> {
    geometry: &'b Geometry<'b>,
    boxes: &'b [Aabb],
    choice: Choice,
    clock: Instant,
}

/// How much of it there is.
struct Extent {
    bytes: usize,
    regions: usize,
    entries: usize,
    depth: Option<u32>,
}

impl Building<'_> {
    fn facts(&self, extent: Extent) -> Facts {
        let Extent { bytes, regions, entries, depth } = extent;
        Facts { choice: self.choice, bytes, regions, entries, depth, build: self.clock.elapsed() }
    }

    fn list<P: Purpose>(self, purpose: P) -> Result<P::Answer, NotBuilt> {
        let entries = self.boxes.len();
        let (mut groups, mut balls, mut ball_groups, regions);
        let list = match self.choice.bounds {
            Bounds::None => {
                regions = 1;
                List::bare(entries as u32)
            }
            Bounds::Sphere => {
                regions = groups_of(entries);
                (balls, ball_groups) = (vec![Ball::EMPTY; entries], vec![Ball::EMPTY; regions]);
                List::balled(self.boxes, &mut balls, &mut ball_groups)?
            }
            Bounds::Box => {
                regions = groups_of(entries);
                groups = vec![Aabb::EMPTY; regions];
                List::boxed(self.boxes, &mut groups)?
            }
        };
        let extent = Extent { bytes: list.bytes(), regions, entries, depth: None };
        Ok(purpose.with(list, self.facts(extent)))
    }

    fn grid<P: Purpose, const MAILBOX: usize>(self, purpose: P) -> Result<P::Answer, NotBuilt> {
        let room = GridRoom::comfortable(self.boxes);
        let (mut cells, mut items) = (vec![0; room.cells], vec![0; room.items]);
        let grid = Grid::<MAILBOX>::build(self.boxes, &mut cells, &mut items)?;
        let (bytes, regions, entries) = (grid.bytes(), grid.regions(), grid.entries());
        Ok(purpose.with(grid, self.facts(Extent { bytes, regions, entries, depth: None })))
    }

    fn octree<P: Purpose, const MAILBOX: usize>(self, purpose: P) -> Result<P::Answer, NotBuilt> {
        let room = OctreeRoom::comfortable(self.boxes.len());
        let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; room.nodes], vec![0; room.items]);
        let tree = Octree::<MAILBOX>::build(self.boxes, &mut nodes, &mut items)?;
        let (bytes, regions, entries) = (tree.bytes(), tree.regions(), tree.entries());
        let depth = Some(u32::from(tree.depth()));
        Ok(purpose.with(tree, self.facts(Extent { bytes, regions, entries, depth })))
    }

    fn bvh<P: Purpose, W: Waiting>(self, purpose: P) -> Result<P::Answer, NotBuilt> {
        let room = BvhRoom::comfortable(self.boxes.len());
        let (mut nodes, mut items) = (vec![Node::EMPTY; room.nodes], vec![Slot::EMPTY; room.items]);
        let grown = Grown::build(self.boxes, Leaves::Runs(self.geometry), &mut nodes, &mut items)?;
        let mut runs = vec![Run::EMPTY; grown.runs()];
        let tree = grown.in_runs::<W>(self.geometry, &mut runs)?;
        let (bytes, regions, entries) = (tree.bytes(), tree.regions(), tree.entries());
        let depth = Some(tree.depth());
        Ok(purpose.with(tree, self.facts(Extent { bytes, regions, entries, depth })))
    }
}
