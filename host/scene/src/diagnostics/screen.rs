//! What diagnostics are drawn on.

/// What is drawn on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TerminalStyle {
    /// Characters in a row.
    pub width: usize,
    /// What it can show.
    pub features: TerminalFeatures,
}

/// What a screen can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TerminalFeatures {
    /// ASCII.
    Ascii,
    /// ASCII and colours.
    AsciiColor,
    /// Lines, but no colours.
    Unicode,
    /// Lines and colours.
    UnicodeColor,
}

impl TerminalStyle {
    /// A file or a pipe.
    pub const PLAIN: TerminalStyle = TerminalStyle { width: 80, features: TerminalFeatures::Ascii };
}
