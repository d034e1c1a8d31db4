//! Measures of the differences of single pixels.

use rayon::prelude::*;
use serde::Serialize;

/// One encoded channel of one pixel, in `[0, 1]`.
pub(super) trait Channel: Copy + Sync {
    /// The value; 0 for NaN.
    fn value(self) -> f64;

    /// The absolute difference, exact for integers.
    fn difference(self, other: Self) -> f64;
}

/// One 8-bit step, which is hardly visible.
const STEP: f64 = 1.0 / 255.0;

/// The largest allowed difference of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// Bit-identical.
    Identical,
    /// At most this much in each channel.
    Within(f64),
}

/// The largest difference and its location; of equal ones the first, row by row, red before green before blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The difference; 0 if there is none.
    pub difference: f64,
    /// Column, from 0 at the left.
    pub x: usize,
    /// Row, from 0 at the top.
    pub y: usize,
    /// The channel.
    pub channel: Color,
}

/// A color channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Color {
    /// Red.
    Red,
    /// Green.
    Green,
    /// Blue.
    Blue,
}

impl Color {
    /// All channels, in order.
    pub const ALL: [Color; 3] = [Color::Red, Color::Green, Color::Blue];

    /// The name of the channel, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Color::Red => "red",
            Color::Green => "green",
            Color::Blue => "blue",
        }
    }
}

impl Peak {
    /// No difference.
    pub(super) const NONE: Peak = Peak { difference: 0.0, x: 0, y: 0, channel: Color::Red };

    /// Includes the differences of one more pixel.
    pub(super) fn raise(&mut self, x: usize, y: usize, differences: [f64; 3]) {
        for (channel, difference) in Color::ALL.into_iter().zip(differences) {
            if difference > self.difference {
                *self = Peak { difference, x, y, channel };
            }
        }
    }
}

/// Measures over all pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// The largest difference of a channel.
    pub peak: Peak,
    /// The sum of the differences of all channels.
    pub absolute: f64,
    /// The sum of their squares.
    pub squares: f64,
    /// Pixels that differ at all.
    pub differing: usize,
    /// Pixels that differ by more than 1/255 in some channel.
    pub beyond: usize,
    /// Pixels that differ by more than the limit in some channel.
    pub over_limit: usize,
}

/// Compares pixel by pixel; `differs` returns whether the pixel at an index differs in any bit.
///
/// Rows are summed in order, so that the result does not depend on the number of threads.
pub(super) fn measure<C: Channel>(
    a: &[[C; 3]],
    b: &[[C; 3]],
    width: usize,
    limit: Limit,
    differs: impl Fn(usize) -> bool + Sync,
) -> Measures {
    let row = |y: usize, a: &[[C; 3]], b: &[[C; 3]]| {
        let mut row = Measures::NONE;
        for (x, (a, b)) in a.iter().zip(b).enumerate() {
            let all = channels(*a, *b);
            let differs = differs(y * width + x);
            row.peak.raise(x, y, all);
            row.absolute += all[0] + all[1] + all[2];
            row.squares += all[0] * all[0] + all[1] * all[1] + all[2] * all[2];
            row.differing += usize::from(differs);
            row.beyond += usize::from(largest(all) > STEP);
            row.over_limit += usize::from(match limit {
                Limit::Identical => differs,
                Limit::Within(most) => largest(all) > most,
            });
        }
        row
    };
    let rows = a.par_chunks(width).zip(b.par_chunks(width)).enumerate();
    let rows: Vec<Measures> = rows.map(|(y, (a, b))| row(y, a, b)).collect();
    rows.iter().fold(Measures::NONE, Measures::and)
}

/// The largest difference in each pixel.
pub(super) fn differences<C: Channel>(a: &[[C; 3]], b: &[[C; 3]]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| largest(channels(*a, *b))).collect()
}

fn channels<C: Channel>(a: [C; 3], b: [C; 3]) -> [f64; 3] {
    [a[0].difference(b[0]), a[1].difference(b[1]), a[2].difference(b[2])]
}

fn largest(all: [f64; 3]) -> f64 {
    all.into_iter().fold(0.0, |most, difference| if difference > most { difference } else { most })
}

impl Measures {
    const NONE: Measures =
        Measures { peak: Peak::NONE, absolute: 0.0, squares: 0.0, differing: 0, beyond: 0, over_limit: 0 };

    fn and(self, next: &Measures) -> Measures {
        Measures {
            peak: if next.peak.difference > self.peak.difference { next.peak } else { self.peak },
            absolute: self.absolute + next.absolute,
            squares: self.squares + next.squares,
            differing: self.differing + next.differing,
            beyond: self.beyond + next.beyond,
            over_limit: self.over_limit + next.over_limit,
        }
    }
}
