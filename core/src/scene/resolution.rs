//! How large a picture is.

/// A picture's width and height in pixels, both at least 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resolution {
    width: u32,
    height: u32,
}

impl Resolution {
    /// The most pixels along one side: places stay exact in single precision, with room for
    /// samples inside a pixel.
    pub const MAX_SIDE: u32 = 1 << 16;

    /// A size; none when a side is 0 or more than [`Resolution::MOST`].
    pub const fn new(width: u32, height: u32) -> Option<Self> {
        if width == 0 || height == 0 || width > Self::MAX_SIDE || height > Self::MAX_SIDE {
            return None;
        }
        Some(Resolution { width, height })
    }

    /// Pixels in a row.
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Rows.
    pub const fn height(self) -> u32 {
        self.height
    }
}
