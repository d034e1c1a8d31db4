//! Single rays and what they hit, whatever precision is computed with.

/// A ray. Any of its numbers may be infinite or NaN: such a ray hits nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayQuery {
    /// Where it starts.
    pub origin: [f64; 3],
    /// Where it goes, of any length.
    pub direction: [f64; 3],
    /// The largest `t` of a hit, in lengths of the direction.
    pub t_max: f64,
}

/// What a ray hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// How far, in lengths of the direction given. It may be out of the range of single precision
    /// where the direction is very long or very short.
    pub t: f64,
    /// The index of the object.
    pub object: u32,
    /// The point.
    pub point: [f64; 3],
    /// The geometric normal, of length one.
    pub normal: [f64; 3],
}

/// Finds the nearest hits of rays, one after the other.
pub type RayCaster<'c> = Box<dyn FnMut(&RayQuery) -> Option<RayHit> + 'c>;
