//! Measures of difference of two pictures of one size.
//!
//! All measures are of sRGB-encoded values in `[0, 1]`, which are closer to perception than linear light.
//!
//! | module | contents |
//! |---|---|
//! | `pair` | conversion of two pictures to the same type |
//! | `measure` | measures of single pixels: largest difference, sums for RMSE and PSNR, counts |
//! | `ssim` | structural similarity |

mod measure;
mod pair;
mod ssim;

pub use measure::{Color, Limit, Measures, Peak};
pub use pair::Pair;
