//! Which pixels of a picture are wanted, where not all are.

use strahl_core::image::Pixel;
use strahl_core::{Resolution, Tile};

/// Some pixels of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mask {
    /// Width and height of the picture.
    pub size: Resolution,
    /// Row by row, whether it is one of them.
    pub pixels: Vec<bool>,
}

impl Mask {
    /// Whether a pixel is one of them.
    pub fn has(&self, pixel: Pixel) -> bool {
        Tile::full(self.size).index_of(pixel).is_some_and(|place| self.pixels[place])
    }
}
