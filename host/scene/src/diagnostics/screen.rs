//! The style of displayed diagnostics.

/// The width and the features of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TerminalStyle {
    /// Characters per line.
    pub width: usize,
    /// The characters and colors that it supports.
    pub features: TerminalFeatures,
}

/// The characters and colors that an output supports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TerminalFeatures {
    /// ASCII.
    Ascii,
    /// ASCII and colors.
    AsciiColor,
    /// Unicode, no colors.
    Unicode,
    /// Unicode and colors.
    UnicodeColor,
}

impl TerminalStyle {
    /// A file or a pipe.
    pub const PLAIN: TerminalStyle = TerminalStyle { width: 80, features: TerminalFeatures::Ascii };
}
