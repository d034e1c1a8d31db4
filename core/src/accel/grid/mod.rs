//! Uniform grid, traversed cell by cell along the ray.
//!
//! The bounds of the scene are divided into equal cells; each cell lists the items whose bounds overlap it.
//! Traversal keeps, per axis, the `t` of the next cell plane and steps over the nearest one. It ends when
//! that `t` exceeds `t_max`.
//!
//! An item may overlap many cells and be passed to the query again; the mailbox makes this rare, and the
//! [`Query`] contract makes it harmless.
//!
//! A grid suits items of similar size that are evenly spread. Where many small items lie close together in a
//! large scene, most of them share a cell at every resolution; an octree or a BVH adapts to such scenes.
//!
//! [`Query`]: super::Query

mod axis;
mod build;
#[cfg(feature = "baked")]
mod parts;
mod traverse;

pub use build::GridSize;
#[cfg(feature = "baked")]
pub(crate) use parts::GridParts;

use super::BuildError;
use super::cell_planes::CellPlanes;
use crate::geometry::Aabb;

/// A uniform grid in caller-provided buffers, whose traversal uses a mailbox of `MAILBOX_ENTRIES` entries.
///
/// * `MAILBOX_ENTRIES` is zero or a power of two.
/// * Memory: 4 bytes per cell, and 4 bytes per entry; an item has an entry in each cell that its bounds
///   overlap.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'s, const MAILBOX_ENTRIES: usize> {
    /// Union of the bounds of all items.
    bounds: Aabb,
    planes: CellPlanes,
    /// Number of cells along each axis.
    resolution: [u32; 3],
    /// Index of each cell's first entry; its entries end where those of the next cell begin. Cells are in
    /// rows along the x axis, rows in layers along y, layers along z.
    cell_starts: &'s [u32],
    /// Item indices of the cells, one cell after the other.
    entries: &'s [u32],
    /// Bounds by item index, or empty.
    item_bounds: &'s [Aabb],
}

impl<'s, const MAILBOX_ENTRIES: usize> Grid<'s, MAILBOX_ENTRIES> {
    /// The same grid with a mailbox of another size.
    pub const fn with_mailbox<const ENTRIES: usize>(self) -> Grid<'s, ENTRIES> {
        let Grid { bounds, planes, resolution, cell_starts, entries, item_bounds } = self;
        Grid { bounds, planes, resolution, cell_starts, entries, item_bounds }
    }

    /// The same grid without the bounds of items: it needs less memory, but each item of a cell is tested
    /// even if the ray misses its bounds.
    pub const fn without_item_bounds(self) -> Self {
        Grid { item_bounds: &[], ..self }
    }

    /// Number of cells along each axis.
    pub const fn resolution(&self) -> [u32; 3] {
        self.resolution
    }

    /// Number of cells.
    pub const fn cell_count(&self) -> usize {
        self.cell_starts.len().saturating_sub(1)
    }

    /// Number of entries of all cells; an item counts once per cell that lists it.
    pub const fn entry_count(&self) -> usize {
        self.entries.len()
    }

    /// Size of all buffers that it uses, in bytes: cells, entries and bounds of items.
    pub const fn size_in_bytes(&self) -> usize {
        size_of_val(self.cell_starts) + size_of_val(self.entries) + size_of_val(self.item_bounds)
    }

    /// Indices of the items in a cell.
    #[inline(always)]
    fn cell_entries(&self, cell: usize) -> &[u32] {
        let start = self.cell_starts.get(cell).copied().unwrap_or(0) as usize;
        let end = self.cell_starts.get(cell.wrapping_add(1)).copied().unwrap_or(0) as usize;
        self.entries.get(start..end).unwrap_or(&[])
    }
}

/// Buffers for a [`Grid`], of a size known at compile time.
///
/// `CELLS` and `ENTRIES` are at least those of a [`GridSize`], which can be computed in a constant:
///
/// ```
/// use strahl_core::accel::{GridSize, StaticGrid};
/// use strahl_core::geometry::Aabb;
/// use strahl_core::Vec3;
///
/// const ITEMS: usize = 3;
/// const SIZE: GridSize = GridSize::estimated(ITEMS);
/// let mut buffers = StaticGrid::<{ SIZE.cells }, { SIZE.entries }>::new();
/// let boxes = [Aabb { min: Vec3::ZERO, max: Vec3::ONE }; ITEMS];
/// let grid = buffers.build::<8>(&boxes)?;
/// assert!(grid.cell_count() >= 1 && grid.entry_count() >= 3);
/// # Ok::<(), strahl_core::accel::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct StaticGrid<const CELLS: usize, const ENTRIES: usize> {
    cell_starts: [u32; CELLS],
    entries: [u32; ENTRIES],
}

impl<const CELLS: usize, const ENTRIES: usize> StaticGrid<CELLS, ENTRIES> {
    /// Buffers before the first [`StaticGrid::build`].
    pub const fn new() -> Self {
        StaticGrid { cell_starts: [0; CELLS], entries: [0; ENTRIES] }
    }

    /// Builds the grid of the items with these bounds, as [`Grid::build`] does.
    ///
    /// # Errors
    ///
    /// Those of [`Grid::build`].
    pub fn build<'s, const MAILBOX_ENTRIES: usize>(
        &'s mut self,
        bounds: &'s [Aabb],
    ) -> Result<Grid<'s, MAILBOX_ENTRIES>, BuildError> {
        Grid::build(bounds, &mut self.cell_starts, &mut self.entries)
    }
}

impl<const CELLS: usize, const ENTRIES: usize> Default for StaticGrid<CELLS, ENTRIES> {
    fn default() -> Self {
        Self::new()
    }
}
