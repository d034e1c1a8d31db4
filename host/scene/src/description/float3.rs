//! Points, vectors and directions as plain numbers.

use strahl_core::{Vec3, vec3};

/// A point or a direction: x, y and z.
pub type Float3 = [f32; 3];

/// The vector of the core, in single precision.
pub(crate) fn vec3_of([x, y, z]: Float3) -> Vec3 {
    vec3(x, y, z)
}
