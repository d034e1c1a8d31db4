//! Linear pictures of strahl: picture files, digests, and measures of difference.
//!
//! A [`Picture`] is linear light. 8-bit files hold it in sRGB encoding (IEC 61966-2-1, with the exact curve and its linear
//! segment, not a power of 2.2), clamped to 0 and 1; OpenEXR holds the linear floats.
//!
//! ```
//! use strahl_core::{Resolution, Rgb};
//! use strahl_picture::{Picture, PictureFormat, PixelValues, decode};
//!
//! let size = Resolution::new(2, 1).unwrap();
//! let picture = Picture { size, colors: vec![Rgb::BLACK, Rgb::WHITE] };
//! let file = PictureFormat::Png.encode(&picture)?;
//! let decoded = decode(&file, 100)?;
//! assert_eq!(decoded.values, PixelValues::U8(vec![[0; 3], [255; 3]]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | contents |
//! |---|---|
//! | [`srgb`] | sRGB encoding |
//! | [`format`](mod@format) | encoding of picture files |
//! | [`read`] | decoding of picture files |
//! | [`difference`] | measures of difference of two pictures |
//! | [`color_map`] | color map of difference maps |
//!
//! The package has no scenes, settings or ray tracer. It reads and writes bytes, never files.

use rayon::prelude::*;
use strahl_core::{Resolution, Rgb};

pub mod color_map;
pub mod difference;
pub mod format;
pub mod read;
pub mod srgb;

pub use format::{FormatError, PictureFormat};
pub use read::{DecodeError, DecodedPicture, PixelValues, decode};

/// A picture in linear light.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width and height.
    pub size: Resolution,
    /// One color for each pixel, row by row.
    pub colors: Vec<Rgb>,
}

impl Picture {
    /// The BLAKE3 hash of the bits of all channels, row by row, little endian. Pictures are bit-identical if their
    /// digests are equal.
    pub fn digest(&self) -> blake3::Hash {
        let mut hasher = blake3::Hasher::new();
        for row in self.colors.chunks(self.size.width() as usize) {
            let bytes: Vec<u8> =
                row.iter().flat_map(|c| [c.r, c.g, c.b]).flat_map(f32::to_le_bytes).collect();
            hasher.update(&bytes);
        }
        hasher.finalize()
    }

    /// The pixels in 8-bit sRGB encoding, three bytes each.
    pub fn to_srgb8(&self) -> Vec<u8> {
        self.colors.par_iter().flat_map_iter(|color| color.to_srgb8()).collect()
    }
}
