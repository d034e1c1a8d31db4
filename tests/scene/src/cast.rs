//! Ray queries to either core, with results in `f64`, which is exact for both.

use crate::test_shape::{TestRay, TestShape};
use crate::vector::DVec3;

/// Hit of a core, with its surface interaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoreHit {
    /// Id of the item.
    pub item: u32,
    /// Distance, in lengths of the ray's direction.
    pub t: f64,
    /// Hit point, projected onto the shape.
    pub point: DVec3,
    /// Bound of the absolute error of each component of `point`.
    pub error: DVec3,
    /// Geometric normal.
    pub normal: DVec3,
    /// Shading normal.
    pub shading: DVec3,
}

impl CoreHit {
    /// Whether all numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.t.is_finite()
            && [self.point, self.error, self.normal, self.shading].iter().all(|vector| vector.is_finite())
    }
}

/// A scene of one of the two cores, for ray queries.
pub trait TestedCore {
    /// Unit roundoff of the core's `Real`.
    const ROUNDOFF: f64;

    /// Name of the precision in messages.
    const NAME: &'static str;

    /// A scene of these shapes, in this order.
    fn with_shapes(shapes: &[TestShape]) -> Self;

    /// Nearest hit of each ray, found by the list without bounds.
    ///
    /// # Panics
    ///
    /// If the list with bounding boxes finds anything else, compared bit by bit.
    fn cast(&self, rays: &[TestRay]) -> Vec<Option<CoreHit>>;

    /// Origin of a ray that leaves the surface on the side of `side`, which is the normal of the hit or its
    /// opposite.
    fn offset_origin(hit: &CoreHit, side: DVec3) -> DVec3;
}
