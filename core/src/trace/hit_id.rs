//! What camera rays hit.

use crate::geometry::ItemId;

/// What a camera ray hit, or all the camera rays of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HitId {
    /// Nothing.
    Nothing,
    /// This item.
    Item(ItemId),
    /// Not all of them the same.
    Several,
}

impl HitId {
    /// What both hit, or [`HitId::Several`].
    pub fn and(self, other: HitId) -> HitId {
        if self == other { self } else { HitId::Several }
    }
}
