//! Conversion between a grid and the tables of a baked scene.

use super::Grid;
use crate::accel::cell_planes::CellPlanes;
use crate::geometry::Aabb;
use crate::math::{Real, vec3};

/// The data of a grid that a baked scene stores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GridParts<'s> {
    pub(crate) bounds: Aabb,
    pub(crate) resolution: [u32; 3],
    pub(crate) cell_starts: &'s [u32],
    pub(crate) entries: &'s [u32],
}

impl<'s, const MAILBOX_ENTRIES: usize> Grid<'s, MAILBOX_ENTRIES> {
    pub(crate) const fn parts(&self) -> GridParts<'s> {
        GridParts {
            bounds: self.bounds,
            resolution: self.resolution,
            cell_starts: self.cell_starts,
            entries: self.entries,
        }
    }

    /// The grid of these parts, for a scene of `count` items. `None` if an index is out of range or the lists
    /// of the cells do not follow each other.
    pub(crate) fn from_parts(parts: GridParts<'s>, count: u32) -> Option<Self> {
        let GridParts { bounds, resolution, cell_starts, entries } = parts;
        let [x, y, z] = resolution;
        let cell_count = x.checked_mul(y)?.checked_mul(z)?;
        let is_complete = cell_count > 0 && cell_starts.len() == cell_count.checked_add(1)? as usize;
        let is_sorted = cell_starts.iter().zip(cell_starts.iter().skip(1)).all(|(a, b)| a <= b);
        let ends_with_entries = cell_starts.last().is_some_and(|end| *end as usize == entries.len());
        let are_in_range = entries.iter().all(|item| *item < count);
        let has_bounds = bounds.is_finite() || entries.is_empty();
        if !(is_complete && is_sorted && ends_with_entries && are_in_range && has_bounds) {
            return None;
        }
        let divided = if entries.is_empty() { Aabb::ORIGIN } else { bounds };
        let planes = CellPlanes::new(divided, vec3(x as Real, y as Real, z as Real));
        Some(Grid { bounds, planes, resolution, cell_starts, entries, item_bounds: &[] })
    }
}
