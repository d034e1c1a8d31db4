//! Width and height of a picture.

/// Width and height of a picture in pixels, both in `1..=`[`Resolution::MAX_SIDE`].
///
/// ```
/// use strahl_core::Resolution;
///
/// let resolution = Resolution::new(320, 240).unwrap();
/// assert_eq!((resolution.width(), resolution.height()), (320, 240));
/// assert_eq!(Resolution::new(0, 240), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resolution {
    width: u32,
    height: u32,
}

impl Resolution {
    /// Largest width and height. Film points stay exact in single precision, with bits left for samples
    /// inside a pixel.
    pub const MAX_SIDE: u32 = 1 << 16;

    /// The resolution of `width` times `height` pixels; `None` if one of them is 0 or more than
    /// [`Resolution::MAX_SIDE`].
    pub const fn new(width: u32, height: u32) -> Option<Self> {
        if width == 0 || height == 0 || width > Self::MAX_SIDE || height > Self::MAX_SIDE {
            return None;
        }
        Some(Resolution { width, height })
    }

    /// Number of pixels in a row.
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Number of rows.
    pub const fn height(self) -> u32 {
        self.height
    }
}
