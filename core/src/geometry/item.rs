//! Ids of items.

/// Index of an item (a shape with its material) in the table of shapes of its scene, from 0.
///
/// Accelerators may store items in another order, but never renumber them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(transparent)]
pub struct ItemId(pub u32);
