//! Squares of the picture, quartered where their corners exceed the contrast threshold.
//!
//! Used by adaptive supersampling, where the square is a pixel, and by pixel-selected tracing, where it is a
//! block of pixels. The corners of all squares are on one grid, so that neighbors share samples.

use heapless::Vec;

use super::contrast::ContrastThreshold;
use crate::math::{Real, Rgb};
use crate::trace::{HitId, PixelSample};

/// Largest number of times that a square is quartered.
pub(super) const MAX_DEPTH: u8 = 6;

/// At each depth, three quarters are pending while the fourth is visited.
const MAX_PENDING: usize = 3 * MAX_DEPTH as usize + 1;

/// A square and the samples at its corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Square {
    /// Left edge, in steps of the finest grid.
    pub(super) x: u32,
    /// Upper edge.
    pub(super) y: u32,
    /// Length of the sides, a power of two.
    pub(super) side: u32,
    /// Samples at the corners: upper left, upper right, lower left, lower right.
    pub(super) corners: [PixelSample; 4],
}

impl Square {
    /// Mean color of the corners.
    pub(super) fn mean(&self) -> Rgb {
        let [a, b, c, d] = self.corners.map(|corner| corner.color);
        ((a + b) + (c + d)) * 0.25
    }

    /// The item that all corners hit, or [`HitId::Several`].
    pub(super) fn hit(&self) -> HitId {
        let [a, b, c, d] = self.corners.map(|corner| corner.hit);
        a.same_or_mixed(b).same_or_mixed(c.same_or_mixed(d))
    }

    /// Bilinear interpolation of the colors of the corners at `(x, y)`, both in `0..=1`.
    pub(super) fn interpolate(&self, x: Real, y: Real) -> Rgb {
        let [a, b, c, d] = self.corners.map(|corner| corner.color);
        a.lerp(b, x).lerp(c.lerp(d, x), y)
    }

    /// Its quarters, in the order of the corners. `sample_at` traces a grid point.
    fn quarters(&self, sample_at: &mut impl FnMut(u32, u32) -> PixelSample) -> [Square; 4] {
        let Square { x, y, corners: [a, b, c, d], .. } = *self;
        let side = self.side / 2;
        let (center_x, center_y) = (x + side, y + side);
        let top = sample_at(center_x, y);
        let left = sample_at(x, center_y);
        let center = sample_at(center_x, center_y);
        let right = sample_at(x + self.side, center_y);
        let bottom = sample_at(center_x, y + self.side);
        [
            Square { x, y, side, corners: [a, top, left, center] },
            Square { x: center_x, y, side, corners: [top, b, center, right] },
            Square { x, y: center_y, side, corners: [left, center, c, bottom] },
            Square { x: center_x, y: center_y, side, corners: [center, right, bottom, d] },
        ]
    }
}

/// Quarters `whole` until the corners of every square meet the threshold or its side is `min_side`, and
/// passes the squares to `visit`.
pub(super) fn subdivide(
    whole: Square,
    threshold: &ContrastThreshold,
    min_side: u32,
    sample_at: &mut impl FnMut(u32, u32) -> PixelSample,
    visit: &mut impl FnMut(&Square),
) {
    let mut pending: Vec<Square, MAX_PENDING> = Vec::new();
    let mut next = Some(whole);
    while let Some(square) = next {
        if square.side > min_side && !threshold.accepts(&square.corners) {
            let [first, second, third, fourth] = square.quarters(sample_at);
            for later in [fourth, third, second] {
                let pushed = pending.push(later);
                debug_assert!(pushed.is_ok(), "more squares than depths");
            }
            next = Some(first);
        } else {
            visit(&square);
            next = pending.pop();
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
    fn squares_cover_the_whole_once_and_are_small_at_edges() {
        let whole = Square {
            x: 0,
            y: 0,
            side: 64,
            corners: [(0, 0), (64, 0), (0, 64), (64, 64)].map(|(x, y)| sample(x, y)),
        };
        let mut covered = [[0; 64]; 64];
        let (mut area, mut traced) = (0.0, 0);
        let threshold = ContrastThreshold::new(0.5).unwrap();
        let mut sample_at = |x, y| {
            traced += 1;
            sample(x, y)
        };
        subdivide(whole, &threshold, 1, &mut sample_at, &mut |square| {
            for row in &mut covered[square.y as usize..][..square.side as usize] {
                for cell in &mut row[square.x as usize..][..square.side as usize] {
                    *cell += 1;
                }
            }
            assert!(square.side == 1 || threshold.accepts(&square.corners));
            area += square.mean().r * (square.side * square.side) as Real;
        });
        assert!(covered.iter().flatten().all(|count| *count == 1));
        // A quarter of a circle.
        assert!((area - crate::math::PI * 45.0 * 45.0 / 4.0).abs() < 10.0, "{area}");
        assert!(traced < 1000, "{traced} of 4225");
    }

    #[test]
    fn interpolation_is_exact_at_the_corners() {
        let gray = |value: Real| PixelSample { color: Rgb::gray(value), hit: HitId::Nothing };
        let square = Square { x: 0, y: 0, side: 1, corners: [0.0, 1.0, 2.0, 4.0].map(gray) };
        for (x, y, expected) in
            [(0.0, 0.0, 0.0), (1.0, 0.0, 1.0), (0.0, 1.0, 2.0), (1.0, 1.0, 4.0), (0.5, 0.5, 1.75)]
        {
            assert_eq!(square.interpolate(x, y), Rgb::gray(expected));
        }
    }
}
