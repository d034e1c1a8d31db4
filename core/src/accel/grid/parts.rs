//! A grid in parts, as a baked scene holds it.

use super::Grid;
use crate::accel::cell_planes::CellPlanes;
use crate::geometry::Aabb;
use crate::math::{Real, vec3};

/// What makes a grid, and nothing that follows from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GridParts<'s> {
    pub(crate) bounds: Aabb,
    pub(crate) cells: [u32; 3],
    pub(crate) starts: &'s [u32],
    pub(crate) items: &'s [u32],
}

impl<'s, const MAILBOX: usize> Grid<'s, MAILBOX> {
    pub(crate) const fn parts(&self) -> GridParts<'s> {
        GridParts { bounds: self.bounds, cells: self.cells, starts: self.starts, items: self.items }
    }

    /// The grid of parts, for a scene of `count` items; none when an index is out of range.
    pub(crate) fn from_parts(parts: GridParts<'s>, count: u32) -> Option<Self> {
        let GridParts { bounds, cells, starts, items } = parts;
        let [x, y, z] = cells;
        let product = x.checked_mul(y)?.checked_mul(z)?;
        let fits = product > 0 && starts.len() == product.checked_add(1)? as usize;
        let rises = starts.iter().zip(starts.iter().skip(1)).all(|(a, b)| a <= b);
        let ends = starts.last().is_some_and(|end| *end as usize == items.len());
        let known = items.iter().all(|item| *item < count);
        if !(fits && rises && ends && known && (bounds.is_finite() || items.is_empty())) {
            return None;
        }
        let around = if items.is_empty() { Aabb::POINT } else { bounds };
        let walls = CellPlanes::new(around, vec3(x as Real, y as Real, z as Real));
        Some(Grid { bounds, walls, cells, starts, items, boxes: &[] })
    }
}
