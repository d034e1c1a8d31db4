//! How two pictures of one size differ.
//!
//! All measures are differences of sRGB-encoded values in `[0, 1]`, which is what a person sees.
//!
//! | module | what it does |
//! |---|---|
//! | `pair` | two pictures become two of one kind |
//! | `measure` | the measures that look at each pixel by itself |
//! | `ssim` | the measure that looks at structure |

mod measure;
mod pair;
mod ssim;

pub use measure::{Color, Limit, Measures, Peak};
pub use pair::Pair;
