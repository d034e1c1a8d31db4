//! Triangle blocks: the items of a leaf, four at a time, with the vertices of their triangles.
//!
//! Testing a triangle of a mesh reads three tables: the shape of the item, the indices of its vertices, the
//! vertices. A block stores the vertices of up to four triangles together with the item ids, and one
//! vectorized test rejects most of them at once. The remaining candidates are tested as usual, with the same
//! vertices, so blocks change the time and never the result.

use crate::geometry::{Geometry, ItemId, Ray, Shape, Triangle4};
use crate::math::{SIMD_WIDTH, Vec3};

/// Up to four items of a leaf of a [`Bvh`](super::Bvh): triangles with their vertices, tested four at a
/// time, and the ids of other items.
///
/// * Memory: 164 bytes in single precision.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct TriangleBlock {
    triangles: Triangle4,
    items: [ItemId; SIMD_WIDTH],
    /// One bit per entry in use.
    item_mask: u8,
    /// One bit per entry that is a triangle.
    triangle_mask: u8,
    /// Whether more blocks of the leaf follow.
    has_next: bool,
}

#[cfg(not(feature = "double"))]
const _: () = assert!(size_of::<TriangleBlock>() == 164);

/// An item of a block that the ray may hit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    pub(crate) item: ItemId,
    /// Its vertices, world space; `None` if it is not a triangle.
    pub(crate) corners: Option<[Vec3; 3]>,
}

impl TriangleBlock {
    /// Largest number of items of a block.
    pub const CAPACITY: usize = SIMD_WIDTH;

    /// The initial value for buffers.
    pub const EMPTY: TriangleBlock = TriangleBlock {
        triangles: Triangle4::ZERO,
        items: [ItemId(0); SIMD_WIDTH],
        item_mask: 0,
        triangle_mask: 0,
        has_next: false,
    };

    /// A block of the first four of `items`.
    pub(super) fn new(geometry: &Geometry<'_>, items: impl Iterator<Item = ItemId>, has_next: bool) -> Self {
        let mut block = TriangleBlock { has_next, ..TriangleBlock::EMPTY };
        for ((index, entry), item) in block.items.iter_mut().enumerate().zip(items) {
            *entry = item;
            block.item_mask |= 1 << index;
            if let Some(Shape::Triangle(corners) | Shape::SmoothTriangle(corners)) = geometry.shape(item)
                && let Some(corners) = geometry.vertices(*corners)
            {
                block.triangles.set(index, corners);
                block.triangle_mask |= 1 << index;
            }
        }
        block
    }

    /// The items of the block, in order.
    pub fn items(&self) -> impl Iterator<Item = ItemId> + '_ {
        self.items_in_mask(u32::MAX)
    }

    /// A mask of the items that the ray may hit; the ray certainly misses the others.
    #[inline(always)]
    pub(crate) fn possible_hits(&self, ray: &Ray) -> u32 {
        let triangle_mask = u32::from(self.triangle_mask);
        let hits = if triangle_mask == 0 { 0 } else { self.triangles.possible_hits(ray) };
        u32::from(self.item_mask) & (hits | !triangle_mask)
    }

    /// The items in `mask`. The number of steps does not depend on `mask`, so that a loop without effect is
    /// optimized away.
    #[inline(always)]
    pub(crate) fn items_in_mask(&self, mask: u32) -> impl Iterator<Item = ItemId> + '_ {
        let mask = mask & u32::from(self.item_mask);
        self.items.iter().zip(0..).filter(move |(_, index)| mask >> index & 1 != 0).map(|(item, _)| *item)
    }

    /// Removes the lowest bit of `mask` and returns its item. It is no iterator, because the optimizer keeps
    /// those in memory, and most blocks have at most one candidate.
    #[inline(always)]
    pub(crate) fn take_candidate(&self, mask: &mut u32) -> Option<Candidate> {
        let index = mask.trailing_zeros();
        let item = *self.items.get(index as usize)?;
        *mask &= *mask - 1;
        let is_triangle = u32::from(self.triangle_mask) >> index & 1 != 0;
        let corners = if is_triangle { self.triangles.vertices(index as usize) } else { None };
        Some(Candidate { item, corners })
    }

    #[inline(always)]
    pub(super) const fn has_next(&self) -> bool {
        self.has_next
    }
}
