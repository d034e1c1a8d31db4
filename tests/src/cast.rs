//! What both cores can be asked, in numbers that hold the answers of both exactly.

use crate::thing::{Line, Thing};
use crate::vector::Vector;

/// What a core says of the place where a ray meets something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// The number of the item.
    pub item: u32,
    /// How far, in lengths of the ray's direction.
    pub t: f64,
    /// The point, moved onto the shape.
    pub point: Vector,
    /// How far each of its components may be off.
    pub error: Vector,
    /// The geometric normal.
    pub normal: Vector,
    /// The shading normal.
    pub shading: Vector,
}

impl Found {
    /// Whether every number is one.
    pub fn is_finite(&self) -> bool {
        self.t.is_finite()
            && [self.point, self.error, self.normal, self.shading].iter().all(|vector| vector.is_finite())
    }
}

/// One of both cores, with things on its stage.
pub trait Core {
    /// The unit roundoff of its numbers.
    const ROUNDOFF: f64;

    /// The name in messages.
    const NAME: &'static str;

    /// A stage with these things, in their order.
    fn with(things: &[Thing]) -> Self;

    /// The nearest thing along each ray, by the bare list. The list with boxes must say the
    /// same, to the last bit, or this panics.
    fn cast(&self, rays: &[Line]) -> Vec<Option<Found>>;

    /// The place from which a ray leaves the surface to the side of `side`, which is its normal
    /// or the opposite.
    fn leave(found: &Found, side: Vector) -> Vector;
}
