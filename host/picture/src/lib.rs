//! Linear pictures of strahl: their digest, files of them, and how two of them differ.
//!
//! Inside, a picture is linear light. Files of eight bits hold it in the encoding of sRGB
//! (IEC 61966-2-1, the exact curve with its straight part, not a power of 2.2), cut off at 0 and
//! 1; OpenEXR holds the linear floats themselves.
//!
//! | module | what it does |
//! |---|---|
//! | [`srgb`] | the encoding |
//! | [`format`](mod@format) | pictures to files |
//! | [`read`] | files to pixels |
//! | [`difference`] | how two pictures differ |
//! | [`color_map`] | differences to colours |
//!
//! This package knows no scene, no setting and no tracer, and reads and writes bytes, never paths.

use rayon::prelude::*;
use strahl_core::{Resolution, Rgb};

pub mod color_map;
pub mod difference;
pub mod format;
pub mod read;
pub mod srgb;

pub use format::{FormatError, PictureFormat};
pub use read::{DecodeError, DecodedPicture, PixelValues, decode};

/// Linear light, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width and height.
    pub size: Resolution,
    /// One colour for each pixel.
    pub colors: Vec<Rgb>,
}

impl Picture {
    /// BLAKE3 of the bits of all channels, row by row, little endian. Equal digests are equal
    /// pictures.
    pub fn digest(&self) -> blake3::Hash {
        let mut hasher = blake3::Hasher::new();
        for row in self.colors.chunks(self.size.width() as usize) {
            let bytes: Vec<u8> =
                row.iter().flat_map(|c| [c.r, c.g, c.b]).flat_map(f32::to_le_bytes).collect();
            hasher.update(&bytes);
        }
        hasher.finalize()
    }

    /// Eight bits for each channel in the sRGB encoding.
    pub fn to_srgb8(&self) -> Vec<u8> {
        self.colors.par_iter().flat_map_iter(|color| color.to_srgb8()).collect()
    }
}
