//! Morton codes: three whole numbers, interleaved bit by bit into one.
//!
//! The code of a cell in a raster of `2^n` cells along each axis has three bits for each of `n`
//! halvings of space, the first halving highest: `z`, `y`, `x`. So the three lowest bits tell
//! which of its eight siblings a cell is, the rest is the code of its parent, and cells in the
//! order of their codes are in the order of a walk through the tree, depth first.
//!
//! Source: "A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing",
//! Morton, IBM 1966.

/// How often space can be halved along each axis. 10 would fit into a code of 32 bits; it takes more
/// to tell the smallest spheres of a sphereflake apart.
pub const HALVINGS: u32 = 21;

/// A code of up to [`HALVINGS`] times three bits.
pub type Code = u64;

/// The code of the cell with these numbers along each axis, each less than `2^HALVINGS`.
#[cfg(test)]
pub const fn interleave([x, y, z]: [u32; 3]) -> Code {
    spread(x) | spread(y) << 1 | spread(z) << 2
}

/// The numbers along each axis of the cell with this code.
pub const fn numbers(code: Code) -> [u32; 3] {
    [gather(code), gather(code >> 1), gather(code >> 2)]
}

/// Moves bit `i` to bit `3 i`, by moving halves, quarters, ... of the bits apart.
#[cfg(test)]
const fn spread(x: u32) -> Code {
    let x = x as Code & 0x1f_ffff;
    let x = (x | x << 32) & 0x001f_0000_0000_ffff;
    let x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    let x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    let x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

/// Moves bit `3 i` to bit `i`, and leaves out the others.
const fn gather(code: Code) -> u32 {
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

    const LAST: u32 = (1 << HALVINGS) - 1;

    #[test]
    fn every_bit_goes_to_its_place_and_back() {
        for i in 0..HALVINGS {
            for axis in 0..3 {
                let mut cell = [0; 3];
                cell[axis] = 1 << i;
                assert_eq!(interleave(cell), 1 << (3 * i + axis as u32));
                assert_eq!(numbers(interleave(cell)), cell);
            }
        }
        assert_eq!(interleave([LAST; 3]), (1 << (3 * HALVINGS)) - 1);
        assert_eq!(numbers(interleave([0x12_3456, 0xf_edcb, 0x1a_5a5a])), [0x12_3456, 0xf_edcb, 0x1a_5a5a]);
    }

    #[test]
    fn codes_in_their_order_go_through_each_eighth_before_the_next() {
        let cells: [_; 8] = core::array::from_fn(|code| numbers(code as Code));
        assert_eq!(
            cells,
            [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]]
        );
        for code in 0..4096 {
            assert_eq!(numbers(code).map(|n| n / 2), numbers(code >> 3), "the parent has half the numbers");
        }
    }
}
