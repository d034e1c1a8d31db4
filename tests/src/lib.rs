//! Code shared by the tests of strahl, above `strahl_test_scene`.
//!
//! * [`oracle`]: intersections in `f64`, computed by methods that differ from the core's.
//! * [`hard`]: rays that are known to go wrong in single precision, and [`textbook`], formulas that fail
//!   there.
//! * [`picture`], [`assert_picture`]: pictures as text.
//! * [`models`]: the models of revolution of `scenes/models`.

pub mod hard;
pub mod models;
pub mod oracle;
mod picture;
pub mod textbook;

pub use picture::{assert_picture, picture};
