//! What the tests of strahl share.
//!
//! * [`Random`]: numbers from a fixed seed, which single precision holds exactly.
//! * [`Thing`], [`Line`]: shapes and rays in numbers that both cores hold exactly.
//! * [`single::Stage`], [`double::Stage`]: a scene with tables of its own, for either core; and
//!   [`Core`], what both can be asked.
//! * [`oracle`]: where a ray meets a thing, in `f64`, by other ways than the core's.
//! * [`hard`]: cases in which rounding is known to go wrong, and [`textbook`], the formulas that
//!   do.
//! * [`picture`], [`assert_picture`]: pictures as text.

mod cast;
pub mod double;
pub mod hard;
pub mod oracle;
mod picture;
mod random;
pub mod single;
pub mod textbook;
mod thing;
mod vector;

pub use cast::{Core, Found};
pub use picture::{assert_picture, picture};
pub use random::{Random, rounded};
pub use thing::{Kind, Line, Thing};
pub use vector::{Vector, vector};
