//! Finding what a ray may meet: the contract between those who know where items lie and those
//! who know what they are.
//!
//! An [`Accelerator`] sees boxes and numbers of items, never shapes. It walks along a ray and
//! offers items to a [`Query`], nearer ones first as far as it knows. The query tests them,
//! and is the only owner of the far limit: an accelerator asks for [`Query::reach`] and leaves
//! out only what begins strictly *beyond* it, because of two items equally far away the one
//! with the lower number wins.
//!
//! One walk serves both questions that a ray tracer asks. The nearest item: the query shortens
//! its reach at every hit and goes on. Any item in the way of light: it breaks at the first.
//!
//! * An item may be offered more than once, and items in any order: the answer is the same.
//! * An item within reach, whose box the ray meets by [`Aabb::span`], is never withheld.
//! * Unbounded items (planes) are no business of an accelerator.
//!
//! # When to choose which
//!
//! Measured on scenes of 11 to 1,000,000 objects (`tests/reports/accelerators.md`, and `tests/bench` for
//! single rays beside other crates):
//!
//! * [`Bare`] or [`List`] for a handful of items: nothing to build, next to no code. From about
//!   ten items on a hierarchy is quicker; up to some hundreds a list with boxes still keeps up
//!   with grid and octree.
//! * [`Bvh`] for everything else, unless there is a reason: the quickest on every scene measured, and
//!   its time grows slowest with their number, as the octree's does. It takes some 60 bytes for
//!   each item, half as much again as the octree, and is the slowest to build. By a stack
//!   ([`LastFirst`]); the heap ([`NearestFirst`]) visits hardly fewer nodes and takes longer for
//!   each. Triangles go into [`Run`]s where there is the memory for it.
//! * [`Octree`] where memory has to be small and in one piece, and sizes differ: 8 bytes a node,
//!   steps of whole numbers.
//! * [`Grid`] for many items of like size that are evenly spread: quick to build, and walked in
//!   few operations a cell. Where small things stand in much space (`balls`, `tree`, a teapot in a
//!   stadium) nearly all of them share a few cells, and the time grows with their number.
//!
//! A [`Mailbox`] pays where items reach through many cells and are dear to test; it never pays in
//! a hierarchy, which offers each item once.
//!
//! [`Aabb::span`]: crate::geometry::Aabb::span

mod bvh;
mod cell_planes;
mod grid;
mod list;
mod mailbox;
mod octree;
#[cfg(test)]
mod test_rays;

#[cfg(not(feature = "double"))]
pub(crate) use bvh::BvhParts;
pub(crate) use bvh::Candidate;
pub use bvh::{Bvh, BvhRoom, Grown, LastFirst, Leaf, Leaves, NearestFirst, Node, Run, Slot, Waiting};
#[cfg(not(feature = "double"))]
pub(crate) use grid::GridParts;
pub use grid::{Grid, GridRoom, StaticGrid};
pub use list::{Bare, List, groups_of};
pub use mailbox::Mailbox;
#[cfg(not(feature = "double"))]
pub(crate) use octree::OctreeParts;
pub use octree::{Octree, OctreeLimits, OctreeNode, OctreeRoom};

use core::fmt;
use core::ops::ControlFlow;

use crate::geometry::{ItemId, Ray};
use crate::math::Real;

/// Somebody who knows where items lie.
pub trait Accelerator {
    /// What a walk needs to remember. It belongs to the worker, and dropping it between two
    /// rays changes nothing but the time.
    type Scratch: Default;

    /// Offers the items along `ray` to `query`.
    fn walk<Q: Query>(&self, ray: &Ray, scratch: &mut Self::Scratch, query: &mut Q);
}

/// Somebody who knows what items are, and what is being looked for.
pub trait Query {
    /// Whether a nearer item spares the farther ones; else any order is as good.
    const ORDERED: bool = true;

    /// How far an item may be and still matter, in lengths of the ray's direction. Finite, and
    /// never grows.
    fn reach(&self) -> Real;

    /// An item that the ray may meet. `Break` when the walk may end.
    fn test(&mut self, item: ItemId) -> ControlFlow<()>;

    /// The items `0..count`, in their order. `Break` when the walk may end.
    fn all(&mut self, count: u32) -> ControlFlow<()> {
        (0..count).try_for_each(|item| self.test(ItemId(item)))
    }

    /// Items that lie together. `Break` when the walk may end.
    fn run(&mut self, run: &Run) -> ControlFlow<()> {
        run.items().try_for_each(|item| self.test(item))
    }

    /// This many boxes were held against the ray.
    fn boxes(&mut self, count: u32);

    /// A region was entered.
    fn enter(&mut self);

    /// An item was not offered, because this ray had been offered it before.
    fn skipped(&mut self);
}

/// Somebody who is told the regions along a ray.
///
/// No closure: a walk tells of regions at two places, the usual one and a rare one, and only the usual
/// one is to be inlined. What a closure holds would lie in memory for both.
trait Regions<R> {
    /// The ray is in this region. Answers with the reach that is left, or breaks.
    fn enter(&mut self, region: R) -> ControlFlow<(), Real>;
}

#[cfg(test)]
impl<R, F: FnMut(R) -> ControlFlow<(), Real>> Regions<R> for F {
    fn enter(&mut self, region: R) -> ControlFlow<(), Real> {
        self(region)
    }
}

/// Memory that a builder is lent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Storage {
    /// Boxes or balls round items.
    Boxes,
    /// Boxes or balls round groups of items.
    Groups,
    /// Where the lists of a grid's cells begin.
    Cells,
    /// Nodes of a tree.
    Nodes,
    /// Places for items in the leaves of a tree or the cells of a grid.
    Items,
    /// Runs of items.
    Runs,
}

/// Why an accelerator could not be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuildError {
    /// Even the coarsest structure needs more than was lent.
    StorageTooSmall {
        /// Of what there was too little.
        what: Storage,
        /// How many of them it takes.
        needed: usize,
        /// How many were lent.
        lent: usize,
    },
    /// The box of this item has no end, so that it has no place in space.
    NotFinite {
        /// Which.
        item: ItemId,
    },
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::StorageTooSmall { what, needed, lent } => {
                let what = match what {
                    Storage::Boxes => "boxes",
                    Storage::Groups => "groups",
                    Storage::Cells => "cells",
                    Storage::Nodes => "nodes",
                    Storage::Items => "places for items",
                    Storage::Runs => "runs",
                };
                write!(f, "{needed} {what} needed, {lent} lent")
            }
            BuildError::NotFinite { item } => write!(f, "object {}: its box has no end", item.0),
        }
    }
}

impl core::error::Error for BuildError {}
