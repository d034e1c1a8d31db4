//! Rays as lines of text, and what they hit as lines of text.
//!
//! | room | what it does |
//! |---|---|
//! | `lines` | lines of text become rays |
//! | `rows` | answers become lines of text |
//! | `stream` | pieces of text go through all threads, and come out in their order |

mod lines;
mod rows;
mod stream;

pub use stream::{Cast, Stream};
