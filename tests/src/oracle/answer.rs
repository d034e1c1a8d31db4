//! The oracle's answers, and how exact they are.

use super::measure::length;
use strahl_test_scene::{DVec3, TestRay, TestShape};

/// The oracle's answer for a ray and a shape.
#[derive(Clone, Copy, Debug)]
pub enum OracleAnswer {
    /// The ray misses the shape.
    Miss,
    /// The ray hits the shape.
    Hit(OracleHit),
    /// Rounding decides: hit and miss are both correct.
    Unclear,
}

/// A hit.
#[derive(Clone, Copy, Debug)]
pub struct OracleHit {
    /// Distance, in lengths of the ray's direction.
    pub t: f64,
    /// Distance, in scene lengths.
    pub distance: f64,
    /// Hit point.
    pub point: DVec3,
    /// Unit normal, oriented as the core's shapes document it.
    pub normal: DVec3,
    /// Absolute cosine of the angle between ray and normal.
    pub slope: f64,
    /// Smallest radius of curvature at the hit point.
    pub curvature: f64,
}

/// Error bound of the oracle: a distance may be off by this times [`size`] over the slope.
pub const PRECISION: f64 = 1e-13;

/// Unit roundoff of single precision.
const U: f64 = 1.0 / (1 << 24) as f64;

/// The largest difference that must be formed to intersect ray and shape.
pub fn size(shape: &TestShape, ray: &TestRay) -> f64 {
    let (center, radius) = shape.bounding_sphere();
    let farthest = length(ray.origin - center);
    match shape {
        // The normal is rounded; its error grows with the distance of the hit from the plane's point.
        TestShape::Plane { point, normal } => {
            let t = (*point - ray.origin).dot(*normal) / ray.direction.dot(*normal);
            farthest + length(ray.direction * t)
        }
        // Rounding moves the vertices off the plane.
        TestShape::Polygon { vertices } | TestShape::SmoothPolygon { vertices, .. } => {
            farthest + radius + vertices.iter().copied().map(length).fold(0.0, f64::max)
        }
        _ => farthest + radius,
    }
}

/// Distance from a silhouette or an edge below which hit and miss are both correct.
pub fn band(shape: &TestShape, ray: &TestRay) -> f64 {
    32.0 * U * size(shape, ray)
}
