//! Cost per pixel, counted during rendering.
//!
//! A camera ray and all its secondary and shadow rays are attributed to the pixel that contains its film position: a corner
//! shared by four pixels counts for the lower right one, and an interpolated pixel costs nothing. The sum over all pixels
//! is the cost of the picture.

use std::sync::Arc;
use std::sync::atomic::{AtomicU8, AtomicU32, Ordering};

use strahl_core::image::Pixel;
use strahl_core::tally::RayKind;
use strahl_core::{Resolution, Tile};

use crate::mask::Mask;

const KINDS: usize = RayKind::ALL.len();

/// The counts of one pixel, by ray kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PixelCost {
    /// Rays traced.
    pub rays: [u32; KINDS],
    /// Box tests.
    pub boxes: [u32; KINDS],
    /// Shape tests.
    pub shapes: [u32; KINDS],
    /// Leaves, cells or groups visited.
    pub regions: [u32; KINDS],
    /// Shape tests avoided by mailboxes.
    pub skipped: [u32; KINDS],
    /// The highest ray level; the camera ray has level 1. 0 if no ray was traced.
    pub level: u8,
}

impl PixelCost {
    fn fields(&self) -> [[u32; KINDS]; 5] {
        [self.rays, self.boxes, self.shapes, self.regions, self.skipped]
    }

    /// The number of rays of all kinds.
    pub fn total_rays(&self) -> u64 {
        sum(self.rays)
    }

    /// The number of box and shape tests by rays of all kinds.
    pub fn tests(&self) -> u64 {
        sum(self.boxes) + sum(self.shapes)
    }
}

/// The sum over all ray kinds.
pub fn sum(by_kind: [u32; KINDS]) -> u64 {
    by_kind.into_iter().map(u64::from).sum()
}

/// The counts of one pixel, and its highest level.
#[derive(Debug, Default)]
struct CostCell {
    counts: [AtomicU32; 5 * KINDS],
    level: AtomicU8,
}

/// The costs of all pixels, updated by all threads concurrently.
#[derive(Debug)]
pub struct CostMap {
    size: Resolution,
    cells: Vec<CostCell>,
    /// The subset of pixels that have a cell; `None` for all.
    subset: Option<PixelSubset>,
}

/// The pixels of a picture whose cost is recorded.
#[derive(Clone, Debug)]
pub struct PixelSubset {
    /// The index of the cell of each pixel; `u32::MAX` for pixels outside the subset.
    cells: Arc<[u32]>,
    count: usize,
}

impl PixelSubset {
    /// The pixels of a mask.
    pub fn of_mask(mask: &Mask) -> Self {
        let mut count = 0;
        let cell = |is_included: &bool| {
            let cell = if *is_included { count } else { u32::MAX };
            count += u32::from(*is_included);
            cell
        };
        let cells = mask.pixels.iter().map(cell).collect();
        PixelSubset { cells, count: count as usize }
    }
}

impl CostMap {
    /// A cost map for all pixels, with zero costs.
    pub fn new(size: Resolution) -> Self {
        let count = size.width() as usize * size.height() as usize;
        CostMap { size, cells: cells(count), subset: None }
    }

    /// A cost map for a subset of pixels; the costs of the others are discarded.
    pub fn for_subset(size: Resolution, subset: &PixelSubset) -> Self {
        CostMap { size, cells: cells(subset.count), subset: Some(subset.clone()) }
    }

    /// Width and height.
    pub fn size(&self) -> Resolution {
        self.size
    }

    /// Adds a cost at a film position; positions outside the picture count for the nearest pixel.
    pub fn add(&self, x: f64, y: f64, cost: &PixelCost) {
        // Negative numbers and NaN become zero.
        let pixel =
            Pixel { x: (x as u32).min(self.size.width() - 1), y: (y as u32).min(self.size.height() - 1) };
        let index = Tile::full(self.size).index_of(pixel);
        let index = match &self.subset {
            None => index,
            Some(subset) => index.and_then(|index| subset.cells.get(index)).map(|cell| *cell as usize),
        };
        let Some(cell) = index.and_then(|index| self.cells.get(index)) else { return };
        for (sum, count) in cell.counts.iter().zip(cost.fields().as_flattened()) {
            if *count > 0 {
                sum.fetch_add(*count, Ordering::Relaxed);
            }
        }
        cell.level.fetch_max(cost.level, Ordering::Relaxed);
    }

    /// The costs, row by row; of a subset only those of its pixels.
    pub fn costs(&self) -> Vec<PixelCost> {
        let cost = |CostCell { counts, level }: &CostCell| {
            let of = |field: usize| {
                std::array::from_fn(|kind| counts[field * KINDS + kind].load(Ordering::Relaxed))
            };
            let level = level.load(Ordering::Relaxed);
            PixelCost { rays: of(0), boxes: of(1), shapes: of(2), regions: of(3), skipped: of(4), level }
        };
        self.cells.iter().map(cost).collect()
    }
}

fn cells(count: usize) -> Vec<CostCell> {
    std::iter::repeat_with(CostCell::default).take(count).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn costs_outside_the_picture_are_added_to_its_edge() {
        let cost_map = CostMap::new(Resolution::new(3, 2).unwrap());
        let one = PixelCost { rays: [1, 0, 0, 0], ..PixelCost::default() };
        for (x, y) in [(-0.5, -3.0), (2.9, 1.9), (3.0, 2.0), (1.0, 0.0), (f64::NAN, 0.0)] {
            cost_map.add(x, y, &one);
        }
        assert_eq!(cost_map.costs().iter().map(|cost| cost.rays[0]).collect::<Vec<_>>(), [2, 1, 0, 0, 0, 2]);
    }

    #[test]
    fn a_subset_has_the_same_costs_as_the_whole_picture() {
        let size = Resolution::new(4, 3).unwrap();
        let pixels = (0..12).map(|index| index % 5 == 1).collect();
        let [all, some] =
            [CostMap::new(size), CostMap::for_subset(size, &PixelSubset::of_mask(&Mask { size, pixels }))];
        for index in 0..24_u32 {
            let (x, y) = (f64::from(index % 4), f64::from(index / 4 % 3));
            let cost = PixelCost { rays: [index, 0, 0, 1], level: index as u8, ..PixelCost::default() };
            all.add(x, y, &cost);
            some.add(x, y, &cost);
        }
        let all = all.costs();
        assert_eq!(some.costs(), [all[1], all[6], all[11]]);
    }
}
