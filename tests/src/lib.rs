//! What the tests of strahl share.
//!
//! * [`SplitMix64`]: numbers from a fixed seed, which single precision holds exactly.
//! * [`TestShape`], [`TestRay`]: shapes and rays in numbers that both cores hold exactly.
//! * [`single::TestScene`], [`double::TestScene`]: a scene with tables of its own, for either core; and
//!   [`TestedCore`], what both can be asked.
//! * [`oracle`]: where a ray meets a thing, in `f64`, by other ways than the core's.
//! * [`hard`]: cases in which rounding is known to go wrong, and [`textbook`], the formulas that
//!   do.
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
