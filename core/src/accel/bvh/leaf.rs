//! What leaves are made of: single items, or runs of them.

use core::ops::ControlFlow;

use super::node::Slot;
use super::run::Run;
use crate::accel::Query;

/// A piece of a leaf. Pieces follow each other up to the last of their leaf.
pub trait Leaf: Copy {
    /// Offers its items.
    fn offer<Q: Query>(&self, query: &mut Q) -> ControlFlow<()>;

    /// Whether it is the last piece of its leaf.
    fn is_last(&self) -> bool;

    /// How many items it has.
    fn count(&self) -> usize;
}

impl Leaf for Slot {
    #[inline(always)]
    fn offer<Q: Query>(&self, query: &mut Q) -> ControlFlow<()> {
        query.test(self.item())
    }

    #[inline(always)]
    fn is_last(&self) -> bool {
        Slot::is_last(*self)
    }

    fn count(&self) -> usize {
        1
    }
}

impl Leaf for Run {
    #[inline(always)]
    fn offer<Q: Query>(&self, query: &mut Q) -> ControlFlow<()> {
        query.run(self)
    }

    #[inline(always)]
    fn is_last(&self) -> bool {
        !self.goes_on()
    }

    fn count(&self) -> usize {
        self.items().count()
    }
}
