//! Random sample points in the unit square: a hash-scrambled Sobol sequence.
//!
//! A sample point is a function of the pixel, the index of the sample in the pixel, its use
//! ([`Dimension`]) and the seed of the picture. There is no state, so a picture does not depend on the
//! order of the pixels or on the thread that traces them. Every use has a fixed number, so an effect that
//! is turned on or off does not change the sample points of the others.
//!
//! The points of one pixel and one dimension are the first two dimensions of the Sobol sequence, a
//! (0,2)-sequence: every prefix is well distributed, best if its length is a power of two. Hashes of
//! pixel and dimension shuffle and scramble it.
//!
//! Source: Burley, "Practical Hash-Based Owen Scrambling", JCGT 2020. The constants of the hashes are
//! those of Wellons, "hash-prospector", and Vegdahl, "Building a Better LK Hash", 2021.

use super::Real;

/// Identifies one of the random choices of a camera sample, each of which has its own sample point in a
/// [`SobolSequence`]: a position in the pixel, on the lens or on a light, a time, or a microfacet normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension(u32);

impl Dimension {
    /// Position inside the pixel: x and y.
    pub const PIXEL: Dimension = Dimension(0);
    /// Position on the lens: two coordinates, mapped to a disc.
    pub const LENS: Dimension = Dimension(1);
    /// Time between opening and closing of the shutter: the first coordinate; the second one is not used.
    pub const SHUTTER: Dimension = Dimension(2);

    /// Microfacet normal of a rough surface hit by a ray of the given level (camera rays have level 1): two
    /// coordinates.
    pub const fn microfacet(level: u8) -> Self {
        Dimension(3 | (level as u32) << 8)
    }

    /// Position on the light with the given index, for a point hit by a ray of the given level
    /// (camera rays have level 1): two coordinates.
    pub const fn light(level: u8, light: u16) -> Self {
        Dimension(4 | (level as u32) << 8 | (light as u32) << 16)
    }
}

/// The sample points of one camera sample: a point in the unit square for each [`Dimension`].
///
/// It is a value without a position: the point for a dimension depends only on the arguments of
/// [`SobolSequence::new`] and on the dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SobolSequence {
    /// Hash of pixel and seed.
    pixel_hash: u32,
    /// Index of the sample in the pixel.
    index: u32,
}

impl SobolSequence {
    /// The sample points of the sample with the given `index` in the pixel `(x, y)` of a picture with the
    /// given `seed`.
    pub const fn new(x: u32, y: u32, index: u32, seed: u32) -> Self {
        SobolSequence { pixel_hash: hash(hash(hash(seed) ^ x) ^ y), index }
    }

    /// The point in the unit square for `dimension`, each coordinate in `[0, 1)`.
    ///
    /// Coordinates are multiples of `2^-24`, so they are the same in both precisions.
    pub const fn sample_2d(self, dimension: Dimension) -> [Real; 2] {
        let key = hash(self.pixel_hash ^ hash(dimension.0));
        // The index is scrambled, too, so that the points of two dimensions are not correlated.
        let index = owen_scramble(self.index.reverse_bits(), key).reverse_bits();
        let x = owen_scramble(index, hash(key ^ 0x68bc_21eb));
        let y = owen_scramble(sobol_second_dimension(index), hash(key ^ 0x02e5_be93));
        [to_unit_interval(x.reverse_bits()), to_unit_interval(y.reverse_bits())]
    }
}

/// A hash of 32 bits: every bit of the result depends on every bit of `x`.
const fn hash(x: u32) -> u32 {
    let x = x.wrapping_add(0x9e37_79b9);
    let x = (x ^ x >> 16).wrapping_mul(0x7feb_352d);
    let x = (x ^ x >> 15).wrapping_mul(0x846c_a68b);
    x ^ x >> 16
}

/// Owen scrambling of the reversed bits of a number: a hash of the lower bits decides whether a bit is
/// flipped.
const fn owen_scramble(x: u32, key: u32) -> u32 {
    let x = x ^ x.wrapping_mul(0x3d20_adea);
    let x = x.wrapping_add(key).wrapping_mul(key >> 16 | 1);
    let x = x ^ x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}

/// The second dimension of the Sobol sequence at index `x`, as reversed bits. (The first dimension, as
/// reversed bits, is `x` itself.)
///
/// It is the product of `x` and Pascal's triangle modulo two. This matrix is the fivefold Kronecker power
/// of its 2 by 2 corner, so the product takes one step for each of the five factors.
const fn sobol_second_dimension(x: u32) -> u32 {
    let x = x ^ (x >> 1 & 0x5555_5555);
    let x = x ^ (x >> 2 & 0x3333_3333);
    let x = x ^ (x >> 4 & 0x0f0f_0f0f);
    let x = x ^ (x >> 8 & 0x00ff_00ff);
    x ^ (x >> 16 & 0x0000_ffff)
}

/// The upper 24 bits as a fraction in `[0, 1)`.
const fn to_unit_interval(bits: u32) -> Real {
    (bits >> 8) as Real * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(x: u32, dimension: Dimension) -> impl Iterator<Item = [Real; 2]> {
        (0..).map(move |index| SobolSequence::new(x, 7, index, 1).sample_2d(dimension))
    }

    #[test]
    fn the_second_dimension_agrees_with_sobols_direction_numbers() {
        for n in [0, 1, 2, 3, 5, 100, 0x8000_0000, 0xdead_beef, u32::MAX] {
            // Source: Kollig and Keller, "Efficient Multidimensional Sampling", Eurographics 2002.
            let (mut sum, mut direction, mut rest) = (0, 1_u32 << 31, n);
            while rest != 0 {
                if rest & 1 != 0 {
                    sum ^= direction;
                }
                direction ^= direction >> 1;
                rest >>= 1;
            }
            assert_eq!(sobol_second_dimension(n).reverse_bits(), sum, "{n}");
        }
    }

    #[test]
    fn every_elementary_interval_contains_one_point() {
        // The (0,2) property of the first 64 points: of 64 equal rectangles whose sides are powers of two,
        // each contains exactly one point.
        for pixel_x in 0..20 {
            for dimension in [Dimension::PIXEL, Dimension::microfacet(3), Dimension::light(1, 2)] {
                for exponent in 0..=6 {
                    let (columns, rows) = (1 << exponent, 64 >> exponent);
                    let mut counts = [0; 64];
                    for [x, y] in points(pixel_x, dimension).take(64) {
                        let (column, row) = ((x * columns as Real) as usize, (y * rows as Real) as usize);
                        counts[row * columns + column] += 1;
                    }
                    assert_eq!(counts, [1; 64], "{pixel_x} {dimension:?} {columns}");
                }
            }
        }
    }

    #[test]
    fn pixels_dimensions_and_seeds_are_uncorrelated() {
        // Independent values of 4096 pixels have a correlation with a standard deviation of 1/64.
        let pairs: [fn(u32) -> (Real, Real); 5] = [
            |n| (at(n, 0, 0).sample_2d(Dimension::PIXEL)[0], at(n, 0, 0).sample_2d(Dimension::PIXEL)[1]),
            |n| (at(n, 0, 0).sample_2d(Dimension::PIXEL)[0], at(n, 0, 0).sample_2d(Dimension::LENS)[0]),
            |n| (at(n, 0, 0).sample_2d(Dimension::PIXEL)[0], at(n + 1, 0, 0).sample_2d(Dimension::PIXEL)[0]),
            |n| (at(n, 0, 0).sample_2d(Dimension::PIXEL)[0], at(n, 0, 1).sample_2d(Dimension::PIXEL)[0]),
            |n| {
                (
                    at(n, 1, 0).sample_2d(Dimension::microfacet(1))[1],
                    at(n, 1, 0).sample_2d(Dimension::microfacet(2))[1],
                )
            },
        ];
        fn at(n: u32, index: u32, seed: u32) -> SobolSequence {
            SobolSequence::new(n % 64, n / 64, index, seed)
        }
        for (index, pair) in pairs.iter().enumerate() {
            let mut sum = 0.0;
            for n in 0..4096 {
                let (a, b) = pair(n);
                assert!((0.0..1.0).contains(&a) && (0.0..1.0).contains(&b));
                sum += (a - 0.5) * (b - 0.5);
            }
            let correlation = sum / 4096.0 * 12.0;
            assert!(correlation.abs() < 4.5 / 64.0, "{index}: {correlation}");
        }
    }

    #[test]
    fn both_precisions_have_the_same_sample_points() {
        let [x, y] = SobolSequence::new(3, 4, 5, 6).sample_2d(Dimension::LENS);
        assert_eq!([x * 16_777_216.0, y * 16_777_216.0], [12_800_099.0, 12_084_261.0]);
    }
}
