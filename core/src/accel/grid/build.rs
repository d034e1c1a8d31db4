//! Construction of a grid: choose the resolution, then sort the items into the cells by counting.
//!
//! The counting sort counts the entries of each cell, accumulates the counts to the start of each cell's
//! list, and fills the lists. It needs no memory beside that of the grid, and each cell lists its items in
//! ascending order.

use super::Grid;
use crate::accel::cell_planes::{CellPlanes, bounds_of_all};
use crate::accel::{Buffer, BuildError};
use crate::geometry::Aabb;
use crate::math::{Real, Vec3, clamp, floor, max, powf, vec3};

/// Cells per item, where the buffers suffice. With 2 instead, uneven scenes take longer; with 8, even ones
/// do.
const CELLS_PER_ITEM: Real = 4.0;

/// Entries per item that [`GridSize::estimated`] expects.
const ENTRIES_PER_ITEM: usize = 4;

/// Largest number of entries per item that [`GridSize::recommended`] recommends. Without a limit, many large
/// items that overlap all cells would take too much memory.
const MAX_ENTRIES_PER_ITEM: usize = 32;

/// Largest number of cells along an axis: indices of planes are exact in `f32`.
const MAX_CELLS_PER_AXIS: Real = 65536.0;

/// Sizes of the buffers of a [`Grid`], as numbers of `u32`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GridSize {
    /// Length of `cells`: one more than the number of cells.
    pub cells: usize,
    /// Length of `entries`: one per item and cell that its bounds overlap.
    pub entries: usize,
}

impl GridSize {
    /// The expected sizes for `items` items with unknown bounds. With smaller buffers the grid is coarser;
    /// the minimum is 2 for the cells and one entry per item.
    pub const fn estimated(items: usize) -> Self {
        GridSize { cells: items * CELLS_PER_ITEM as usize + 1, entries: items * ENTRIES_PER_ITEM }
    }

    /// The exact sizes for the items with these bounds: those of the finest grid that [`Grid::build`] makes.
    /// For bounds that it refuses, the minimum.
    pub fn recommended(bounds: &[Aabb]) -> Self {
        let minimum = GridSize { cells: 2, entries: bounds.len() };
        let Ok((all_bounds, items)) = bounds_of_all(bounds) else { return minimum };
        let available =
            GridSize { cells: u32::MAX as usize, entries: items.saturating_mul(MAX_ENTRIES_PER_ITEM) };
        GridLayout::fit(bounds, all_bounds, items, CELLS_PER_ITEM, available)
            .map_or(minimum, |(_, size)| size)
    }
}

impl<'s, const MAILBOX_ENTRIES: usize> Grid<'s, MAILBOX_ENTRIES> {
    /// Builds the grid of the items with these bounds.
    ///
    /// `bounds`: one box per item; items with an empty box ([`Aabb::EMPTY`]) are left out. `cells` and
    /// `entries`: caller-provided buffers of the sizes of [`GridSize::recommended`]. With smaller ones the
    /// grid is coarser; at least 2 cells are needed, and one entry per item that is not left out.
    ///
    /// # Errors
    ///
    /// * [`BuildError::BufferTooSmall`] for `cells` or `entries`.
    /// * [`BuildError::NotFinite`] for a box that is not finite.
    pub fn build(
        bounds: &'s [Aabb],
        cells: &'s mut [u32],
        entries: &'s mut [u32],
    ) -> Result<Self, BuildError> {
        Self::build_with_density(CELLS_PER_ITEM, bounds, cells, entries)
    }

    /// Builds the grid as [`Grid::build`] does, with about `density` cells per item; with fewer where the
    /// buffers do not suffice, so that the grid is coarser.
    ///
    /// `density`: more than zero. Zero, a negative number or NaN gives a single cell; infinity gives as
    /// many cells as the buffers allow.
    ///
    /// # Errors
    ///
    /// Those of [`Grid::build`].
    pub fn build_with_density(
        density: Real,
        bounds: &'s [Aabb],
        cells: &'s mut [u32],
        entries: &'s mut [u32],
    ) -> Result<Self, BuildError> {
        let (all_bounds, items) = bounds_of_all(bounds)?;
        let provided = GridSize { cells: cells.len(), entries: entries.len() };
        let (layout, size) = GridLayout::fit(bounds, all_bounds, items, density, provided)?;
        let cell_starts =
            cells.get_mut(..size.cells).ok_or(too_small(Buffer::Cells, size.cells, provided.cells))?;
        let entries = entries.get_mut(..size.entries).ok_or(too_small(
            Buffer::Entries,
            size.entries,
            provided.entries,
        ))?;
        layout.fill_cells(bounds, cell_starts, entries);
        let GridLayout { planes, resolution } = layout;
        Ok(Grid { bounds: all_bounds, planes, resolution, cell_starts, entries, item_bounds: bounds })
    }
}

const fn too_small(buffer: Buffer, needed: usize, provided: usize) -> BuildError {
    BuildError::BufferTooSmall { buffer, needed, provided }
}

/// The division of space into cells.
struct GridLayout {
    planes: CellPlanes,
    /// Number of cells along each axis.
    resolution: [u32; 3],
}

impl GridLayout {
    /// The finest layout of at most about `density` cells per item that fits into buffers of the `available`
    /// sizes, and the sizes that it needs.
    ///
    /// `all_bounds` and `items`: union of `bounds`, and number of boxes that are not empty.
    fn fit(
        bounds: &[Aabb],
        all_bounds: Aabb,
        items: usize,
        density: Real,
        available: GridSize,
    ) -> Result<(Self, GridSize), BuildError> {
        if available.cells < 2 {
            return Err(too_small(Buffer::Cells, 2, available.cells));
        }
        if available.entries < items {
            return Err(too_small(Buffer::Entries, items, available.entries));
        }
        if items == 0 {
            let planes = CellPlanes::new(Aabb { min: Vec3::ZERO, max: Vec3::ZERO }, Vec3::ONE);
            return Ok((GridLayout { planes, resolution: [1; 3] }, GridSize { cells: 2, entries: 0 }));
        }
        // Finite, so that reducing it ends.
        let mut target = clamp(items as Real * density, 0.0, Real::MAX);
        loop {
            let layout = Self::new(all_bounds, cells_per_axis(all_bounds, target));
            let cell_count = layout.count_cells();
            let is_coarsest = layout.resolution == [1; 3];
            if cell_count < available.cells as u64 {
                let entry_count = layout.count_entries(bounds, available.entries);
                if let Some(entry_count) = entry_count {
                    return Ok((layout, GridSize { cells: cell_count as usize + 1, entries: entry_count }));
                }
            }
            if is_coarsest {
                // A single cell lists each item once, so this happens only for more items than `u32` can
                // count.
                return Err(too_small(Buffer::Entries, items, available.entries));
            }
            target *= 0.75;
        }
    }

    fn new(bounds: Aabb, cells: Vec3) -> Self {
        let count = |x: Real| x as u32;
        GridLayout {
            planes: CellPlanes::new(bounds, cells),
            resolution: [count(cells.x), count(cells.y), count(cells.z)],
        }
    }

    fn count_cells(&self) -> u64 {
        self.resolution.iter().fold(1, |product: u64, cells| product.saturating_mul(u64::from(*cells)))
    }

    /// Number of entries of all cells; `None` if it is above `max`.
    fn count_entries(&self, bounds: &[Aabb], max: usize) -> Option<usize> {
        let max = (max as u64).min(u64::from(u32::MAX));
        let mut entries = 0_u64;
        for aabb in bounds.iter().filter(|aabb| !aabb.is_empty()) {
            let ranges = self.overlapped_cells(aabb);
            entries +=
                ranges.iter().fold(1, |product: u64, (first, last)| product * u64::from(last - first + 1));
            if entries > max {
                return None;
            }
        }
        Some(entries as usize)
    }

    /// The first and the last cell along each axis that a box overlaps. A box that touches a plane overlaps
    /// the cells on both sides of it.
    fn overlapped_cells(&self, aabb: &Aabb) -> [(u32, u32); 3] {
        let (min, max) = (self.planes.fractional_index(aabb.min), self.planes.fractional_index(aabb.max));
        let [x, y, z] = self.resolution;
        let plane_x = |i: u32| self.planes.position(vec3(i as Real, 0.0, 0.0)).x;
        let plane_y = |i: u32| self.planes.position(vec3(0.0, i as Real, 0.0)).y;
        let plane_z = |i: u32| self.planes.position(vec3(0.0, 0.0, i as Real)).z;
        [
            cell_range(x, plane_x, (min.x, max.x), (aabb.min.x, aabb.max.x)),
            cell_range(y, plane_y, (min.y, max.y), (aabb.min.y, aabb.max.y)),
            cell_range(z, plane_z, (min.z, max.z), (aabb.min.z, aabb.max.z)),
        ]
    }

    /// Calls `visit` with the index of each cell that a box overlaps.
    fn for_each_overlapped_cell(&self, aabb: &Aabb, mut visit: impl FnMut(usize)) {
        let [(x0, x1), (y0, y1), (z0, z1)] = self.overlapped_cells(aabb);
        let [width, height, _] = self.resolution.map(|n| n as usize);
        for z in z0..=z1 {
            for y in y0..=y1 {
                let row = (z as usize * height + y as usize) * width;
                for x in x0..=x1 {
                    visit(row + x as usize);
                }
            }
        }
    }

    /// Sorts the items into the cells. `cell_starts`: one longer than the number of cells.
    fn fill_cells(&self, bounds: &[Aabb], cell_starts: &mut [u32], entries: &mut [u32]) {
        cell_starts.fill(0);
        let bounded = || bounds.iter().enumerate().filter(|(_, aabb)| !aabb.is_empty());

        // Count the entries of each cell.
        for (_, aabb) in bounded() {
            self.for_each_overlapped_cell(aabb, |cell| {
                if let Some(count) = cell_starts.get_mut(cell) {
                    *count += 1;
                }
            });
        }

        // Accumulate the counts: each becomes the end of its cell's list.
        let mut end = 0;
        for start in &mut *cell_starts {
            end += *start;
            *start = end;
        }

        // Fill each list from its end, so that the ends become starts.
        for (item, aabb) in bounded().rev() {
            self.for_each_overlapped_cell(aabb, |cell| {
                if let Some(start) = cell_starts.get_mut(cell) {
                    *start = start.wrapping_sub(1);
                    if let Some(entry) = entries.get_mut(*start as usize) {
                        *entry = item as u32;
                    }
                }
            });
        }
    }
}

/// The first and the last of `cells` cells along an axis that overlap `min..=max`.
///
/// `plane`: position by index. `estimates`: approximate positions of `min` and `max` in units of cells.
fn cell_range(
    cells: u32,
    plane: impl Fn(u32) -> Real,
    estimates: (Real, Real),
    (min, max): (Real, Real),
) -> (u32, u32) {
    let last_cell = cells - 1;
    let estimate = |x: Real| (x as u32).min(last_cell);
    let mut first = estimate(estimates.0);
    while first > 0 && plane(first) >= min {
        first -= 1;
    }
    while first < last_cell && plane(first + 1) < min {
        first += 1;
    }
    let mut last = estimate(estimates.1);
    while last < last_cell && plane(last + 1) <= max {
        last += 1;
    }
    while last > first && plane(last) > max {
        last -= 1;
    }
    (first, last.max(first))
}

/// Number of cells along each axis, as integers, for about `target` cells that are as cubic as possible.
fn cells_per_axis(bounds: Aabb, target: Real) -> Vec3 {
    let extent = bounds.max - bounds.min;
    let longest = max(extent.x, max(extent.y, extent.z));
    if !(longest > 0.0 && target > 1.0) {
        return Vec3::ONE;
    }
    let extent = extent / longest;
    // An axis that is shorter than a cell gets one cell, and the other axes share the target. The first
    // iteration assumes that one axis is divided into all cells.
    let mut is_divided = [true; 3];
    let mut cells_per_length = target;
    for _ in 0..3 {
        let (mut axes, mut product) = (0, 1.0);
        for (is_divided, side) in is_divided.iter_mut().zip(extent.to_array()) {
            *is_divided &= side * cells_per_length >= 1.0;
            if *is_divided {
                axes += 1;
                product *= side;
            }
        }
        cells_per_length = if axes > 0 { powf(target / product, 1.0 / axes as Real) } else { 1.0 };
    }
    let [x, y, z] = is_divided;
    let count = |side: Real, is_divided: bool| {
        let cells = floor(side * cells_per_length + 0.5);
        if !is_divided || !(cells > 1.0) {
            1.0
        } else if cells < MAX_CELLS_PER_AXIS {
            cells
        } else {
            MAX_CELLS_PER_AXIS
        }
    };
    vec3(count(extent.x, x), count(extent.y, y), count(extent.z, z))
}
