//! The item that camera rays hit.

use crate::geometry::ItemId;

/// What the camera ray of a sample hit, or what all camera rays of a pixel hit.
///
/// Samplers use it to find edges of items; images of it are object masks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HitId {
    /// Nothing was hit.
    Nothing,
    /// This item was hit.
    Item(ItemId),
    /// The rays of the pixel did not all hit the same item.
    Mixed,
}

impl HitId {
    /// The common hit of two sets of rays: `self` if both are equal, otherwise [`HitId::Mixed`].
    ///
    /// ```
    /// use strahl_core::geometry::ItemId;
    /// use strahl_core::trace::HitId;
    ///
    /// let item = HitId::Item(ItemId(3));
    /// assert_eq!(item.same_or_mixed(item), item);
    /// assert_eq!(item.same_or_mixed(HitId::Nothing), HitId::Mixed);
    /// ```
    pub fn same_or_mixed(self, other: HitId) -> HitId {
        if self == other { self } else { HitId::Mixed }
    }
}
