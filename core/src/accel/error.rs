//! Why an accelerator could not be built.

use core::fmt;

use crate::geometry::ItemId;

/// Memory that a builder is lent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Storage {
    /// Boxes or balls round items.
    Boxes,
    /// Boxes or balls round groups of items.
    Groups,
    /// Where the lists of a grid's cells begin.
    Cells,
    /// Nodes of a tree.
    Nodes,
    /// Places for items in the leaves of a tree or the cells of a grid.
    Items,
    /// Runs of items.
    Runs,
}

/// Why an accelerator could not be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuildError {
    /// Even the coarsest structure needs more than was lent.
    StorageTooSmall {
        /// Of what there was too little.
        what: Storage,
        /// How many of them it takes.
        needed: usize,
        /// How many were lent.
        lent: usize,
    },
    /// The box of this item has no end, so that it has no place in space.
    NotFinite {
        /// Which.
        item: ItemId,
    },
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::StorageTooSmall { what, needed, lent } => {
                let what = match what {
                    Storage::Boxes => "boxes",
                    Storage::Groups => "groups",
                    Storage::Cells => "cells",
                    Storage::Nodes => "nodes",
                    Storage::Items => "places for items",
                    Storage::Runs => "runs",
                };
                write!(f, "{needed} {what} needed, {lent} lent")
            }
            BuildError::NotFinite { item } => write!(f, "object {}: its box has no end", item.0),
        }
    }
}

impl core::error::Error for BuildError {}
