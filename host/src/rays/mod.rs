//! Rays as lines of text, and their way to who knows what they hit.
//!
//! | room | what it does |
//! |---|---|
//! | `lines` | lines of text become rays |
//! | `rows` | answers become lines of text |
//! | `stream` | pieces of text go through all threads, and come out in their order |

mod lines;
mod rows;
mod stream;

pub use lines::Line;
pub use rows::Found;
pub use stream::{Cast, Stream};

/// Why no ray was cast.
pub type NoCast = Box<dyn std::error::Error + Send + Sync>;
