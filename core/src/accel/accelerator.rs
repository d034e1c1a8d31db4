//! The two sides of a traversal: the accelerator, and the query that it passes items to.
//!
//! The contract between them is in the head of [`accel`].
//!
//! [`accel`]: super

use core::ops::ControlFlow;

use super::triangle_block::TriangleBlock;
use crate::geometry::{ItemId, Ray};
use crate::math::Real;

/// A spatial data structure over the bounds of items.
pub trait Accelerator {
    /// Scratch memory of a traversal. Each worker has its own; dropping it between two rays changes only the
    /// time.
    type Scratch: Default;

    /// Passes the items whose bounds the ray hits to `query`, until it breaks or all others begin beyond
    /// [`Query::t_max`].
    fn traverse<Q: Query>(&self, ray: &Ray, scratch: &mut Self::Scratch, query: &mut Q);
}

/// A search along a ray: it knows the shapes of items, and what counts as a result.
pub trait Query {
    /// Whether visiting nearer items first saves tests. If false, an accelerator may visit them in any order.
    const ORDERED: bool = true;

    /// Largest `t` at which a hit is still accepted, in lengths of the ray's direction. Finite; never
    /// increases during a query.
    fn t_max(&self) -> Real;

    /// Tests an item. `Break` ends the traversal.
    fn test_item(&mut self, item: ItemId) -> ControlFlow<()>;

    /// Tests the items `0..count`, in this order. `Break` ends the traversal.
    fn test_first(&mut self, count: u32) -> ControlFlow<()> {
        (0..count).try_for_each(|item| self.test_item(ItemId(item)))
    }

    /// Tests the items of a block. `Break` ends the traversal.
    fn test_block(&mut self, block: &TriangleBlock) -> ControlFlow<()> {
        block.items().try_for_each(|item| self.test_item(item))
    }

    /// Counts `count` tests of the ray against bounding boxes or spheres.
    fn count_box_tests(&mut self, count: u32);

    /// Counts a visit of a leaf, a cell, or a group of a list.
    fn count_leaf_visit(&mut self);

    /// Counts an item that was not tested, because the mailbox had it already.
    fn count_mailbox_hit(&mut self);
}
