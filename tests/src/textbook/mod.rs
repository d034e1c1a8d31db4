//! The textbook's formulas in single precision, for comparison with the core's numerically stable ones.
//!
//! They are those of introductions and small ray tracers, correct in exact arithmetic and unprotected against
//! rounding. Only the tests use them: they run them through the same checks as the core and expect them to
//! fail.

// Not the core: the platform's square root is correctly rounded as well.
#![allow(clippy::disallowed_methods)]

pub mod accelerators;
mod intersect;
mod roots;
mod shape;

pub use intersect::slabs;
pub use shape::TextbookShape;

use strahl_core::Vec3;
use strahl_test_scene::DVec3;

/// A hit by the textbook's formula.
#[derive(Clone, Copy, Debug)]
pub struct TextbookHit {
    /// Distance, in lengths of the ray's direction.
    pub t: f32,
    /// Normal at the hit point.
    pub normal: Vec3,
}

/// A determinant or a cosine below this counts as zero.
const EPSILON: f32 = 1e-6;

/// Fixed offset of a ray origin from the surface, in scene lengths.
pub const OFFSET: f32 = 1e-4;

fn narrow(v: DVec3) -> Vec3 {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}

/// Moves a ray origin off the surface by [`OFFSET`] on the side of `normal`.
pub fn offset_origin(point: Vec3, normal: Vec3) -> Vec3 {
    point + normal * OFFSET
}

/// Direction of the refracted ray, and the Fresnel reflectance.
pub fn refracted(d: Vec3, n: Vec3, ratio: f32) -> (Vec3, f32) {
    let cos = -d.dot(n);
    let cos_behind = (1.0 - ratio * ratio * (1.0 - cos * cos)).sqrt();
    let across = (ratio * cos - cos_behind) / (ratio * cos + cos_behind);
    let along = (cos - ratio * cos_behind) / (cos + ratio * cos_behind);
    (d * ratio + n * (ratio * cos - cos_behind), 0.5 * (across * across + along * along))
}
