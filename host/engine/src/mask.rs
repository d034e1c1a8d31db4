//! A mask of pixels.

use strahl_core::image::Pixel;
use strahl_core::{Resolution, Tile};

/// A subset of the pixels of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mask {
    /// Width and height of the picture.
    pub size: Resolution,
    /// Whether each pixel is in the mask, row by row.
    pub pixels: Vec<bool>,
}

impl Mask {
    /// Whether a pixel is in the mask.
    pub fn contains(&self, pixel: Pixel) -> bool {
        Tile::full(self.size).index_of(pixel).is_some_and(|index| self.pixels[index])
    }
}
