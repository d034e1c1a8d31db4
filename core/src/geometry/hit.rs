//! What a ray finds: which item and how far, and what its surface is like there.

use super::ItemId;
use crate::math::{Real, Vec3};

/// The nearest item along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// How far, in lengths of the ray's direction. More than zero and finite.
    pub t: Real,
    /// Which.
    pub item: ItemId,
}

/// What a shape is like where a ray meets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point, moved onto the shape as well as its numbers allow.
    pub point: Vec3,
    /// How far each component of `point` may be off the shape, times a small safety, and what is
    /// taken from the step of a ray that leaves it.
    pub error: Vec3,
    /// The geometric normal, of length one: outward for solids, away from the axis for cones,
    /// by the right hand round the corners for triangles and polygons. It decides sides.
    pub normal: Vec3,
    /// The normal that shades, of length one: the geometric one unless the shape is smooth.
    pub shading: Vec3,
}

impl Surface {
    /// A surface that shades with its geometric normal.
    pub(super) fn flat(point: Vec3, error: Vec3, normal: Vec3) -> Self {
        Surface { point, error, normal, shading: normal }
    }
}
