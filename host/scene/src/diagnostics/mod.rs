//! Diagnostics: all errors of a text at once, each with its location, displayed with source excerpts.
//!
//! The text is untrusted. Control and bidirectional characters are replaced by characters of the same length, and a line
//! that is longer than the terminal is clipped around the error.

mod diagnostic;
mod lines;
mod list;
mod screen;
mod show;
mod visible;

pub use diagnostic::Diagnostic;
pub use lines::LineIndex;
pub use list::Diagnostics;
pub use screen::{TerminalFeatures, TerminalStyle};
