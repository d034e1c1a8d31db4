//! Walls: the planes that cut space into equal cells, and why no item is lost between them.
//!
//! A walk through cells asks one question only: how far along the ray is a wall? It is answered
//! here by the very arithmetic of the slab test ([`Aabb::span`]): subtract the origin, multiply
//! by the reciprocal. Each step of it is monotone, so of a wall and a face of a box whichever
//! comes first in space comes first in the answers too, or both are equal. No margin is added to
//! a box when it is placed. What the slab test grants beyond that is one thing: the far end of
//! its interval is widened by a factor, [`WIDEN`]. So walks enter every cell whose own interval
//! is not empty *after the same widening*:
//!
//! > Let the walls contain the boxes, and let the slab test say that a ray is inside an item's box
//! > from `entry` on. Then among the cells that the box touches there is one that begins, by its
//! > own walls, not after `entry`, and is not left, after widening, before it.
//!
//! Proof, axis by axis, in the direction of the ray. Let `e` be `entry`, or zero if that is more.
//! Of the cells that the box touches take the last one whose near wall is not beyond `e`. There
//! is one, because the first of them begins before the box does. If it is not the last of all, the
//! next one's near wall, which is its own far wall, is beyond `e`. If it is the last, its far wall
//! is beyond the far face of the box, whose distance, widened, is at least `e`, or the slab test
//! had said no. So the same cell serves all three axes at once, and a walk that leaves out only
//! what begins strictly beyond the query's reach has offered the item before it ends: a hit is never
//! reported before `entry`.
//!
//! A ray that runs along the walls of an axis (its reciprocal is infinite) stays between two of them,
//! and so do the faces of the boxes that it meets; but it may run in a wall, and meet boxes that touch
//! the wall from either side. A grid therefore places a box in the cells on both sides of a wall
//! that it touches; an octree, whose walls often coincide with faces, places it on its own side
//! and walks such a ray twice.
//!
//! [`Aabb::span`]: crate::geometry::Aabb::span
//! [`WIDEN`]: crate::geometry::WIDEN

use super::BuildError;
use crate::geometry::{Aabb, ItemId};
use crate::math::{Real, Vec3, vec3};

/// Equally spaced planes upright on each axis: number 0 is the smallest face of a box, and the last
/// lies in its largest face or, by rounding, a little outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Walls {
    first: Vec3,
    spacing: Vec3,
}

impl Walls {
    /// The walls that cut `bounds` into so many cells along each axis: whole numbers, at least one.
    pub(super) fn new(bounds: Aabb, cells: Vec3) -> Self {
        let spacing = |min: Real, max: Real, cells: Real| {
            let spacing = (max - min) / cells;
            // The last wall must not lie inside. Three roundings lie between it and the face; where
            // the numbers are too small for a relative error, the next number is enough.
            let is_enough = min + cells * spacing >= max;
            if is_enough { spacing } else { (spacing * (1.0 + 4.0 * Real::EPSILON)).next_up() }
        };
        let (min, max) = (bounds.min, bounds.max);
        let spacing = vec3(
            spacing(min.x, max.x, cells.x),
            spacing(min.y, max.y, cells.y),
            spacing(min.z, max.z, cells.z),
        );
        Walls { first: bounds.min, spacing }
    }

    /// Where the walls of these numbers stand. Whole numbers, which `Real` holds exactly.
    #[inline(always)]
    pub(super) fn at(&self, number: Vec3) -> Vec3 {
        self.first + number * self.spacing
    }

    /// Where number 0 stands, and how far it is from one to the next.
    pub(super) fn first_and_spacing(&self) -> (Vec3, Vec3) {
        (self.first, self.spacing)
    }

    /// About which cells a point lies in, counted like their near walls; not a whole number.
    pub(super) fn about(&self, point: Vec3) -> Vec3 {
        (point - self.first) / self.spacing
    }
}

/// The largest |coordinate| of a box, so that no distance between two of them is infinite.
const FARTHEST_FACE: Real = Real::MAX / 8.0;

/// The box round all boxes but empty ones, and how many those are.
pub(super) fn survey(boxes: &[Aabb]) -> Result<(Aabb, usize), BuildError> {
    let mut all = Aabb::EMPTY;
    let mut count = 0;
    for (aabb, number) in boxes.iter().zip(0..) {
        if *aabb == Aabb::EMPTY {
            continue;
        }
        let is_finite = |v: Vec3| v.to_array().iter().all(|x| x.abs() <= FARTHEST_FACE);
        if !(is_finite(aabb.min) && is_finite(aabb.max)) {
            return Err(BuildError::NotFinite { item: ItemId(number) });
        }
        if !aabb.is_empty() {
            all = all.union(*aabb);
            count += 1;
        }
    }
    Ok((all, count))
}
