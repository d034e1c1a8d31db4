//! The planes that divide space into equal cells, and the proof that no item is lost between cells.
//!
//! Traversals of grid and octree ask for one number only: the `t` of a cell plane. It is computed exactly as
//! in the slab test ([`Aabb::intersect`]): subtract the origin, multiply by the reciprocal of the direction.
//! Each of these operations is monotone in floating point. So of a cell plane and a face of a box, the one that
//! comes first along the ray in space has the smaller computed `t`, or both are equal, and bounds need no
//! margin when they are sorted into cells. The slab test does one thing more: it multiplies the exit of its
//! interval by [`WIDEN`]. So a traversal visits every cell whose own interval is not empty *after the same
//! widening*:
//!
//! > Let the cell planes enclose the bounds of all items, and let the slab test return an interval that
//! > begins at `t_entry` for the bounds of an item. Then one of the cells that the bounds overlap begins, by
//! > its own planes, at or before `t_entry` and ends, after widening, at or after it.
//!
//! Proof, for each axis, in the direction of the ray. Let `t` be `t_entry`, or zero if that is larger. Of the
//! cells that the bounds overlap, take the last one whose near plane is not beyond `t`. There is one, because
//! the first of them begins before the bounds do. If it is not the last of all, the near plane of the next
//! one, which is its own far plane, is beyond `t`. If it is the last, its far plane is beyond the far face of
//! the bounds, whose widened `t` is at least `t`, or else the slab test would have reported a miss. So one
//! cell serves all three axes at once. Hits are never reported before `t_entry`, so a traversal that leaves
//! out only what begins strictly beyond `t_max` has passed the item to the query before it ends.
//!
//! A ray that is parallel to the planes of an axis has an infinite reciprocal there. It stays between two
//! planes, and so do the faces of the bounds that it hits; but it may lie in a plane and hit bounds that
//! touch the plane from either side. A grid therefore lists an item in the cells on both sides of a plane
//! that its bounds touch. An octree, whose planes often coincide with faces, lists the item on its own side
//! and traverses such a ray twice.
//!
//! [`Aabb::intersect`]: crate::geometry::Aabb::intersect
//! [`WIDEN`]: crate::geometry::WIDEN

use super::BuildError;
use crate::geometry::{Aabb, ItemId, MAX_FACE_COORDINATE};
use crate::math::{Real, Vec3, vec3};

/// Equally spaced planes perpendicular to each axis.
///
/// Plane 0 of an axis contains the lower face of the divided box. The last plane contains the upper face or,
/// by rounding, is slightly outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CellPlanes {
    first: Vec3,
    spacing: Vec3,
}

impl CellPlanes {
    /// The planes that divide `bounds` into `cells` cells along each axis: integers, at least one.
    pub(super) fn new(bounds: Aabb, cells: Vec3) -> Self {
        let spacing = |min: Real, max: Real, cells: Real| {
            let spacing = (max - min) / cells;
            // The last plane must not be inside. Three roundings separate it from the face; where the numbers
            // are too small for a relative error, the next larger number is enough.
            let is_enough = min + cells * spacing >= max;
            if is_enough { spacing } else { (spacing * (1.0 + 4.0 * Real::EPSILON)).next_up() }
        };
        let (min, max) = (bounds.min, bounds.max);
        let spacing = vec3(
            spacing(min.x, max.x, cells.x),
            spacing(min.y, max.y, cells.y),
            spacing(min.z, max.z, cells.z),
        );
        CellPlanes { first: bounds.min, spacing }
    }

    /// World coordinates of the planes with these indices, per axis. `index`: integers.
    #[inline(always)]
    pub(super) fn position(&self, index: Vec3) -> Vec3 {
        self.first + index * self.spacing
    }

    /// World coordinates of plane 0, and the distance between neighboring planes, per axis.
    pub(super) fn first_and_spacing(&self) -> (Vec3, Vec3) {
        (self.first, self.spacing)
    }

    /// Approximate position of a point in units of cells; its integer part estimates the index of the cell.
    pub(super) fn fractional_index(&self, point: Vec3) -> Vec3 {
        (point - self.first) / self.spacing
    }
}

/// Union of the bounds of all items, and the number of items whose bounds are not empty.
///
/// # Errors
///
/// [`BuildError::NotFinite`] for a coordinate that is NaN or above [`MAX_FACE_COORDINATE`].
pub(super) fn bounds_of_all(bounds: &[Aabb]) -> Result<(Aabb, usize), BuildError> {
    let mut union = Aabb::EMPTY;
    let mut count = 0;
    for (aabb, index) in bounds.iter().zip(0..) {
        if *aabb == Aabb::EMPTY {
            continue;
        }
        let is_finite = |v: Vec3| v.to_array().iter().all(|x| x.abs() <= MAX_FACE_COORDINATE);
        if !(is_finite(aabb.min) && is_finite(aabb.max)) {
            return Err(BuildError::NotFinite { item: ItemId(index) });
        }
        if !aabb.is_empty() {
            union = union.union(*aabb);
            count += 1;
        }
    }
    Ok((union, count))
}
