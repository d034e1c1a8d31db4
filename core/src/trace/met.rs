//! What camera rays met.

use crate::geometry::ItemId;

/// What a camera ray met, or all the camera rays of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Met {
    /// Nothing.
    Nothing,
    /// This item.
    Item(ItemId),
    /// Not all of them the same.
    Several,
}

impl Met {
    /// What was met here and there.
    pub fn and(self, other: Met) -> Met {
        if self == other { self } else { Met::Several }
    }
}
