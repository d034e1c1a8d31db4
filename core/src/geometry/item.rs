//! The number of an item.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

/// The number of an item: its place in the scene, counted from 0.
///
/// It is the number of the object in the scene file. Building an accelerator may reorder
/// items, but never renumbers them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, TryFromBytes, KnownLayout, Immutable)]
#[repr(transparent)]
pub struct ItemId(pub u32);
