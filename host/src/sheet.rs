//! What each pixel of a picture costs, counted while it is traced.
//!
//! Every ray through the picture is charged to the pixel that it goes through, with all that comes
//! of it. So a corner that four pixels share is charged to one of them, the one to its lower
//! right, and a pixel that is guessed costs nothing. The sum over all pixels is what the whole
//! picture costs.

use std::sync::atomic::{AtomicU32, Ordering};

use strahl_core::{Pixel, RayKind, Size, Tile};

const KINDS: usize = RayKind::ALL.len();

/// What was counted for one pixel, by kind of ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
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
}

impl Cost {
    fn fields(&self) -> [[u32; KINDS]; 5] {
        [self.rays, self.boxes, self.shapes, self.regions, self.skipped]
    }
}

/// A picture of costs, on which all threads write at once.
#[derive(Debug)]
pub struct Sheet {
    size: Size,
    cells: Vec<[AtomicU32; 5 * KINDS]>,
}

impl Sheet {
    /// Nothing is charged yet.
    pub fn new(size: Size) -> Self {
        let count = size.width() as usize * size.height() as usize;
        let cells = std::iter::repeat_with(Default::default).take(count).collect();
        Sheet { size, cells }
    }

    /// Width and height.
    pub fn size(&self) -> Size {
        self.size
    }

    /// Charges the pixel at a place of the picture, or the nearest of its rim.
    pub fn charge(&self, x: f64, y: f64, cost: &Cost) {
        // What is below zero or no number becomes zero.
        let pixel =
            Pixel { x: (x as u32).min(self.size.width() - 1), y: (y as u32).min(self.size.height() - 1) };
        let cell = Tile::whole(self.size).place(pixel).and_then(|place| self.cells.get(place));
        for (sum, count) in cell.into_iter().flatten().zip(cost.fields().as_flattened()) {
            if *count > 0 {
                sum.fetch_add(*count, Ordering::Relaxed);
            }
        }
    }

    /// What was charged, row by row.
    pub fn costs(&self) -> Vec<Cost> {
        let cost = |cell: &[AtomicU32; 5 * KINDS]| {
            let of =
                |field: usize| std::array::from_fn(|kind| cell[field * KINDS + kind].load(Ordering::Relaxed));
            Cost { rays: of(0), boxes: of(1), shapes: of(2), regions: of(3), skipped: of(4) }
        };
        self.cells.iter().map(cost).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::load;
    use crate::progress::Watch;
    use crate::signals::Signals;
    use crate::wanted::{Precision, Wanted};
    use std::path::Path;
    use std::sync::Arc;

    #[test]
    fn all_pixels_together_cost_what_the_picture_costs() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/classic.toml");
        let scene = load(&path).unwrap();
        let size = Size::new(40, 30).unwrap();
        for (sampler, select, precision) in [
            ("single", None, Precision::Single),
            ("adaptive:2:0.1", None, Precision::Single),
            ("stochastic:3", Some("4:0.05"), Precision::Single),
            ("regular:2", None, Precision::Double),
        ] {
            let sheet = Arc::new(Sheet::new(size));
            let wanted = Wanted {
                sampling: sampler.parse().unwrap(),
                selecting: select.map(|text: &str| text.parse().unwrap()),
                precision,
                sheet: Some(Arc::clone(&sheet)),
                ..Wanted::of(size)
            };
            let watch = Watch::silent(Signals::default());
            let frame = crate::frame::trace(&scene, &wanted, &watch).unwrap();
            let counts = frame.counters.unwrap();
            let costs = sheet.costs();
            for kind in RayKind::ALL {
                let sum = |of: fn(&Cost) -> [u32; KINDS]| {
                    costs.iter().map(|cost| u64::from(of(cost)[kind as usize])).sum::<u64>()
                };
                let sums = [sum(|it| it.rays), sum(|it| it.boxes), sum(|it| it.shapes), sum(|it| it.regions)];
                let whole =
                    [counts.rays(kind), counts.boxes(kind), counts.shapes(kind), counts.regions(kind)];
                assert_eq!(sums, whole, "{sampler} {kind:?}");
            }
            let free = Wanted { sheet: None, ..wanted };
            let plain = crate::frame::trace(&scene, &free, &watch).unwrap();
            assert_eq!(plain.picture.digest(), frame.picture.digest(), "{sampler}");
        }
    }

    #[test]
    fn what_lies_beyond_the_rim_is_charged_to_the_rim() {
        let sheet = Sheet::new(Size::new(3, 2).unwrap());
        let one = Cost { rays: [1, 0, 0, 0], ..Cost::default() };
        for (x, y) in [(-0.5, -3.0), (2.9, 1.9), (3.0, 2.0), (1.0, 0.0), (f64::NAN, 0.0)] {
            sheet.charge(x, y, &one);
        }
        assert_eq!(sheet.costs().iter().map(|cost| cost.rays[0]).collect::<Vec<_>>(), [2, 1, 0, 0, 0, 2]);
    }
}
