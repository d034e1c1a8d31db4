//! What both cores can be asked, in numbers that hold the answers of both exactly.

use crate::test_shape::{TestRay, TestShape};
use crate::vector::DVec3;

/// What a core says of the place where a ray meets something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoreHit {
    /// The number of the item.
    pub item: u32,
    /// How far, in lengths of the ray's direction.
    pub t: f64,
    /// The point, moved onto the shape.
    pub point: DVec3,
    /// How far each of its components may be off.
    pub error: DVec3,
    /// The geometric normal.
    pub normal: DVec3,
    /// The shading normal.
    pub shading: DVec3,
}

impl CoreHit {
    /// Whether every number is one.
    pub fn is_finite(&self) -> bool {
        self.t.is_finite()
            && [self.point, self.error, self.normal, self.shading].iter().all(|vector| vector.is_finite())
    }
}

/// One of both cores, with things on its stage.
pub trait TestedCore {
    /// The unit roundoff of its numbers.
    const ROUNDOFF: f64;

    /// The name in messages.
    const NAME: &'static str;

    /// A stage with these things, in their order.
    fn with_shapes(shapes: &[TestShape]) -> Self;

    /// The nearest thing along each ray, by the bare list. The list with boxes must say the
    /// same, to the last bit, or this panics.
    fn cast(&self, rays: &[TestRay]) -> Vec<Option<CoreHit>>;

    /// The place from which a ray leaves the surface to the side of `side`, which is its normal
    /// or the opposite.
    fn offset_origin(hit: &CoreHit, side: DVec3) -> DVec3;
}
