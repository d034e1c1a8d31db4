//! Uniform grid, walked cell by cell along the ray.
//!
//! The box of the scene is cut into equal cells; each cell lists the items whose boxes touch it.
//! A walk keeps, for each axis, the distance of the next wall, and steps over the nearest one. It
//! ends when that wall lies beyond the query's reach.
//!
//! An item may lie in many cells and be offered again; the mailbox makes this rare and the
//! [`Query`] contract makes it harmless.
//!
//! A grid suits items of about one size, evenly spread. Where many small items lie close together
//! in a large scene, most of them share a cell, whatever the resolution: an octree or a hierarchy
//! goes to where the items are.

mod build;
#[cfg(not(feature = "double"))]
mod parts;
mod walk;

pub use build::GridRoom;
#[cfg(not(feature = "double"))]
pub(crate) use parts::GridParts;

use core::ops::ControlFlow;

use super::cell_planes::CellPlanes;
use super::mailbox::{Mailbox, MailboxQuery};
use super::{Accelerator, BuildError, Query, Regions};
use crate::geometry::{Aabb, Ray};
use crate::math::Real;

/// A uniform grid in lent memory; walks remember the items of a ray in `MAILBOX` slots.
///
/// * Shape: `MAILBOX` is zero or a power of two.
/// * Memory: 4 bytes per cell, and 4 per entry: an item has one in each cell that its box touches.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'s, const MAILBOX: usize> {
    /// The smallest box round all items.
    bounds: Aabb,
    walls: CellPlanes,
    /// How many cells there are along each axis.
    cells: [u32; 3],
    /// For each cell, where its items begin; they end where those of the next one begin. The
    /// cells lie in rows along the first axis, the rows in layers.
    starts: &'s [u32],
    /// The items of the cells, one cell after the other.
    items: &'s [u32],
    /// The boxes of all items, by their numbers; or none.
    boxes: &'s [Aabb],
}

impl<'s, const MAILBOX: usize> Grid<'s, MAILBOX> {
    /// The same grid, walked with a mailbox of another size.
    pub const fn with_mailbox<const SLOTS: usize>(self) -> Grid<'s, SLOTS> {
        let Grid { bounds, walls, cells, starts, items, boxes } = self;
        Grid { bounds, walls, cells, starts, items, boxes }
    }

    /// The same grid, but it gives back the boxes: it takes less memory, and each item of a cell is
    /// tested, whether the ray comes near it or not.
    pub const fn without_boxes(self) -> Self {
        Grid { boxes: &[], ..self }
    }

    /// How many cells there are along each axis.
    pub const fn cells(&self) -> [u32; 3] {
        self.cells
    }

    /// How many cells there are.
    pub const fn regions(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// How many items all cells list, each counted in each cell.
    pub const fn entries(&self) -> usize {
        self.items.len()
    }

    /// The memory it uses, in bytes.
    pub const fn bytes(&self) -> usize {
        size_of_val(self.starts) + size_of_val(self.items) + size_of_val(self.boxes)
    }

    /// The items of a cell.
    #[inline(always)]
    fn items_of(&self, cell: usize) -> &[u32] {
        let start = self.starts.get(cell).copied().unwrap_or(0) as usize;
        let end = self.starts.get(cell.wrapping_add(1)).copied().unwrap_or(0) as usize;
        self.items.get(start..end).unwrap_or(&[])
    }
}

impl<const MAILBOX: usize> Accelerator for Grid<'_, MAILBOX> {
    type Scratch = Mailbox<MAILBOX>;

    /// Not inlined: a walk has registers of its own.
    #[inline(never)]
    fn walk<Q: Query>(&self, ray: &Ray, mailbox: &mut Mailbox<MAILBOX>, query: &mut Q) {
        query.boxes(1);
        let Some(span) = self.bounds.span(ray) else { return };
        mailbox.begin_ray();
        let reach = query.reach();
        let asking = MailboxQuery { ray, item_bounds: self.boxes, mailbox, query };
        self.along(ray, span, reach, &mut Cells { grid: self, asking });
    }
}

/// The cells along a ray, whose items are offered.
struct Cells<'a, Q, const MAILBOX: usize> {
    grid: &'a Grid<'a, MAILBOX>,
    asking: MailboxQuery<'a, Q, MAILBOX>,
}

impl<Q: Query, const MAILBOX: usize> Regions<usize> for Cells<'_, Q, MAILBOX> {
    #[inline(always)]
    fn enter(&mut self, cell: usize) -> ControlFlow<(), Real> {
        self.asking.test_items(self.grid.items_of(cell))
    }
}

/// Memory for a grid, of a size known when compiled.
///
/// `CELLS` and `ENTRIES` are at least those of a [`GridRoom`], which can be computed in a `const`
/// at the place of use:
///
/// ```
/// use strahl_core::{Aabb, GridRoom, StaticGrid, Vec3};
///
/// const ITEMS: usize = 3;
/// const ROOM: GridRoom = GridRoom::of_items(ITEMS);
/// let mut memory = StaticGrid::<{ ROOM.cells }, { ROOM.items }>::new();
/// let boxes = [Aabb { min: Vec3::ZERO, max: Vec3::ONE }; ITEMS];
/// let grid = memory.build::<8>(&boxes)?;
/// assert!(grid.regions() >= 1 && grid.entries() >= 3);
/// # Ok::<(), strahl_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct StaticGrid<const CELLS: usize, const ENTRIES: usize> {
    starts: [u32; CELLS],
    items: [u32; ENTRIES],
}

impl<const CELLS: usize, const ENTRIES: usize> StaticGrid<CELLS, ENTRIES> {
    /// Memory with nothing in it.
    pub const fn new() -> Self {
        StaticGrid { starts: [0; CELLS], items: [0; ENTRIES] }
    }

    /// The grid of the items inside `boxes`, as [`Grid::build`].
    pub fn build<'s, const MAILBOX: usize>(
        &'s mut self,
        boxes: &'s [Aabb],
    ) -> Result<Grid<'s, MAILBOX>, BuildError> {
        Grid::build(boxes, &mut self.starts, &mut self.items)
    }
}

impl<const CELLS: usize, const ENTRIES: usize> Default for StaticGrid<CELLS, ENTRIES> {
    fn default() -> Self {
        Self::new()
    }
}
