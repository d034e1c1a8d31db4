//! Code shared by the tests of strahl.
//!
//! * [`SplitMix64`]: random numbers from a fixed seed, exact in `f32`.
//! * [`TestShape`], [`TestRay`]: shapes and rays whose numbers are exact in `f32`.
//! * [`single::TestScene`], [`double::TestScene`]: owned scenes of both precisions; [`TestedCore`] is their
//!   common interface.
//! * [`oracle`]: intersections in `f64`, computed by methods that differ from the core's.
//! * [`hard`]: rays that are known to go wrong in single precision, and [`textbook`], formulas that fail
//!   there.
//! * [`picture`], [`assert_picture`]: pictures as text.

mod cast;
pub mod double;
pub mod hard;
pub mod oracle;
mod picture;
mod rng;
pub mod single;
mod test_shape;
pub mod textbook;
mod vector;

pub use cast::{CoreHit, TestedCore};
pub use picture::{assert_picture, picture};
pub use rng::{SplitMix64, rounded};
pub use test_shape::{TestRay, TestShape, TestShapeKind};
pub use vector::{DVec3, dvec3};
