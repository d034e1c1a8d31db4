//! An oracle for ray-shape intersection, in `f64` and by methods that differ from the core's.
//!
//! Solids and curved sides are intersected by sphere tracing: each step along the ray is as long as the
//! distance to the surface, so that no step passes it, and no quadratic or quartic equation is solved. Flat
//! shapes are intersected on their plane; the winding number of the border around the point decides what is
//! inside.
//!
//! Near a silhouette or an edge rounding decides, and hit and miss are both correct. A solid is intersected
//! three times: as it is, grown, and shrunk by the [`band`]. If the three results differ the answer is
//! [`OracleAnswer::Unclear`]. The answer of a flat shape is unclear if the border is within the band around
//! the hit point.
//!
//! Source: Hart, "Sphere Tracing", The Visual Computer 12, 1996.

mod answer;
mod distance;
mod flat;
mod intersect;
mod march;
mod measure;

pub use answer::{OracleAnswer, OracleHit, PRECISION, band, size};
pub use distance::signed_distance;
pub use flat::shading;
pub use intersect::intersect;
