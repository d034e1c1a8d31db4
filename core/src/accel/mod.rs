//! Spatial acceleration structures, and the two traits between them and the scene.
//!
//! An [`Accelerator`] stores bounds and item ids, never shapes. It traverses its nodes or cells along a ray,
//! roughly front to back, and passes their items to a [`Query`], which intersects them. The query owns
//! `t_max`; an accelerator skips only what begins strictly beyond it, because of two items at the same `t`
//! the one with the lower [`ItemId`] wins. Nearest-hit and any-hit queries use the same traversal: the first
//! kind reduces `t_max` at each hit, the second kind breaks at the first hit.
//!
//! * An item may be passed more than once, and items in any order: the result is the same.
//! * An item whose bounds the ray hits within `t_max`, by [`Aabb::intersect`], is always passed.
//! * Unbounded items (planes) are not in an accelerator; the scene tests them itself.
//!
//! # Choosing an accelerator
//!
//! Measured on scenes of 11 to 1,000,000 items (`tests/reports/accelerators.md`), and beside other crates
//! (`tests/bench`):
//!
//! * [`ListWithoutBounds`] or [`List`] for a handful of items: no construction and little code. From about ten items
//!   on a BVH is faster; up to some hundred, a list with boxes is about as fast as grid and octree.
//! * [`Bvh`] for everything else, unless there is a reason against it: the fastest on every measured scene,
//!   and its time grows slowest with the number of items, like that of the octree. It needs about 60 bytes
//!   per item, half as much again as the octree, and takes the longest to build. Its queue is best a stack
//!   ([`TraversalStack`]); the heap ([`TraversalHeap`]) visits hardly fewer nodes and takes longer per node.
//!   Triangles are best stored in [`TriangleBlock`]s, if there is memory for them.
//! * [`Octree`] where memory is small and sizes of items differ: 8 bytes per node, and a traversal by
//!   integers.
//! * [`Grid`] for many items of similar size that are evenly spread: fast to build, and few operations per
//!   cell. Where small items are close together in a large scene, a few cells hold nearly all of them, and
//!   the time grows with their number.
//!
//! A [`Mailbox`] is worth its memory where items overlap many cells and are expensive to test. A BVH needs
//! none: it stores each item once.
//!
//! [`Aabb::intersect`]: crate::geometry::Aabb::intersect
//! [`ItemId`]: crate::geometry::ItemId

mod accelerator;
mod bvh;
mod cell_planes;
#[cfg(not(feature = "double"))]
mod error;
mod grid;
mod list;
mod mailbox;
mod octree;
#[cfg(not(feature = "double"))]
mod size;
#[cfg(test)]
mod test_rays;
mod triangle_block;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::accel::{self as error, self as size};

pub use accelerator::{Accelerator, Query};
#[cfg(feature = "baked")]
pub(crate) use bvh::BvhParts;
pub use bvh::{
    Bvh, BvhBuilder, BvhEntry, BvhNode, LeafElement, LeafLayout, TraversalHeap, TraversalQueue,
    TraversalStack,
};
pub use error::{Buffer, BuildError};
#[cfg(feature = "baked")]
pub(crate) use grid::GridParts;
pub use grid::{Grid, GridSize, StaticGrid};
pub use list::{List, ListWithoutBounds, group_count};
pub use mailbox::Mailbox;
#[cfg(feature = "baked")]
pub(crate) use octree::OctreeParts;
pub use octree::{Octree, OctreeNode};
pub use size::{BvhSize, OctreeLimits, OctreeSize};
pub(crate) use triangle_block::Candidate;
pub use triangle_block::TriangleBlock;
