//! Single rays and their hits, independent of the precision.

/// A ray. A ray with infinite or NaN numbers hits nothing; only `t_max` may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayInput {
    /// The origin.
    pub origin: [f64; 3],
    /// The direction, of any length.
    pub direction: [f64; 3],
    /// The largest `t` of a hit, in lengths of the direction.
    pub t_max: f64,
}

/// The nearest hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// The distance in lengths of the given direction. It may exceed the range of single precision if the direction is very
    /// long or very short.
    pub t: f64,
    /// The index of the object.
    pub object: u32,
    /// The hit point.
    pub point: [f64; 3],
    /// The geometric unit normal, not turned towards the ray.
    pub normal: [f64; 3],
}

/// Finds the nearest hit of a ray; `None` for a miss.
pub type RayCaster<'c> = Box<dyn FnMut(&RayInput) -> Option<RayHit> + 'c>;
