//! What is wrong in a text: all of it at once, each with its place, shown as a compiler would.
//!
//! The text is another's. What could steer a terminal is shown as a harmless character of the
//! same length, and a line that is longer than the screen is cut to the part in question.

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
