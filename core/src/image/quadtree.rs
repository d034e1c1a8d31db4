//! Squares of the picture, quartered where their corners do not agree.
//!
//! The ground of adaptive supersampling, where the square is a pixel, and of pixel-selected
//! tracing, where it is a block of pixels. Both see the same picture at the corners of all
//! squares, so that neighbours share what they see there.

use heapless::Vec;

use super::contrast::ContrastThreshold;
use crate::math::{Real, Rgb};
use crate::trace::{HitId, PixelSample};

/// How often a square can be quartered.
pub(super) const MAX_DEPTH: u8 = 6;

/// At each depth three quarters wait while the fourth is worked on.
const MAX_PENDING: usize = 3 * MAX_DEPTH as usize + 1;

/// A square and what is seen at its corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Square {
    /// Its left edge, in the finest steps.
    pub(super) x: u32,
    /// Its upper edge.
    pub(super) y: u32,
    /// The length of its sides: a power of two.
    pub(super) side: u32,
    /// Upper left, upper right, lower left, lower right.
    pub(super) corners: [PixelSample; 4],
}

impl Square {
    /// The mean of its corners.
    pub(super) fn mean(&self) -> Rgb {
        let [a, b, c, d] = self.corners.map(|corner| corner.color);
        ((a + b) + (c + d)) * 0.25
    }

    /// What was hit at its corners.
    pub(super) fn hit(&self) -> HitId {
        let [a, b, c, d] = self.corners.map(|corner| corner.hit);
        a.merged(b).merged(c.merged(d))
    }

    /// The colour at the place `(x, y)` of the square, both in `0..=1`, between those of its corners.
    pub(super) fn interpolate(&self, x: Real, y: Real) -> Rgb {
        let [a, b, c, d] = self.corners.map(|corner| corner.color);
        a.lerp(b, x).lerp(c.lerp(d, x), y)
    }

    /// Its quarters, in the order of its corners. `find` says what is seen at a place.
    fn quarters(&self, find: &mut impl FnMut(u32, u32) -> PixelSample) -> [Square; 4] {
        let Square { x, y, corners: [a, b, c, d], .. } = *self;
        let side = self.side / 2;
        let (middle_x, middle_y) = (x + side, y + side);
        let top = find(middle_x, y);
        let left = find(x, middle_y);
        let middle = find(middle_x, middle_y);
        let right = find(x + self.side, middle_y);
        let bottom = find(middle_x, y + self.side);
        [
            Square { x, y, side, corners: [a, top, left, middle] },
            Square { x: middle_x, y, side, corners: [top, b, middle, right] },
            Square { x, y: middle_y, side, corners: [left, middle, c, bottom] },
            Square { x: middle_x, y: middle_y, side, corners: [middle, right, bottom, d] },
        ]
    }
}

/// Quarters `whole` until the corners of every part agree or its side is `least`, and hands the
/// parts to `part`.
pub(super) fn subdivide(
    whole: Square,
    agreement: &ContrastThreshold,
    least: u32,
    find: &mut impl FnMut(u32, u32) -> PixelSample,
    part: &mut impl FnMut(&Square),
) {
    let mut waiting: Vec<Square, MAX_PENDING> = Vec::new();
    let mut next = Some(whole);
    while let Some(square) = next {
        if square.side > least && !agreement.is_met(&square.corners) {
            let [first, second, third, fourth] = square.quarters(find);
            for later in [fourth, third, second] {
                let pushed = waiting.push(later);
                debug_assert!(pushed.is_ok(), "more squares than depths");
            }
            next = Some(first);
        } else {
            part(&square);
            next = waiting.pop();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(x: u32, y: u32) -> PixelSample {
        // A circle.
        let inside = x * x + y * y < 45 * 45;
        PixelSample { color: if inside { Rgb::WHITE } else { Rgb::BLACK }, hit: HitId::Nothing }
    }

    #[test]
    fn the_parts_cover_the_square_once_and_are_small_where_the_picture_changes() {
        let whole = Square {
            x: 0,
            y: 0,
            side: 64,
            corners: [(0, 0), (64, 0), (0, 64), (64, 64)].map(|(x, y)| sample(x, y)),
        };
        let mut covered = [[0; 64]; 64];
        let (mut area, mut traced) = (0.0, 0);
        let agreement = ContrastThreshold::new(0.5).unwrap();
        let mut find = |x, y| {
            traced += 1;
            sample(x, y)
        };
        subdivide(whole, &agreement, 1, &mut find, &mut |part| {
            for row in &mut covered[part.y as usize..][..part.side as usize] {
                for cell in &mut row[part.x as usize..][..part.side as usize] {
                    *cell += 1;
                }
            }
            assert!(part.side == 1 || agreement.is_met(&part.corners));
            area += part.mean().r * (part.side * part.side) as Real;
        });
        assert!(covered.iter().flatten().all(|count| *count == 1));
        // A quarter of a circle.
        assert!((area - crate::math::PI * 45.0 * 45.0 / 4.0).abs() < 10.0, "{area}");
        assert!(traced < 1000, "{traced} of 4225");
    }

    #[test]
    fn colours_between_corners_are_those_of_the_corners_at_the_corners() {
        let gray = |value: Real| PixelSample { color: Rgb::gray(value), hit: HitId::Nothing };
        let square = Square { x: 0, y: 0, side: 1, corners: [0.0, 1.0, 2.0, 4.0].map(gray) };
        for (x, y, want) in
            [(0.0, 0.0, 0.0), (1.0, 0.0, 1.0), (0.0, 1.0, 2.0), (1.0, 1.0, 4.0), (0.5, 0.5, 1.75)]
        {
            assert_eq!(square.interpolate(x, y), Rgb::gray(want));
        }
    }
}
