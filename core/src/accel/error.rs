//! Why an accelerator could not be built.

use core::fmt;

use crate::geometry::ItemId;

/// The buffers that callers provide to accelerators, as named in a [`BuildError`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Buffer {
    /// Bounding boxes or spheres of items.
    ItemBounds,
    /// Bounding boxes or spheres of groups of items.
    GroupBounds,
    /// Starts of the lists of a grid's cells.
    Cells,
    /// Nodes of a tree.
    Nodes,
    /// Entries of the leaves of a tree or of the cells of a grid.
    Entries,
    /// Triangle blocks of the leaves of a BVH.
    TriangleBlocks,
}

/// Why an accelerator could not be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuildError {
    /// Even the coarsest structure needs more than was provided.
    BufferTooSmall {
        /// The buffer that is too small.
        buffer: Buffer,
        /// Number of elements that are needed.
        needed: usize,
        /// Number of elements that were provided.
        provided: usize,
    },
    /// The bounds of an item are not finite.
    NotFinite {
        /// The item.
        item: ItemId,
    },
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::BufferTooSmall { buffer, needed, provided } => {
                let name = match buffer {
                    Buffer::ItemBounds => "item bounds",
                    Buffer::GroupBounds => "group bounds",
                    Buffer::Cells => "cells",
                    Buffer::Nodes => "nodes",
                    Buffer::Entries => "entries",
                    Buffer::TriangleBlocks => "triangle blocks",
                };
                write!(f, "{name}: {needed} needed, {provided} provided")
            }
            BuildError::NotFinite { item } => write!(f, "item {}: its bounds are not finite", item.0),
        }
    }
}

impl core::error::Error for BuildError {}
