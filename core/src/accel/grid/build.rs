//! Building a grid: choose the resolution, then sort the items into the cells by counting.
//!
//! Count how many items each cell lists, add up where each cell's list begins, fill the lists. No
//! memory is needed but what the grid keeps, and a cell lists its items by rising number.

use super::Grid;
use crate::accel::cell_planes::{CellPlanes, bounds_of_all};
use crate::accel::{BuildError, Storage};
use crate::geometry::Aabb;
use crate::math::{Real, Vec3, floor, greatest, powf, vec3};

/// Cells for each item, where memory allows. On gears, mount, rings, teapot and tetra of the
/// standard procedural databases, 2 and 4 take the same time within 3 %, and 8 takes 2 to 60 % more;
/// on the uneven balls and tree 4 takes 15 to 20 % less than 2.
const DENSITY: Real = 4.0;

/// Entries for each item that [`GridRoom::of_items`] expects.
const ENTRIES: usize = 4;

/// The most entries for each item that [`GridRoom::comfortable`] asks for: more and large items
/// that lie in all cells would take memory without end.
const MOST_ENTRIES: usize = 32;

/// The most cells along an axis: walls' numbers stay exact in `f32`.
const MOST_CELLS: Real = 65536.0;

/// How much memory a grid takes, in numbers of `u32`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GridRoom {
    /// One for each cell, and one more.
    pub cells: usize,
    /// One for each item in each cell that it touches.
    pub items: usize,
}

impl GridRoom {
    /// What `items` items are expected to take, when nothing is known about their boxes. With
    /// less the grid is coarser; the floor is 2 cells and as many entries as items.
    pub const fn of_items(items: usize) -> Self {
        GridRoom { cells: items * DENSITY as usize + 1, items: items * ENTRIES }
    }

    /// Exactly what the grid of these boxes takes. The answer for boxes that cannot be placed is
    /// the floor.
    pub fn comfortable(boxes: &[Aabb]) -> Self {
        let floor = GridRoom { cells: 2, items: boxes.len() };
        let Ok((bounds, items)) = bounds_of_all(boxes) else { return floor };
        let most = GridRoom { cells: u32::MAX as usize, items: items.saturating_mul(MOST_ENTRIES) };
        Plan::within(boxes, bounds, items, DENSITY, most).map_or(floor, |(_, room)| room)
    }
}

impl<'s, const MAILBOX: usize> Grid<'s, MAILBOX> {
    /// The grid of the items inside `boxes`, one box for each, in their order. Empty boxes
    /// ([`Aabb::EMPTY`]) have no place in it.
    ///
    /// `cells` and `entries` are lent: as many as [`GridRoom::comfortable`] says, or fewer, for
    /// a coarser grid. At least 2 cells, and as many entries as there are items that have a place,
    /// or [`BuildError::StorageTooSmall`] says so.
    pub fn build(
        boxes: &'s [Aabb],
        cells: &'s mut [u32],
        entries: &'s mut [u32],
    ) -> Result<Self, BuildError> {
        Self::with_density(DENSITY, boxes, cells, entries)
    }

    /// The same with so many cells for each item, where the lent memory allows; finite, and more
    /// than zero.
    pub fn with_density(
        density: Real,
        boxes: &'s [Aabb],
        cells: &'s mut [u32],
        entries: &'s mut [u32],
    ) -> Result<Self, BuildError> {
        let (bounds, items) = bounds_of_all(boxes)?;
        let lent = GridRoom { cells: cells.len(), items: entries.len() };
        let (plan, room) = Plan::within(boxes, bounds, items, density, lent)?;
        let too_small = |what, needed, lent| BuildError::StorageTooSmall { what, needed, lent };
        let starts = cells.get_mut(..room.cells).ok_or(too_small(Storage::Cells, room.cells, lent.cells))?;
        let items = entries.get_mut(..room.items).ok_or(too_small(Storage::Items, room.items, lent.items))?;
        plan.sort(boxes, starts, items);
        Ok(Grid { bounds, walls: plan.walls, cells: plan.cells, starts, items, boxes })
    }
}

/// How space is cut.
struct Plan {
    walls: CellPlanes,
    cells: [u32; 3],
}

impl Plan {
    /// The finest cut, but not finer than `density` cells for each item, that `most` memory holds;
    /// and the memory that it takes.
    fn within(
        boxes: &[Aabb],
        bounds: Aabb,
        items: usize,
        density: Real,
        most: GridRoom,
    ) -> Result<(Self, GridRoom), BuildError> {
        let too_small = |what, needed, lent| Err(BuildError::StorageTooSmall { what, needed, lent });
        if most.cells < 2 {
            return too_small(Storage::Cells, 2, most.cells);
        }
        if most.items < items {
            return too_small(Storage::Items, items, most.items);
        }
        if items == 0 {
            let plan = Plan {
                walls: CellPlanes::new(Aabb { min: Vec3::ZERO, max: Vec3::ZERO }, Vec3::ONE),
                cells: [1; 3],
            };
            return Ok((plan, GridRoom { cells: 2, items: 0 }));
        }
        let mut wanted = items as Real * density;
        loop {
            let plan = Self::new(bounds, resolution(bounds, wanted));
            let count = plan.count_cells();
            let is_coarsest = plan.cells == [1; 3];
            if count < most.cells as u64 {
                let entries = plan.count_entries(boxes, most.items);
                if let Some(entries) = entries {
                    return Ok((plan, GridRoom { cells: count as usize + 1, items: entries }));
                }
            }
            if is_coarsest {
                // One cell lists each item once, so this is only for more items than u32 counts.
                return too_small(Storage::Items, items, most.items);
            }
            wanted *= 0.75;
        }
    }

    fn new(bounds: Aabb, cells: Vec3) -> Self {
        let number = |x: Real| x as u32;
        Plan {
            walls: CellPlanes::new(bounds, cells),
            cells: [number(cells.x), number(cells.y), number(cells.z)],
        }
    }

    fn count_cells(&self) -> u64 {
        self.cells.iter().fold(1, |product: u64, cells| product.saturating_mul(u64::from(*cells)))
    }

    /// How many entries there will be, if they are at most `most`.
    fn count_entries(&self, boxes: &[Aabb], most: usize) -> Option<usize> {
        let most = (most as u64).min(u64::from(u32::MAX));
        let mut entries = 0_u64;
        for aabb in boxes.iter().filter(|aabb| !aabb.is_empty()) {
            let ranges = self.touched(aabb);
            entries +=
                ranges.iter().fold(1, |product: u64, (first, last)| product * u64::from(last - first + 1));
            if entries > most {
                return None;
            }
        }
        Some(entries as usize)
    }

    /// The first and the last cell along each axis that a box touches.
    fn touched(&self, aabb: &Aabb) -> [(u32, u32); 3] {
        let (low, high) = (self.walls.fractional_index(aabb.min), self.walls.fractional_index(aabb.max));
        let [x, y, z] = self.cells;
        let wall_x = |i: u32| self.walls.position(vec3(i as Real, 0.0, 0.0)).x;
        let wall_y = |i: u32| self.walls.position(vec3(0.0, i as Real, 0.0)).y;
        let wall_z = |i: u32| self.walls.position(vec3(0.0, 0.0, i as Real)).z;
        [
            range(x, wall_x, (low.x, high.x), (aabb.min.x, aabb.max.x)),
            range(y, wall_y, (low.y, high.y), (aabb.min.y, aabb.max.y)),
            range(z, wall_z, (low.z, high.z), (aabb.min.z, aabb.max.z)),
        ]
    }

    /// Calls `visit` with each cell that a box touches.
    fn each_cell(&self, aabb: &Aabb, mut visit: impl FnMut(usize)) {
        let [(x0, x1), (y0, y1), (z0, z1)] = self.touched(aabb);
        let [width, height, _] = self.cells.map(|n| n as usize);
        for z in z0..=z1 {
            for y in y0..=y1 {
                let row = (z as usize * height + y as usize) * width;
                for x in x0..=x1 {
                    visit(row + x as usize);
                }
            }
        }
    }

    /// Sorts the items into the cells: `starts` has one more than there are cells.
    fn sort(&self, boxes: &[Aabb], starts: &mut [u32], items: &mut [u32]) {
        starts.fill(0);
        let placed = || boxes.iter().enumerate().filter(|(_, aabb)| !aabb.is_empty());

        // Count.
        for (_, aabb) in placed() {
            self.each_cell(aabb, |cell| {
                if let Some(count) = starts.get_mut(cell) {
                    *count += 1;
                }
            });
        }

        // Add up: each cell's number becomes the place after its list.
        let mut end = 0;
        for start in &mut *starts {
            end += *start;
            *start = end;
        }

        // Fill, from the back, so that the numbers end as the places where the lists begin.
        for (item, aabb) in placed().rev() {
            self.each_cell(aabb, |cell| {
                if let Some(place) = starts.get_mut(cell) {
                    *place = place.wrapping_sub(1);
                    if let Some(entry) = items.get_mut(*place as usize) {
                        *entry = item as u32;
                    }
                }
            });
        }
    }
}

/// The first and the last of `cells` cells that touch `low..=high`; `about` are guesses.
fn range(
    cells: u32,
    wall: impl Fn(u32) -> Real,
    about: (Real, Real),
    (low, high): (Real, Real),
) -> (u32, u32) {
    let last = cells - 1;
    let guess = |x: Real| (x as u32).min(last);
    let mut i = guess(about.0);
    while i > 0 && wall(i) >= low {
        i -= 1;
    }
    while i < last && wall(i + 1) < low {
        i += 1;
    }
    let mut j = guess(about.1);
    while j < last && wall(j + 1) <= high {
        j += 1;
    }
    while j > i && wall(j) > high {
        j -= 1;
    }
    (i, greatest_of(i, j))
}

fn greatest_of(a: u32, b: u32) -> u32 {
    if a > b { a } else { b }
}

/// About `wanted` cells, as cubic as whole numbers allow: how many along each axis.
fn resolution(bounds: Aabb, wanted: Real) -> Vec3 {
    let extent = bounds.max - bounds.min;
    let longest = greatest(extent.x, greatest(extent.y, extent.z));
    if !(longest > 0.0 && wanted > 1.0) {
        return Vec3::ONE;
    }
    let extent = extent / longest;
    // An axis that is shorter than a cell has one cell, and the others share what is wanted. The
    // first round knows no more than that one axis alone would have all cells.
    let mut open = [true; 3];
    let mut per_length = wanted;
    for _ in 0..3 {
        let (mut axes, mut product) = (0, 1.0);
        for (open, side) in open.iter_mut().zip(extent.to_array()) {
            *open &= side * per_length >= 1.0;
            if *open {
                axes += 1;
                product *= side;
            }
        }
        per_length = if axes > 0 { powf(wanted / product, 1.0 / axes as Real) } else { 1.0 };
    }
    let [x, y, z] = open;
    let number = |side: Real, open: bool| {
        let cells = floor(side * per_length + 0.5);
        if !open || !(cells > 1.0) {
            1.0
        } else if cells < MOST_CELLS {
            cells
        } else {
            MOST_CELLS
        }
    };
    vec3(number(extent.x, x), number(extent.y, y), number(extent.z, z))
}
