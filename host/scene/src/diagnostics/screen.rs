//! What diagnostics are drawn on.

/// What is drawn on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Screen {
    /// Characters in a row.
    pub width: usize,
    /// What it can show.
    pub drawing: Drawing,
}

/// What a screen can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawing {
    /// ASCII.
    Plain,
    /// ASCII and colours.
    PlainColors,
    /// Lines, but no colours.
    Lines,
    /// Lines and colours.
    Colors,
}

impl Screen {
    /// A file or a pipe.
    pub const PLAIN: Screen = Screen { width: 80, drawing: Drawing::Plain };
}
