//! What each pixel of a picture costs, counted while it is traced.
//!
//! Every ray through the picture is charged to the pixel that it goes through, with all that comes
//! of it. So a corner that four pixels share is charged to one of them, the one to its lower
//! right, and a pixel that is guessed costs nothing. The sum over all pixels is what the whole
//! picture costs.

use std::sync::Arc;
use std::sync::atomic::{AtomicU8, AtomicU32, Ordering};

use strahl_core::image::Pixel;
use strahl_core::tally::RayKind;
use strahl_core::{Resolution, Tile};

use crate::mask::Mask;

const KINDS: usize = RayKind::ALL.len();

/// What was counted for one pixel, by kind of ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PixelCost {
    /// Rays.
    pub rays: [u32; KINDS],
    /// Tests of boxes.
    pub boxes: [u32; KINDS],
    /// Tests of shapes.
    pub shapes: [u32; KINDS],
    /// Regions entered.
    pub regions: [u32; KINDS],
    /// Tests that mailboxes saved.
    pub skipped: [u32; KINDS],
    /// The level of the deepest ray; the camera ray has level 1. 0 where there was none.
    pub level: u8,
}

impl PixelCost {
    fn fields(&self) -> [[u32; KINDS]; 5] {
        [self.rays, self.boxes, self.shapes, self.regions, self.skipped]
    }

    /// Rays of all kinds.
    pub fn all_rays(&self) -> u64 {
        sum(self.rays)
    }

    /// Tests of boxes and shapes by rays of all kinds.
    pub fn tests(&self) -> u64 {
        sum(self.boxes) + sum(self.shapes)
    }
}

/// Of all kinds of rays.
pub fn sum(by_kind: [u32; KINDS]) -> u64 {
    by_kind.into_iter().map(u64::from).sum()
}

/// The counts of one pixel, and its deepest level.
#[derive(Debug, Default)]
struct Cell {
    counts: [AtomicU32; 5 * KINDS],
    level: AtomicU8,
}

/// A picture of costs, on which all threads write at once.
#[derive(Debug)]
pub struct CostMap {
    size: Resolution,
    cells: Vec<Cell>,
    /// The cell of each pixel, where not every pixel has its own.
    chosen: Option<ChosenPixels>,
}

/// The pixels of a picture to which something can be charged.
#[derive(Clone, Debug)]
pub struct ChosenPixels {
    /// The cell of each pixel of the picture; that of the others is not there.
    cells: Arc<[u32]>,
    count: usize,
}

impl ChosenPixels {
    /// Those of a mask.
    pub fn by(mask: &Mask) -> Self {
        let mut count = 0;
        let cell = |is_chosen: &bool| {
            let cell = if *is_chosen { count } else { u32::MAX };
            count += u32::from(*is_chosen);
            cell
        };
        let cells = mask.pixels.iter().map(cell).collect();
        ChosenPixels { cells, count: count as usize }
    }
}

impl CostMap {
    /// Nothing is charged yet.
    pub fn new(size: Resolution) -> Self {
        let count = size.width() as usize * size.height() as usize;
        CostMap { size, cells: cells(count), chosen: None }
    }

    /// The same for some pixels only; what the others cost is not written down.
    pub fn only(size: Resolution, chosen: &ChosenPixels) -> Self {
        CostMap { size, cells: cells(chosen.count), chosen: Some(chosen.clone()) }
    }

    /// Width and height.
    pub fn size(&self) -> Resolution {
        self.size
    }

    /// Charges the pixel at a place of the picture, or the nearest of its rim.
    pub fn charge(&self, x: f64, y: f64, cost: &PixelCost) {
        // What is below zero or no number becomes zero.
        let pixel =
            Pixel { x: (x as u32).min(self.size.width() - 1), y: (y as u32).min(self.size.height() - 1) };
        let place = Tile::full(self.size).index_of(pixel);
        let place = match &self.chosen {
            None => place,
            Some(chosen) => place.and_then(|place| chosen.cells.get(place)).map(|cell| *cell as usize),
        };
        let Some(cell) = place.and_then(|place| self.cells.get(place)) else { return };
        for (sum, count) in cell.counts.iter().zip(cost.fields().as_flattened()) {
            if *count > 0 {
                sum.fetch_add(*count, Ordering::Relaxed);
            }
        }
        cell.level.fetch_max(cost.level, Ordering::Relaxed);
    }

    /// What was charged, row by row.
    pub fn costs(&self) -> Vec<PixelCost> {
        let cost = |Cell { counts, level }: &Cell| {
            let of = |field: usize| {
                std::array::from_fn(|kind| counts[field * KINDS + kind].load(Ordering::Relaxed))
            };
            let level = level.load(Ordering::Relaxed);
            PixelCost { rays: of(0), boxes: of(1), shapes: of(2), regions: of(3), skipped: of(4), level }
        };
        self.cells.iter().map(cost).collect()
    }
}

fn cells(count: usize) -> Vec<Cell> {
    std::iter::repeat_with(Cell::default).take(count).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_beyond_the_rim_is_charged_to_the_rim() {
        let cost_map = CostMap::new(Resolution::new(3, 2).unwrap());
        let one = PixelCost { rays: [1, 0, 0, 0], ..PixelCost::default() };
        for (x, y) in [(-0.5, -3.0), (2.9, 1.9), (3.0, 2.0), (1.0, 0.0), (f64::NAN, 0.0)] {
            cost_map.charge(x, y, &one);
        }
        assert_eq!(cost_map.costs().iter().map(|cost| cost.rays[0]).collect::<Vec<_>>(), [2, 1, 0, 0, 0, 2]);
    }

    #[test]
    fn some_pixels_are_charged_as_they_are_among_all() {
        let size = Resolution::new(4, 3).unwrap();
        let pixels = (0..12).map(|place| place % 5 == 1).collect();
        let [all, some] =
            [CostMap::new(size), CostMap::only(size, &ChosenPixels::by(&Mask { size, pixels }))];
        for place in 0..24_u32 {
            let (x, y) = (f64::from(place % 4), f64::from(place / 4 % 3));
            let cost = PixelCost { rays: [place, 0, 0, 1], level: place as u8, ..PixelCost::default() };
            all.charge(x, y, &cost);
            some.charge(x, y, &cost);
        }
        let all = all.costs();
        assert_eq!(some.costs(), [all[1], all[6], all[11]]);
    }
}
