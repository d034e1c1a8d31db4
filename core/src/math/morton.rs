//! Morton codes: the interleaved bits of three cell coordinates.
//!
//! The code of a cell in a grid of `2^n` cells along each axis has three bits for each of the `n` levels
//! of an octree, the highest level first, in the order `z`, `y`, `x`. The three lowest bits are the index
//! of a cell among its eight siblings, the other bits are the code of its parent, and the order of the
//! codes is the depth-first order of the octree.
//!
//! Source: Morton, "A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing",
//! IBM 1966.

/// Largest number of bits of a cell coordinate.
///
/// The 10 bits that fit into a code of 32 bits do not separate the smallest spheres of a sphereflake.
pub const BITS_PER_AXIS: u32 = 21;

/// A Morton code: up to [`BITS_PER_AXIS`] groups of three bits.
pub type MortonCode = u64;

/// The code of the cell with the given coordinates, each less than `2^BITS_PER_AXIS`.
#[cfg(test)]
pub const fn interleave([x, y, z]: [u32; 3]) -> MortonCode {
    spread_bits(x) | spread_bits(y) << 1 | spread_bits(z) << 2
}

/// The coordinates of the cell with the given code: the inverse of `interleave`.
pub const fn deinterleave(code: MortonCode) -> [u32; 3] {
    [compact_bits(code), compact_bits(code >> 1), compact_bits(code >> 2)]
}

/// Moves bit `i` to bit `3 i`, by separating halves, quarters, ... of the bits.
#[cfg(test)]
const fn spread_bits(x: u32) -> MortonCode {
    let x = x as MortonCode & 0x1f_ffff;
    let x = (x | x << 32) & 0x001f_0000_0000_ffff;
    let x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    let x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    let x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

/// Moves bit `3 i` to bit `i` and drops the others.
const fn compact_bits(code: MortonCode) -> u32 {
    let x = code & 0x1249_2492_4924_9249;
    let x = (x | x >> 2) & 0x10c3_0c30_c30c_30c3;
    let x = (x | x >> 4) & 0x100f_00f0_0f00_f00f;
    let x = (x | x >> 8) & 0x001f_0000_ff00_00ff;
    let x = (x | x >> 16) & 0x001f_0000_0000_ffff;
    ((x | x >> 32) & 0x1f_ffff) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAST: u32 = (1 << BITS_PER_AXIS) - 1;

    #[test]
    fn deinterleave_is_the_inverse_of_interleave() {
        for i in 0..BITS_PER_AXIS {
            for axis in 0..3 {
                let mut cell = [0; 3];
                cell[axis] = 1 << i;
                assert_eq!(interleave(cell), 1 << (3 * i + axis as u32));
                assert_eq!(deinterleave(interleave(cell)), cell);
            }
        }
        assert_eq!(interleave([LAST; 3]), (1 << (3 * BITS_PER_AXIS)) - 1);
        assert_eq!(
            deinterleave(interleave([0x12_3456, 0xf_edcb, 0x1a_5a5a])),
            [0x12_3456, 0xf_edcb, 0x1a_5a5a]
        );
    }

    #[test]
    fn codes_are_in_the_depth_first_order_of_an_octree() {
        let cells: [_; 8] = core::array::from_fn(|code| deinterleave(code as MortonCode));
        assert_eq!(
            cells,
            [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]]
        );
        for code in 0..4096 {
            assert_eq!(
                deinterleave(code).map(|n| n / 2),
                deinterleave(code >> 3),
                "the parent has half the coordinates"
            );
        }
    }
}
