//! The elements of leaves: single entries, or blocks of triangles.

use core::ops::ControlFlow;

use super::node::BvhEntry;
use super::sealed::Sealed;
use crate::accel::{Query, TriangleBlock};

/// An element of a leaf. The elements of a leaf are consecutive; the last one is marked.
///
/// Sealed: [`BvhBuilder`](super::BvhBuilder) makes leaves of [`BvhEntry`]s or of [`TriangleBlock`]s.
pub trait LeafElement: Copy + Sealed {
    /// Passes its items to `query`.
    fn test_items<Q: Query>(&self, query: &mut Q) -> ControlFlow<()>;

    /// Whether it is the last element of its leaf.
    fn is_last(&self) -> bool;

    /// Number of its items.
    fn item_count(&self) -> usize;
}

impl Sealed for BvhEntry {}

impl LeafElement for BvhEntry {
    #[inline(always)]
    fn test_items<Q: Query>(&self, query: &mut Q) -> ControlFlow<()> {
        query.test_item(self.item())
    }

    #[inline(always)]
    fn is_last(&self) -> bool {
        BvhEntry::is_last(*self)
    }

    fn item_count(&self) -> usize {
        1
    }
}

impl Sealed for TriangleBlock {}

impl LeafElement for TriangleBlock {
    #[inline(always)]
    fn test_items<Q: Query>(&self, query: &mut Q) -> ControlFlow<()> {
        query.test_block(self)
    }

    #[inline(always)]
    fn is_last(&self) -> bool {
        !self.has_next()
    }

    fn item_count(&self) -> usize {
        self.items().count()
    }
}
