//! Rays through the corners of pixels, which neighbours share: the ground of adaptive
//! supersampling.
//!
//! A picture of `w` times `h` pixels has `(w + 1) (h + 1)` corners. Two ways to trace none of
//! them twice: with memory for all of them ([`Corner`] fills it in any order, tile by tile if need be,
//! and [`Lattice`] reads it), or with memory for one row ([`CornerRow`]).

use super::pixel::{Pixel, Tile};
use super::sampler::{Sampler, inside};
use crate::math::Rgb;
use crate::scene::{Place, Size};

/// The mean of a pixel's four corners.
fn mean(upper: [Rgb; 2], lower: [Rgb; 2]) -> Rgb {
    ((upper[0] + upper[1]) + (lower[0] + lower[1])) * 0.25
}

/// One ray through the upper left corner of each pixel.
///
/// Over a rectangle that is one pixel wider and higher than the picture it traces every corner
/// of the picture.
#[derive(Clone, Copy, Debug)]
pub struct Corner;

impl Sampler for Corner {
    fn color(&mut self, pixel: Pixel, shoot: &mut impl FnMut(Place) -> Rgb) -> Rgb {
        shoot(inside(pixel, 0.0, 0.0))
    }
}

/// The corners of all pixels of a picture, already traced.
#[derive(Clone, Copy, Debug)]
pub struct Lattice<'m> {
    tile: Tile,
    corners: &'m [Rgb],
}

impl<'m> Lattice<'m> {
    /// The rectangle whose upper left corners are all corners of a picture.
    pub fn tile(size: Size) -> Tile {
        Tile { first: Pixel { x: 0, y: 0 }, width: size.width() + 1, height: size.height() + 1 }
    }

    /// The corners of a picture of `size`, row by row; none when they are not
    /// `(width + 1) (height + 1)`.
    pub fn new(size: Size, corners: &'m [Rgb]) -> Option<Self> {
        let tile = Self::tile(size);
        (corners.len() == tile.len()).then_some(Lattice { tile, corners })
    }

    fn corner(&self, x: u32, y: u32) -> Rgb {
        let place = self.tile.place(Pixel { x, y });
        place.and_then(|place| self.corners.get(place)).copied().unwrap_or(Rgb::BLACK)
    }
}

impl Sampler for Lattice<'_> {
    fn color(&mut self, Pixel { x, y }: Pixel, _: &mut impl FnMut(Place) -> Rgb) -> Rgb {
        mean([self.corner(x, y), self.corner(x + 1, y)], [self.corner(x, y + 1), self.corner(x + 1, y + 1)])
    }
}

/// The corners of one row of pixels, in lent memory.
///
/// Pixels that come row by row, each row from its first to its last, share all their corners.
/// In any other order they are right as well, but some corners are traced again.
#[derive(Debug)]
pub struct CornerRow<'m> {
    /// The corners above the pixels to come, and below those that have been.
    row: &'m mut [Rgb],
    /// The pixel that shares corners with the last one.
    next: Option<Pixel>,
    first: u32,
    /// Whether `row` holds the corners above the pixels to come.
    above: bool,
    /// The last pixel's lower right corner.
    last: Rgb,
}

impl<'m> CornerRow<'m> {
    /// For rows of `row.len() - 1` pixels. With less than two corners it remembers nothing, and
    /// traces all four of every pixel.
    pub fn new(row: &'m mut [Rgb]) -> Self {
        CornerRow { row, next: None, first: 0, above: false, last: Rgb::BLACK }
    }

    fn at(&self, place: u32) -> Rgb {
        self.row.get(place as usize).copied().unwrap_or(Rgb::BLACK)
    }

    fn set(&mut self, place: u32, color: Rgb) {
        if let Some(slot) = self.row.get_mut(place as usize) {
            *slot = color;
        }
    }
}

impl Sampler for CornerRow<'_> {
    fn color(&mut self, pixel: Pixel, shoot: &mut impl FnMut(Place) -> Rgb) -> Rgb {
        let width = self.row.len().saturating_sub(1) as u32;
        if self.next != Some(pixel) {
            // A new beginning: only the corners of this pixel are needed, and none is known.
            (self.first, self.above) = (pixel.x, false);
        }
        let place = pixel.x.saturating_sub(self.first);
        let begins = place == 0;
        let upper_left = match (self.above, begins) {
            (false, true) => shoot(inside(pixel, 0.0, 0.0)),
            _ => self.at(place),
        };
        let upper_right = if self.above { self.at(place + 1) } else { shoot(inside(pixel, 1.0, 0.0)) };
        let lower_left = if begins { shoot(inside(pixel, 0.0, 1.0)) } else { self.last };
        let lower_right = shoot(inside(pixel, 1.0, 1.0));

        self.set(place, lower_left);
        self.last = lower_right;
        self.next = if place + 1 < width {
            // The upper left corner of the next pixel.
            self.set(place + 1, upper_right);
            Some(Pixel { x: pixel.x + 1, y: pixel.y })
        } else if width > 0 {
            self.set(place + 1, lower_right);
            self.above = true;
            Some(Pixel { x: self.first, y: pixel.y + 1 })
        } else {
            None // there is no room to remember anything
        };
        mean([upper_left, upper_right], [lower_left, lower_right])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn color(place: Place) -> Rgb {
        Rgb::new(place.x * place.y, place.x, place.y * place.y)
    }

    /// The mean of the four corners, traced for each pixel anew.
    fn truth(pixel: Pixel) -> Rgb {
        let at = |x, y| color(inside(pixel, x, y));
        mean([at(0.0, 0.0), at(1.0, 0.0)], [at(0.0, 1.0), at(1.0, 1.0)])
    }

    #[test]
    fn a_row_of_memory_traces_each_corner_once() {
        for (w, h) in [(1, 1), (1, 4), (4, 1), (5, 3)] {
            let mut memory = [Rgb::BLACK; 8];
            let mut sampler = CornerRow::new(&mut memory[..w as usize + 1]);
            let mut rays = 0;
            let tile = Tile { first: Pixel { x: 2, y: 7 }, width: w, height: h };
            for pixel in tile.pixels() {
                let mut shoot = |place| {
                    rays += 1;
                    color(place)
                };
                assert_eq!(sampler.color(pixel, &mut shoot), truth(pixel), "{pixel:?} of {w}x{h}");
            }
            assert_eq!(rays, (w + 1) * (h + 1));
        }
    }

    #[test]
    fn a_row_of_memory_is_right_in_any_order() {
        let mut memory = [Rgb::BLACK; 4];
        let mut sampler = CornerRow::new(&mut memory);
        for (x, y) in [(1, 0), (2, 0), (0, 1), (2, 0), (3, 0), (4, 0), (2, 1), (3, 1), (1, 2), (9, 9)] {
            let pixel = Pixel { x, y };
            assert_eq!(sampler.color(pixel, &mut color), truth(pixel), "{pixel:?}");
        }
    }

    #[test]
    fn a_lattice_gives_the_same_and_traces_nothing() {
        let size = Size::new(3, 2).unwrap();
        let mut memory = [Rgb::BLACK; 12];
        for (slot, pixel) in memory.iter_mut().zip(Lattice::tile(size).pixels()) {
            *slot = Corner.color(pixel, &mut color);
        }
        let mut lattice = Lattice::new(size, &memory).unwrap();
        for pixel in Tile::whole(size).pixels() {
            assert_eq!(lattice.color(pixel, &mut |_| unreachable!()), truth(pixel));
        }
        assert!(Lattice::new(size, &memory[..11]).is_none());
    }
}
