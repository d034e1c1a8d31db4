//! Pixels and rectangles of pixels.

use crate::scene::Resolution;

/// Coordinates of a pixel. (0, 0) is the upper left pixel of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// Column.
    pub x: u32,
    /// Row, from the top.
    pub y: u32,
}

/// A rectangle of pixels, at any position and of any size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Upper left pixel.
    pub top_left: Pixel,
    /// Number of pixels in a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
}

impl Tile {
    /// The tile of a whole picture.
    ///
    /// ```
    /// use strahl_core::{Resolution, Tile};
    ///
    /// let tile = Tile::full(Resolution::new(4, 3).unwrap());
    /// assert_eq!(tile.pixels().count(), 12);
    /// ```
    pub fn full(resolution: Resolution) -> Self {
        Tile { top_left: Pixel { x: 0, y: 0 }, width: resolution.width(), height: resolution.height() }
    }

    /// All pixels of the tile, row by row from the upper left one.
    pub fn pixels(self) -> impl Iterator<Item = Pixel> {
        let Tile { top_left: first, width, height } = self;
        (0..height).flat_map(move |y| (0..width).map(move |x| Pixel { x: first.x + x, y: first.y + y }))
    }

    /// The tile of the pixels that are in both tiles; empty if there are none.
    pub fn intersection(self, other: Tile) -> Tile {
        // From the larger start to the smaller end.
        let overlap = |a: u32, a_length: u32, b: u32, b_length: u32| {
            let start = a.max(b);
            (start, a.saturating_add(a_length).min(b.saturating_add(b_length)).saturating_sub(start))
        };
        let (x, width) = overlap(self.top_left.x, self.width, other.top_left.x, other.width);
        let (y, height) = overlap(self.top_left.y, self.height, other.top_left.y, other.height);
        Tile { top_left: Pixel { x, y }, width, height }
    }

    /// Number of pixels: `width * height`.
    pub fn len(self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Whether the tile has no pixels: its width or height is 0.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// Index of a pixel in the order of [`Tile::pixels`]; `None` if it is outside of the tile.
    pub fn index_of(self, pixel: Pixel) -> Option<usize> {
        let (x, y) = (pixel.x.checked_sub(self.top_left.x)?, pixel.y.checked_sub(self.top_left.y)?);
        (x < self.width && y < self.height).then_some(y as usize * self.width as usize + x as usize)
    }

    /// Divides the tile into tiles of at most `side` times `side` pixels, row by row. A `side` of 0 means
    /// 1.
    pub fn tiles(self, side: u32) -> impl Iterator<Item = Tile> {
        let side = if side > 0 { side } else { 1 };
        let starts = move |length: u32| (0..length).step_by(side as usize);
        let Tile { top_left: first, width, height } = self;
        starts(height).flat_map(move |y| {
            starts(width).map(move |x| Tile {
                top_left: Pixel { x: first.x + x, y: first.y + y },
                width: side.min(width - x),
                height: side.min(height - y),
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_every_pixel_once() {
        let whole = Tile { top_left: Pixel { x: 3, y: 5 }, width: 17, height: 9 };
        for side in [1, 4, 7, 100] {
            let mut visits = [0; 17 * 9];
            for tile in whole.tiles(side) {
                for pixel in tile.pixels() {
                    visits[whole.index_of(pixel).unwrap()] += 1;
                }
            }
            assert!(visits.iter().all(|count| *count == 1), "{side}");
        }
        assert_eq!(whole.index_of(Pixel { x: 20, y: 5 }), None);
        assert_eq!(whole.index_of(Pixel { x: 2, y: 5 }), None);
    }

    #[test]
    fn the_intersection_has_the_pixels_of_both() {
        let tile = |x, y, width, height| Tile { top_left: Pixel { x, y }, width, height };
        let (a, b) = (tile(2, 3, 10, 4), tile(5, 1, 20, 4));
        assert_eq!(a.intersection(b), tile(5, 3, 7, 2));
        assert_eq!(b.intersection(a), a.intersection(b));
        assert!(a.intersection(tile(12, 3, 5, 5)).is_empty() && a.intersection(tile(0, 0, 2, 9)).is_empty());
    }
}
