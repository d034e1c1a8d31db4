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
    Mixed,
}

impl HitId {
    /// What both hit, or [`HitId::Several`].
    pub fn merged(self, other: HitId) -> HitId {
        if self == other { self } else { HitId::Mixed }
    }
}
