//! One error in a text.

use std::ops::Range;

/// An error in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The error message.
    pub message: String,
    /// Its location, in bytes of the text.
    pub span: Range<usize>,
    /// Advice, if any.
    pub help: Option<String>,
    /// A related location, with a label.
    pub related: Option<(Range<usize>, String)>,
}

impl Diagnostic {
    /// An error at a location.
    pub fn new(span: Range<usize>, message: impl Into<String>) -> Self {
        Diagnostic { message: message.into(), span, help: None, related: None }
    }

    /// Adds advice.
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Adds a related location with a label.
    pub fn with_related(mut self, span: Range<usize>, what: impl Into<String>) -> Self {
        self.related = Some((span, what.into()));
        self
    }
}
