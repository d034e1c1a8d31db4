//! Pixels, and rectangles of them.

use crate::scene::Resolution;

/// A pixel, counted from the upper left corner of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// To the right.
    pub x: u32,
    /// Down.
    pub y: u32,
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Its upper left pixel.
    pub top_left: Pixel,
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Tile {
    /// The whole picture.
    pub fn full(size: Resolution) -> Self {
        Tile { top_left: Pixel { x: 0, y: 0 }, width: size.width(), height: size.height() }
    }

    /// Its pixels, row by row.
    pub fn pixels(self) -> impl Iterator<Item = Pixel> {
        let Tile { top_left: first, width, height } = self;
        (0..height).flat_map(move |y| (0..width).map(move |x| Pixel { x: first.x + x, y: first.y + y }))
    }

    /// The pixels that lie in `other` as well.
    pub fn intersection(self, other: Tile) -> Tile {
        // From the later begin to the earlier end.
        let span = |a: u32, a_length: u32, b: u32, b_length: u32| {
            let begin = a.max(b);
            (begin, a.saturating_add(a_length).min(b.saturating_add(b_length)).saturating_sub(begin))
        };
        let (x, width) = span(self.top_left.x, self.width, other.top_left.x, other.width);
        let (y, height) = span(self.top_left.y, self.height, other.top_left.y, other.height);
        Tile { top_left: Pixel { x, y }, width, height }
    }

    /// The number of its pixels.
    pub fn len(self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Whether it has no pixel.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// The number of a pixel in the order of [`Tile::pixels`]; none when it lies outside.
    pub fn index_of(self, pixel: Pixel) -> Option<usize> {
        let (x, y) = (pixel.x.checked_sub(self.top_left.x)?, pixel.y.checked_sub(self.top_left.y)?);
        (x < self.width && y < self.height).then_some(y as usize * self.width as usize + x as usize)
    }

    /// The rectangle cut into tiles of at most `side` times `side` pixels, row by row.
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
            let mut seen = [0; 17 * 9];
            for tile in whole.tiles(side) {
                for pixel in tile.pixels() {
                    seen[whole.index_of(pixel).unwrap()] += 1;
                }
            }
            assert!(seen.iter().all(|count| *count == 1), "{side}");
        }
        assert_eq!(whole.index_of(Pixel { x: 20, y: 5 }), None);
        assert_eq!(whole.index_of(Pixel { x: 2, y: 5 }), None);
    }

    #[test]
    fn what_lies_in_two_tiles_lies_in_both() {
        let tile = |x, y, width, height| Tile { top_left: Pixel { x, y }, width, height };
        let (a, b) = (tile(2, 3, 10, 4), tile(5, 1, 20, 4));
        assert_eq!(a.intersection(b), tile(5, 3, 7, 2));
        assert_eq!(b.intersection(a), a.intersection(b));
        assert!(a.intersection(tile(12, 3, 5, 5)).is_empty() && a.intersection(tile(0, 0, 2, 9)).is_empty());
    }
}
