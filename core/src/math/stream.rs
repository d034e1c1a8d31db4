//! Numbers in `[0, 1)` as a function of where, which and what for: no state, no order.
//!
//! A picture that is sampled at random must not depend on who traces a pixel, nor on what was
//! traced before. So a number is not drawn but looked up: from the place in the picture, the
//! number of the sample there, what the number is for, and the seed of the picture. What it is
//! for has a fixed number of its own ([`Dimension`]), so that one effect more or less does not
//! change the numbers of the others.
//!
//! The numbers of one place and one dimension are points of the plane: the first `n` of them,
//! for every `n` and best for powers of two, lie as evenly as a (0,2)-sequence can. They are
//! Sobol's first two dimensions, shuffled and scrambled by hashes of place and dimension
//! ("Practical Hash-based Owen Scrambling", Burley, JCGT 2020; the constants of the hashes are
//! those of "hash-prospector", Wellons, and of Vegdahl's "Building a Better LK Hash", 2021).

use super::Real;

/// What a number is for. Each effect at each level of the tree of rays, and each light, has its
/// own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension(u32);

impl Dimension {
    /// The place inside the pixel.
    pub const PIXEL: Dimension = Dimension(0);
    /// The place on the lens.
    pub const LENS: Dimension = Dimension(1);
    /// The moment while the shutter is open.
    pub const SHUTTER: Dimension = Dimension(2);

    /// The direction in the lobe of a rough surface that a ray of this level meets.
    pub const fn lobe(level: u8) -> Self {
        Dimension(3 | (level as u32) << 8)
    }

    /// The place on the light of this number, seen from what a ray of this level meets.
    pub const fn light(level: u8, light: u16) -> Self {
        Dimension(4 | (level as u32) << 8 | (light as u32) << 16)
    }
}

/// The numbers of one sample of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stream {
    place: u32,
    index: u32,
}

impl Stream {
    /// The numbers of the sample `index` of the place `(x, y)`, in the picture with this seed.
    pub const fn new(x: u32, y: u32, index: u32, seed: u32) -> Self {
        Stream { place: mixed(mixed(mixed(seed) ^ x) ^ y), index }
    }

    /// A point of the unit square, both coordinates in `[0, 1)`: multiples of `2^-24`, so that
    /// both precisions have the same.
    pub const fn pair(self, Dimension(dimension): Dimension) -> [Real; 2] {
        let key = mixed(self.place ^ mixed(dimension));
        // Which point of the sequence: the order is scrambled as the numbers are, so that the
        // points of one dimension do not go with those of another.
        let index = scrambled(self.index.reverse_bits(), key).reverse_bits();
        let x = scrambled(index, mixed(key ^ 0x68bc_21eb));
        let y = scrambled(pascal(index), mixed(key ^ 0x02e5_be93));
        [fraction(x.reverse_bits()), fraction(y.reverse_bits())]
    }
}

/// A hash of 32 bits: every bit of the answer depends on every bit of `x`.
const fn mixed(x: u32) -> u32 {
    let x = x.wrapping_add(0x9e37_79b9);
    let x = (x ^ x >> 16).wrapping_mul(0x7feb_352d);
    let x = (x ^ x >> 15).wrapping_mul(0x846c_a68b);
    x ^ x >> 16
}

/// Owen's scrambling of bits that stand in reverse: each is flipped or not by a hash of the
/// lower ones.
const fn scrambled(x: u32, key: u32) -> u32 {
    let x = x ^ x.wrapping_mul(0x3d20_adea);
    let x = x.wrapping_add(key).wrapping_mul(key >> 16 | 1);
    let x = x ^ x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}

/// Sobol's second dimension, its bits in reverse, of a number whose first dimension is the
/// number itself, in reverse: the product with Pascal's triangle modulo two. The triangle is
/// the fivefold Kronecker product of its upper corner, which takes one step for each factor.
const fn pascal(x: u32) -> u32 {
    let x = x ^ (x >> 1 & 0x5555_5555);
    let x = x ^ (x >> 2 & 0x3333_3333);
    let x = x ^ (x >> 4 & 0x0f0f_0f0f);
    let x = x ^ (x >> 8 & 0x00ff_00ff);
    x ^ (x >> 16 & 0x0000_ffff)
}

/// The upper 24 bits as a fraction.
const fn fraction(bits: u32) -> Real {
    (bits >> 8) as Real * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(place: u32, dimension: Dimension) -> impl Iterator<Item = [Real; 2]> {
        (0..).map(move |index| Stream::new(place, 7, index, 1).pair(dimension))
    }

    #[test]
    fn pascals_triangle_gives_sobols_second_dimension() {
        for n in [0, 1, 2, 3, 5, 100, 0x8000_0000, 0xdead_beef, u32::MAX] {
            // By the direction numbers, as in "Efficient Multidimensional Sampling" (Kollig,
            // Keller 2002).
            let (mut sum, mut direction, mut rest) = (0, 1_u32 << 31, n);
            while rest != 0 {
                if rest & 1 != 0 {
                    sum ^= direction;
                }
                direction ^= direction >> 1;
                rest >>= 1;
            }
            assert_eq!(pascal(n).reverse_bits(), sum, "{n}");
        }
    }

    #[test]
    fn every_box_of_a_power_of_two_holds_one_point() {
        // The (0,2) property of the first 64 points: in every way to cut the square into 64 equal boxes of
        // sides that are powers of two, each box has exactly one.
        for place in 0..20 {
            for dimension in [Dimension::PIXEL, Dimension::lobe(3), Dimension::light(1, 2)] {
                for wide in 0..=6 {
                    let (columns, rows) = (1 << wide, 64 >> wide);
                    let mut boxes = [0; 64];
                    for [x, y] in points(place, dimension).take(64) {
                        let (column, row) = ((x * columns as Real) as usize, (y * rows as Real) as usize);
                        boxes[row * columns + column] += 1;
                    }
                    assert_eq!(boxes, [1; 64], "{place} {dimension:?} {columns}");
                }
            }
        }
    }

    #[test]
    fn places_dimensions_and_seeds_have_nothing_to_do_with_each_other() {
        // The correlation of the first numbers of 4096 places, which is 1/64 by chance: 4.5 times that.
        let pairs: [fn(u32) -> (Real, Real); 5] = [
            |n| (at(n, 0, 0).pair(Dimension::PIXEL)[0], at(n, 0, 0).pair(Dimension::PIXEL)[1]),
            |n| (at(n, 0, 0).pair(Dimension::PIXEL)[0], at(n, 0, 0).pair(Dimension::LENS)[0]),
            |n| (at(n, 0, 0).pair(Dimension::PIXEL)[0], at(n + 1, 0, 0).pair(Dimension::PIXEL)[0]),
            |n| (at(n, 0, 0).pair(Dimension::PIXEL)[0], at(n, 0, 1).pair(Dimension::PIXEL)[0]),
            |n| (at(n, 1, 0).pair(Dimension::lobe(1))[1], at(n, 1, 0).pair(Dimension::lobe(2))[1]),
        ];
        fn at(n: u32, index: u32, seed: u32) -> Stream {
            Stream::new(n % 64, n / 64, index, seed)
        }
        for (pair, number) in pairs.iter().zip(0..) {
            let mut sum = 0.0;
            for n in 0..4096 {
                let (a, b) = pair(n);
                assert!((0.0..1.0).contains(&a) && (0.0..1.0).contains(&b));
                sum += (a - 0.5) * (b - 0.5);
            }
            let correlation = sum / 4096.0 * 12.0;
            assert!(correlation.abs() < 4.5 / 64.0, "{number}: {correlation}");
        }
    }

    #[test]
    fn both_precisions_have_the_same_numbers() {
        let [x, y] = Stream::new(3, 4, 5, 6).pair(Dimension::LENS);
        assert_eq!([x * 16_777_216.0, y * 16_777_216.0], [NUMBERS[0], NUMBERS[1]]);
    }

    const NUMBERS: [Real; 2] = [12_800_099.0, 12_084_261.0];
}
