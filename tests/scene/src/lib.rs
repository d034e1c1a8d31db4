//! Scenes, shapes and rays for tests of both cores.
//!
//! * `SplitMix64`: random numbers from a fixed seed, exact in `f32`.
//! * [`TestShape`], [`TestRay`]: shapes and rays whose numbers are exact in `f32`.
//! * [`TestScene`]: an owned scene of `strahl-core`. `strahl-test-scene-double` compiles the same sources for
//!   `strahl-core-double`; [`TestedCore`] is their common interface.

#[cfg(not(feature = "double"))]
mod cast;
#[cfg(not(feature = "double"))]
mod rng;
mod test_scene;
#[cfg(not(feature = "double"))]
mod test_shape;
#[cfg(not(feature = "double"))]
pub mod vector;

#[cfg(not(feature = "double"))]
pub use cast::{CoreHit, TestedCore};
#[cfg(not(feature = "double"))]
pub use rng::{SplitMix64, rounded};
pub use test_scene::TestScene;
#[cfg(not(feature = "double"))]
pub use test_shape::{TestRay, TestShape, TestShapeKind};
#[cfg(not(feature = "double"))]
pub use vector::{DVec3, dvec3};

#[cfg(feature = "double")]
use strahl_test_scene::{CoreHit, DVec3, TestRay, TestShape, TestedCore, dvec3};
