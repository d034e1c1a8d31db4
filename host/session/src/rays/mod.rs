//! Rays as CSV, and their hits as CSV.
//!
//! | module | contents |
//! |---|---|
//! | `parse` | lines of text become rays |
//! | `format` | hits become lines of text |
//! | `stream` | chunks of lines on all threads, written in the order of the input |

mod format;
mod parse;
mod stream;

pub use parse::RayParseError;
pub use stream::{CastCounts, CastError, RayStream};
